#pragma once
// A thread that draws verbatim fragments, so that slow ones do not stop the window.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "editor/gl/fragment_raster.h"

namespace rinceau {

struct FragmentPixels {
    FragmentPlace place;
    std::optional<TransparentPicture> pixels;  ///< nothing if the fragment cannot be drawn
};

class FragmentWorker {
  public:
    FragmentWorker();

    /// What is to be drawn from now on, the first first; what was asked for before and has not been begun is forgotten.
    void want(std::vector<FragmentPlace> places);
    /// What has been drawn since.
    std::vector<FragmentPixels> take();
    /// Returns when there is something to take, or after so long.
    void wait(std::chrono::milliseconds longest);

  private:
    void work(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any wake_, ready_;
    std::vector<FragmentPlace> wanted_;  ///< the first last
    std::vector<FragmentPixels> drawn_;
    std::jthread thread_;  ///< last: ends before what it uses
};

}  // namespace rinceau

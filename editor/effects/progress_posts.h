#pragma once
// Progress as often as an eye follows.

#include <chrono>
#include <string>
#include <string_view>

namespace rinceau {

/// Which of many reports of progress are worth a frame: the first of a stage, and one every 50 ms.
class ProgressPosts {
  public:
    bool worth(std::string_view stage, std::chrono::steady_clock::time_point now);

  private:
    std::string stage_;
    std::chrono::steady_clock::time_point last_;
    bool begun_ = false;
};

}  // namespace rinceau

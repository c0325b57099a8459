#pragma once
// One line on the terminal for work that takes a while.

#include <chrono>
#include <string_view>

#include "geometry/progress.h"

namespace rinceau {

/// Shows a bar on standard error if that is a terminal and half a second has passed; nothing otherwise. The line is wiped
/// when the bar dies.
class ProgressBar {
  public:
    ProgressBar();
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// For the functions that report progress; the bar must outlive it.
    Progress callback();

    /// Takes the line away, for another to stand there; the bar comes back when there is progress.
    void wipe();

  private:
    void show(std::string_view stage, double fraction);

    using Clock = std::chrono::steady_clock;
    bool on_terminal_;
    bool shown_ = false;
    Clock::time_point next_;  ///< not before this time
};

}  // namespace rinceau

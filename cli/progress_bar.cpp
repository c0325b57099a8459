#include "cli/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace rinceau {
namespace {
constexpr std::chrono::milliseconds first_after{500};  // shorter work shows nothing
constexpr std::chrono::milliseconds then_every{100};
constexpr int bar_width = 30;
constexpr const char* wipe_line = "\r\033[K";
}  // namespace

ProgressBar::ProgressBar() : on_terminal_(::isatty(STDERR_FILENO) != 0), next_(Clock::now() + first_after) {}

ProgressBar::~ProgressBar() { wipe(); }

void ProgressBar::wipe() {
    if (shown_) std::fputs(wipe_line, stderr);
    shown_ = false;
}

Progress ProgressBar::callback() {
    if (!on_terminal_) return {};
    return [this](std::string_view stage, double fraction) { show(stage, fraction); };
}

void ProgressBar::show(std::string_view stage, double fraction) {
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + then_every;
    shown_ = true;
    const double share = std::clamp(fraction, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(share * bar_width);
    const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
    std::fprintf(stderr, "%s[%s] %3d %%  %.*s", wipe_line, bar.c_str(), static_cast<int>(share * 100),
                 static_cast<int>(stage.size()), stage.data());
    std::fflush(stderr);
}

}  // namespace rinceau

#include "editor/effects/progress_posts.h"

namespace rinceau {

bool ProgressPosts::worth(std::string_view stage, std::chrono::steady_clock::time_point now) {
    constexpr std::chrono::milliseconds between{50};
    if (begun_ && stage == stage_ && now - last_ < between) return false;
    begun_ = true;
    stage_ = stage;
    last_ = now;
    return true;
}

}  // namespace rinceau

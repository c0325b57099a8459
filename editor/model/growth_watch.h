#pragma once
// How long growth is watched and ended from outside.

#include <functional>

#include "editor/model/grown_pattern.h"

namespace rinceau {

struct GrowthWatch {
    std::function<bool()> stop;              ///< true: what stands by then is the result; empty = never
    std::function<bool()> wants_look;        ///< is it time to show what stands? Empty = never
    std::function<void(GrownPattern)> show;  ///< called after wants_look() said so
    Progress progress;                       ///< may throw: then there is no result
};

}  // namespace rinceau

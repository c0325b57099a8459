#pragma once
// What an arrangement is to do, step by step, and the strokes that guide it.

#include <cstddef>
#include <variant>
#include <vector>

#include "geometry/point.h"

namespace rinceau {

/// Everything below a round brush grows.
struct SprayStep {
    Point center;
    double radius = 0;
    bool plants = false;  ///< a first element may stand at the centre if nothing stands near
};
/// So many elements more; 0 = until no more can grow.
struct GrowStep {
    std::size_t more = 0;
};
/// The whole is relaxed; `repair`: and repaired, if the exemplar is irregular.
struct FinishStep {
    bool repair = true;
};
/// What stands is shown with other jitter.
struct ShowStep {};
using ArrangeStep = std::variant<SprayStep, GrowStep, FinishStep, ShowStep>;

/// A line that was drawn on the canvas (growth/strokes.h: Polyline).
using DrawnStroke = std::vector<Point>;

struct GuideLines {
    std::vector<DrawnStroke> flow;
    std::vector<DrawnStroke> boundary;
};

}  // namespace rinceau

#include "growth/surface/placed_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/angle.h"

namespace rinceau {

namespace {

/// Of the rotation between two frames, in degrees.
double turn_between(const std::array<SpacePoint, 3>& a, const std::array<SpacePoint, 3>& b) {
    const double trace = dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]);
    return degrees(std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)));
}

constexpr double turn_rounding = 1e-6;  // degrees: near 0 and 180 the cosine tells no less

}  // namespace

PlacedShapes::PlacedShapes(const std::vector<GrammarShape>& shapes, std::vector<bool> sought, bool collisions, double touch)
    : shapes_(&shapes),
      sought_(std::move(sought)),
      collisions_(collisions),
      space_(CollisionOptions{touch}),
      counts_(shapes.size()),
      of_name_(shapes.size()) {}

CollisionBody PlacedShapes::body_of(const PatternShape& shape, const ScopeFrame& frame) const {
    return collision_body((*shapes_)[static_cast<std::size_t>(shape.shape)], shape.position, shape.axes, shape.size,
                          frame.normal, frame.lift);
}

bool PlacedShapes::overlaps(const PatternShape& shape, const ScopeFrame& frame, std::span<const int> kin, int end) const {
    const std::optional<int> first = space_.overlap(body_of(shape, frame), kin);
    return first && *first < end;
}

int PlacedShapes::add(PatternShape shape, const ScopeFrame& frame, const ShapeScope& scope) {
    const int number = size();
    const auto name = static_cast<std::size_t>(shape.shape);
    if (collisions_) space_.add(body_of(shape, frame));
    if (sought_[name]) {
        of_name_[name].points.add(shape.position);
        of_name_[name].placed.push_back(number);
        of_name_[name].scopes.push_back(scope);
        of_name_[name].scopes.back().chart.reset();  // may be large
    }
    ++counts_[name];
    placed_.push_back(std::move(shape));
    return number;
}

void PlacedShapes::remove_from(int first) {
    while (size() > first) {
        const auto name = static_cast<std::size_t>(placed_.back().shape);
        if (sought_[name]) {
            of_name_[name].points.remove_last();
            of_name_[name].placed.pop_back();
            of_name_[name].scopes.pop_back();
        }
        --counts_[name];
        placed_.pop_back();
    }
    if (collisions_) space_.remove_from(first);
}

double PlacedShapes::distance(int shape, SpacePoint p, int except) const {
    const OfName& name = of_name_[static_cast<std::size_t>(shape)];
    const auto found = std::ranges::lower_bound(name.placed, except);
    const int index = found != name.placed.end() && *found == except ? static_cast<int>(found - name.placed.begin()) : -1;
    const auto nearest = name.points.nearest(p, index);
    return nearest ? nearest->distance : std::numeric_limits<double>::infinity();
}

std::optional<PlacedShapes::Twin> PlacedShapes::twin(int shape, const ScopeFrame& frame, double distance,
                                                     double degrees) const {
    const OfName& name = of_name_[static_cast<std::size_t>(shape)];
    std::optional<int> best;
    double best_distance = 0;
    for (const int index : name.points.within(frame.position, distance)) {
        const auto number = static_cast<std::size_t>(name.placed[static_cast<std::size_t>(index)]);
        if (turn_between(placed_[number].axes, frame.axes) > degrees + turn_rounding) continue;
        const double away = abs(name.points[index] - frame.position);
        if (best && away >= best_distance) continue;
        best = index;
        best_distance = away;
    }
    if (!best) return std::nullopt;
    return Twin{name.placed[static_cast<std::size_t>(*best)], &name.scopes[static_cast<std::size_t>(*best)]};
}

}  // namespace rinceau

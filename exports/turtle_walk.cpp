#include "exports/turtle_walk.h"

#include "geometry/angle.h"

namespace rinceau {

std::vector<WalkStep> walk_along(const std::vector<Point>& corners) {
    std::vector<WalkStep> steps;
    Point at{};
    double heading = pi / 2;
    for (const Point corner : corners) {
        const Point way = corner - at;
        const double length = abs(way);
        if (length > 0) {
            const double towards = arg(way);
            steps.push_back({degrees(wrap_angle(towards - heading)), length});
            heading = towards;
        } else if (steps.empty()) {
            steps.push_back({0, 0});
        }
        at = corner;
    }
    return steps;
}

}  // namespace rinceau

#include "growth/surface/surface_turtle.h"

namespace rinceau {

std::optional<DrawingStand> moved(const SurfaceMesh& surface, const TurtleWays& ways, const DrawingStand& from, Point to) {
    const Point way = to - from.drawn;
    const double length = abs(way);
    if (!(length > 0)) return DrawingStand{from.at, from.turn, to};
    const Complex direction = (way / length) * from.turn;
    TraceOptions options;
    options.follow = ways.follow;
    const SurfaceTrace walk =
        trace(surface, ways.follow > 0 ? ways.field : nullptr, from.at, direction, ways.scale * length, options);
    if (walk.at_border) return std::nullopt;
    const Complex turn = carried(from.turn, direction, walk);
    return DrawingStand{walk.end, turn / abs(turn), to};
}

bool SurfaceTurtle::move(Point to) {
    if (stopped_) return false;
    const std::optional<DrawingStand> next = moved(*surface_, ways_, stand_, to);
    if (next) {
        stand_ = *next;
    } else {
        stop();
    }
    return next.has_value();
}

void SurfaceTurtle::pop() {
    stand_ = stack_.back().stand;
    stopped_ = stack_.back().stopped;
    stack_.pop_back();
}

}  // namespace rinceau

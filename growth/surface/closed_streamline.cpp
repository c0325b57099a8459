// The line is walked in pieces shorter than the nearness that is asked for. The piece that comes back is cut where nothing
// lies between it and the start along the line; what lies sideways is the gap, and each place of the row is moved sideways
// by its share of it, so that the last joins the first as all others join.

#include "growth/surface/closed_streamline.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace rinceau {
namespace {

constexpr double default_longest = 10;  // diagonals
constexpr double piece_share = 0.5;     // of the nearness
constexpr double sheets_agree = 0.3;    // cosine between normals: not the other side of a thin sheet
constexpr double rounding = 1e-3;       // of a piece
constexpr double least_way = 0.5;       // of a piece: a walk that is shorter is caught in a singular point
constexpr int most_corrections = 5;     // of the length, each by what is left to the start

/// Length and gap of a line that came back.
struct WayRound {
    double length = 0, gap = 0;
};

/// The start of a line, in space, with a tangent plane that does not turn from face to face.
struct StartInSpace {
    SpacePoint origin, normal, ahead, left;

    StartInSpace(const SurfaceMesh& surface, SurfacePoint start, Complex direction)
        : origin(position_in_space(surface, start)), normal(normal_at(surface, start)) {
        ahead = in_plane(direction_in_space(surface, start.face, direction));
        left = cross(normal, ahead);
    }
    SpacePoint in_plane(SpacePoint direction) const { return unit(direction - dot(direction, normal) * normal); }
};

std::optional<WayRound> way_round(const SurfaceMesh& surface, const FieldOnSurface* field, RowPlace start, double nearest,
                                  double longest, double turn) {
    const StartInSpace from(surface, start.at, start.direction);
    const double piece = std::min(piece_share * nearest, surface.longest_edge), most_turn = std::cos(radians(turn));
    RowPlace here = start;
    for (double walked = 0; walked < longest;) {
        SurfaceTrace walk = trace(surface, field, here.at, here.direction, piece);
        if (walk.at_border || walk.length < least_way * piece) return std::nullopt;
        SpacePoint off = position_in_space(surface, walk.end) - from.origin;
        // the piece that passes the start, which lies at most half a piece behind or ahead of its end
        bool passes = abs(off) <= nearest && std::abs(dot(off, from.ahead)) <= piece * (0.5 + rounding) &&
                      dot(normal_at(surface, walk.end), from.normal) > sheets_agree;
        if (passes) {
            double length = piece;
            for (int round = 0; round < most_corrections && !walk.at_border; ++round) {
                length = std::max(0.0, length - dot(off, from.ahead));
                walk = trace(surface, field, here.at, here.direction, length);
                off = position_in_space(surface, walk.end) - from.origin;
            }
            const SpacePoint way = direction_in_space(surface, walk.end.face, walk.direction);
            passes = dot(from.in_plane(way), from.ahead) >= most_turn && abs(off) <= nearest;
            if (passes) return WayRound{walked + walk.length, dot(off, from.left)};
            walk = trace(surface, field, here.at, here.direction, piece);
        }
        here = {walk.end, walk.direction};
        walked += walk.length;
    }
    return std::nullopt;
}

}  // namespace

std::optional<ClosedRow> closed_row(const SurfaceMesh& surface, const FieldOnSurface* field, SurfacePoint start,
                                    Complex direction, double step, const ClosedRowOptions& options) {
    const double longest =
        std::min(options.longest > 0 ? options.longest : default_longest * surface.diagonal, step * options.max_elements);
    const auto round = way_round(surface, field, {start, direction}, options.nearest * step, longest, options.turn);
    if (!round) return std::nullopt;
    const int count = std::max(1, static_cast<int>(std::lround(round->length / step)));
    ClosedRow row{round->length, round->gap, round->length / count, {}};
    SurfacePoint here = start;
    Complex way = direction;
    for (int i = 0; i < count; ++i) {
        const double back = -row.gap * i / count;  // to the left
        const SurfaceTrace aside = trace(surface, nullptr, here, way * Complex{0, back < 0 ? -1.0 : 1.0}, std::abs(back));
        row.places.push_back({aside.end, aside.direction * Complex{0, back < 0 ? 1.0 : -1.0}});
        const SurfaceTrace walk = trace(surface, field, here, way, row.step);
        here = walk.end, way = walk.direction;
    }
    return row;
}

}  // namespace rinceau

// GJK on the difference of the two bodies: the simplex of support points that is nearest to the origin. It ends with an axis
// that separates them or with a simplex about the origin. Both bodies are shrunk by a billionth first, so that touching ones
// are apart and a simplex that meets the origin means overlap.

#include "growth/surface/convex_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rinceau {
namespace {

constexpr double touching = 1e-9;       // of the size
constexpr double meets_origin = 1e-12;  // of the size
constexpr int max_rounds = 64;          // smooth rims close in by a factor a round; polygons end by themselves

struct Simplex {
    std::array<SpacePoint, 4> points;
    int count = 0;
};

/// Farthest along (x, y) in the plane of axes 0 and 1, from the centre.
Point farthest_of_hull(const CollisionBody& body, Point along) {
    const Point scaled{along.x * body.outline_scale.x, along.y * body.outline_scale.y};
    const Point* best = &body.hull.front();
    double far = dot(*best, scaled);
    for (const Point& p : body.hull)
        if (dot(p, scaled) > far) {
            far = dot(p, scaled);
            best = &p;
        }
    return Point{best->x * body.outline_scale.x, best->y * body.outline_scale.y} + body.outline_shift;
}

/// Farthest along d of an ellipse swept by an ellipsoid: in units of the half lengths a disc of radius 1 - rim, widened by a
/// ball that is rim wide and 1 high.
SpacePoint farthest_of_disc(const CollisionBody& body, SpacePoint d) {
    const Point flat{d.x * body.half.x, d.y * body.half.y};
    const double up = d.z * body.half.z;
    const double sideways = abs(flat), q = body.rim;
    Point at{};
    double height = up > 0 ? 1 : -1;
    if (sideways > 0) at = ((1 - q) / sideways) * flat;
    const double swept = std::hypot(q * sideways, up);
    if (q > 0 && swept > 0) {
        at += (q * q / swept) * flat;
        height = up / swept;
    }
    return {at.x * body.half.x, at.y * body.half.y, height * body.half.z};
}

SpacePoint support(const CollisionBody& body, double shrink, SpacePoint direction) {
    const SpacePoint d{dot(direction, body.axes[0]), dot(direction, body.axes[1]), dot(direction, body.axes[2])};
    SpacePoint far{d.x > 0 ? body.half.x : -body.half.x, d.y > 0 ? body.half.y : -body.half.y,
                   d.z > 0 ? body.half.z : -body.half.z};
    if (body.collide == CollideAs::disc) far = farthest_of_disc(body, d);
    if (body.collide == CollideAs::hull) {
        const Point p = farthest_of_hull(body, {d.x, d.y});
        far.x = p.x;
        far.y = p.y;
    }
    return body.centre + shrink * (far.x * body.axes[0] + far.y * body.axes[1] + far.z * body.axes[2]);
}

/// The point of the segment nearest to the origin; the simplex keeps the corners that it lies between.
SpacePoint nearest_of_segment(Simplex& s) {
    const SpacePoint a = s.points[0], b = s.points[1], ab = b - a;
    const double along = -dot(a, ab), length = dot(ab, ab);
    if (along <= 0 || length <= 0) {
        s.count = 1;
        return a;
    }
    if (along >= length) {
        s = {{b}, 1};
        return b;
    }
    return a + (along / length) * ab;
}

SpacePoint on_edge(Simplex& s, SpacePoint a, SpacePoint b) {
    s = {{a, b}, 2};
    return nearest_of_segment(s);
}

/// The same of a triangle, by the regions of its corners, edges and inside (barycentric signs).
SpacePoint nearest_of_triangle(Simplex& s) {
    const SpacePoint a = s.points[0], b = s.points[1], c = s.points[2];
    const SpacePoint normal = cross(b - a, c - a);
    const double area = dot(normal, normal);
    const double of_a = dot(cross(b, c), normal), of_b = dot(cross(c, a), normal), of_c = dot(cross(a, b), normal);
    if (area > 0 && of_a > 0 && of_b > 0 && of_c > 0) return (dot(a, normal) / area) * normal;
    // Outside of an edge, or without area: the nearest of the edges that it may be outside of.
    Simplex best;
    SpacePoint nearest;
    const auto look = [&](SpacePoint p, SpacePoint q, double beyond) {
        if (area > 0 && beyond > 0) return;
        Simplex edge;
        const SpacePoint at = on_edge(edge, p, q);
        if (best.count == 0 || dot(at, at) < dot(nearest, nearest)) {
            best = edge;
            nearest = at;
        }
    };
    look(a, b, of_c);
    look(b, c, of_a);
    look(c, a, of_b);
    s = best;
    return nearest;
}

/// The same of a tetrahedron; 0 if the origin is inside.
SpacePoint nearest_of_tetrahedron(Simplex& s) {
    const std::array<SpacePoint, 4> p = s.points;
    constexpr std::array<std::array<int, 4>, 4> sides{{{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}}};
    Simplex best;
    SpacePoint nearest;
    for (const auto& side : sides) {
        const SpacePoint a = p[static_cast<std::size_t>(side[0])], b = p[static_cast<std::size_t>(side[1])],
                         c = p[static_cast<std::size_t>(side[2])], opposite = p[static_cast<std::size_t>(side[3])];
        const SpacePoint normal = cross(b - a, c - a);
        const double of_origin = -dot(a, normal), of_opposite = dot(opposite - a, normal);
        if (of_origin * of_opposite > 0) continue;  // on the inner side
        Simplex triangle{{a, b, c}, 3};
        const SpacePoint at = nearest_of_triangle(triangle);
        if (best.count == 0 || dot(at, at) < dot(nearest, nearest)) {
            best = triangle;
            nearest = at;
        }
    }
    if (best.count == 0) return {};
    s = best;
    return nearest;
}

SpacePoint nearest_to_origin(Simplex& s) {
    if (s.count == 1) return s.points[0];
    if (s.count == 2) return nearest_of_segment(s);
    return s.count == 3 ? nearest_of_triangle(s) : nearest_of_tetrahedron(s);
}

}  // namespace

bool convex_bodies_overlap(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b) {
    const double size = shrink_a * radius_of(a) + shrink_b * radius_of(b);
    const auto farthest = [&](SpacePoint along) {
        return support(a, shrink_a * (1 - touching), along) - support(b, shrink_b * (1 - touching), -1 * along);
    };
    SpacePoint v = a.centre - b.centre;
    if (dot(v, v) >= size * size) return false;
    if (v == SpacePoint{}) v = a.axes[0];
    Simplex simplex;
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < max_rounds; ++round) {
        const SpacePoint w = farthest(-1 * v);
        if (dot(v, w) > 0) return false;  // a plane across v parts them
        simplex.points[static_cast<std::size_t>(simplex.count++)] = w;
        v = nearest_to_origin(simplex);
        const double distance = abs(v);
        // Rounding has the last word where a new corner brings the origin no nearer.
        if (simplex.count == 4 || distance <= meets_origin * size || !(distance < last)) return true;
        last = distance;
    }
    return true;
}

}  // namespace rinceau

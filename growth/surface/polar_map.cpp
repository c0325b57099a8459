// Discrete geodesic polar coordinates: Melvaer & Reimers, "Geodesic polar coordinates on polygonal meshes" (2012).
//
// A label (distance U, angle theta) spreads over an edge jk to the third corner i of the face beyond it: the source is laid
// flat at its distances from j and k, and where the straight way to i crosses jk it gives U_i, and theta_i between theta_j
// and theta_k; elsewhere the way leads along an edge. Two deviations:
// - a vertex is taken up again when its distance drops: fixing each once, in Dijkstra's order, costs 3e-4 of the radius
// where
//   triangles are obtuse, because the two corners of the edge that the way crosses can be farther off than the third;
// - labels near the source are not spread but seen: by unfolding the faces around it. Angles that begin with the corners of
// one face
//   alone would be wrong all the way out.

#include "growth/surface/polar_map.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/index.h"

namespace rinceau {

/// A half-edge seen from the source through all the edges before it.
struct PolarMapper::View {
    int half_edge = 0;    ///< its face is the one looked from
    Complex start, end;   ///< its ends, laid flat with the source at the origin; start is to the right
    Complex right, left;  ///< the sides of what is seen
    double turn = 0;      ///< added to the angles that are seen
    double scale = 1;     ///< flat angle times this = angle of the map
    int depth = 0;        ///< faces that can still be looked through
};

namespace {

constexpr int look_depth = 4;               // faces
constexpr double smallest_drop = 1e-10;     // of the mean edge: smaller gains are rounding, and would spread without end
constexpr std::uint32_t most_changes = 64;  // of one label; a few are usual: bounds the work on any input
constexpr double corner_share = 1e-9;       // of an edge: a source nearer to a corner lies on the vertex

double distance_from_origin(Complex a, Complex b) {
    const Complex along = b - a;
    const double share = std::clamp(-dot(a, along) / norm(along), 0.0, 1.0);
    return abs(a + share * along);
}

bool later(const double a, const int a_vertex, const double b, const int b_vertex) {
    return a != b ? a > b : a_vertex > b_vertex;
}

}  // namespace

PolarMapper::PolarMapper(const SurfaceMesh& surface) : surface_(&surface), labels_(surface.mesh.positions.size()) {}

void PolarMapper::begin(double radius) {
    if (++map_ == 0) {  // all numbers used up
        std::ranges::fill(labels_, Label{});
        map_ = 1;
    }
    radius_ = radius;
    waiting_.clear();
    reached_.clear();
}

void PolarMapper::finish() {
    for (const int v : reached_) labels_[at(v)].angle = wrap_angle(labels_[at(v)].angle);
    std::ranges::sort(reached_, [this](int a, int b) { return later(distance(b), b, distance(a), a); });
}

/// Takes a label that is better than the one known.
void PolarMapper::offer(int vertex, double distance, double angle) {
    Label& known = labels_[at(vertex)];
    if (known.map != map_) {
        reached_.push_back(vertex);
        known = {map_, 0, distance, angle};
    } else {
        if (distance > known.distance - smallest_drop * surface_->mean_edge || known.changes >= most_changes) return;
        known = {map_, known.changes + 1, distance, angle};
    }
    waiting_.push_back({distance, vertex});
    std::ranges::push_heap(waiting_, [](Waiting a, Waiting b) { return later(a.distance, a.vertex, b.distance, b.vertex); });
}

/// Unfolds the face behind the view's edge, and those behind its other two edges as far as they are seen.
void PolarMapper::look_through(const View& view) {
    const int twin = surface_->twin[at(view.half_edge)];
    if (twin < 0 || distance_from_origin(view.start, view.end) > radius_) return;
    const auto& flat = surface_->flat[at(face_of(twin))];
    const Complex tip_in_face = flat[at(previous_in_face(twin) % 3)] - flat[at(twin % 3)];
    const Complex tip = view.end + tip_in_face * (view.start - view.end) / edge_vector(*surface_, twin);
    const bool left_of_right = cross(view.right, tip) >= 0, right_of_left = cross(tip, view.left) >= 0;
    if (left_of_right && right_of_left)
        offer(start_of(*surface_, previous_in_face(twin)), abs(tip), view.turn + view.scale * arg(tip));
    if (view.depth == 0) return;
    View next = view;
    --next.depth;
    if (left_of_right) {
        next.half_edge = next_in_face(twin);
        next.start = view.start, next.end = tip;
        next.right = view.right, next.left = right_of_left ? tip : view.left;
        look_through(next);
    }
    if (right_of_left) {
        next.half_edge = previous_in_face(twin);
        next.start = tip, next.end = view.end;
        next.right = left_of_right ? tip : view.right, next.left = view.left;
        look_through(next);
    }
}

void PolarMapper::see_from_face(SurfacePoint source) {
    const auto& flat = surface_->flat[at(source.face)];
    for (int k = 0; k < 3; ++k) {
        const Complex corner = flat[at(k)] - source.at;
        offer(start_of(*surface_, 3 * source.face + k), abs(corner), arg(corner));
    }
    for (int k = 0; k < 3; ++k) {
        const Complex start = flat[at(k)] - source.at, end = flat[at((k + 1) % 3)] - source.at;
        look_through({3 * source.face + k, start, end, start, end, 0, 1, look_depth - 1});
    }
}

/// `turn` is added to the angles of the vertex's frame.
void PolarMapper::see_from_vertex(int vertex, double turn) {
    offer(vertex, 0, turn);
    const double scale = surface_->angle_scale[at(vertex)];
    const int first = surface_->outgoing[at(vertex)];
    int h = first;
    do {
        // the face laid with h on the x axis
        const double corner = corner_angle(*surface_, h), angle = turn + surface_->angle[at(h)];
        const Complex start{abs(edge_vector(*surface_, h)), 0};
        const Complex end = polar(abs(edge_vector(*surface_, previous_in_face(h))), corner);
        offer(end_of(*surface_, h), start.x, angle);
        offer(start_of(*surface_, previous_in_face(h)), abs(end), angle + scale * corner);
        look_through({next_in_face(h), start, end, start, end, angle, scale, 0});
        h = next_about_start(*surface_, h);
    } while (h >= 0 && h != first);
}

/// From both ends of a half-edge to the third corner of its face. Nothing if all of the edge is outside of the radius.
void PolarMapper::spread_over(int h, double start_distance, double end_distance) {
    // the half-edge from (0, 0) to (length, 0), the third corner above it, the source below
    const auto& flat = surface_->flat[at(face_of(h))];
    const Complex start = flat[at(h % 3)], edge = flat[at(next_in_face(h) % 3)] - start;
    const double length = abs(edge), a = start_distance, b = end_distance;
    const Complex third = (flat[at(previous_in_face(h) % 3)] - start) * conj(edge) / length;
    const double source_x = (a * a - b * b + length * length) / (2 * length);
    const Complex source{source_x, -std::sqrt(std::max(0.0, a * a - source_x * source_x))};
    const Complex way = third - source;
    const double crossing = source.x * way.y - way.x * source.y;  // times way.y
    const bool crosses = crossing >= 0 && crossing <= length * way.y;
    const double by_start = crosses ? 0 : a + abs(third), by_end = crosses ? 0 : b + abs(third - Complex{length, 0});
    const double distance = crosses ? abs(way) : std::min(by_start, by_end);

    const int v = start_of(*surface_, previous_in_face(h));
    if (has(v) && distance > this->distance(v) - smallest_drop * surface_->mean_edge) return;
    if (distance > radius_ && distance_from_origin(-source, Complex{length, 0} - source) > radius_) return;
    const double start_angle = angle(start_of(*surface_, h)), end_angle = angle(end_of(*surface_, h));
    if (!crosses) return offer(v, distance, by_start <= by_end ? start_angle : end_angle);
    const Complex to_start = -source, to_end = Complex{length, 0} - source;
    const double whole = std::atan2(cross(to_end, to_start), dot(to_start, to_end));
    const double part = std::atan2(cross(way, to_start), dot(to_start, way));
    const double share = whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0.5;
    offer(v, distance, start_angle + share * wrap_angle(end_angle - start_angle));
}

void PolarMapper::spread() {
    while (!waiting_.empty()) {
        std::ranges::pop_heap(waiting_,
                              [](Waiting a, Waiting b) { return later(a.distance, a.vertex, b.distance, b.vertex); });
        const Waiting next = waiting_.back();
        waiting_.pop_back();
        if (next.distance > distance(next.vertex)) continue;  // it has got a better label since
        const int first = surface_->outgoing[at(next.vertex)];
        int h = first;
        do {
            const int before = previous_in_face(h), to = end_of(*surface_, h), from = start_of(*surface_, before);
            if (has(to)) spread_over(h, next.distance, distance(to));
            if (has(from)) spread_over(before, distance(from), next.distance);
            h = surface_->twin[at(before)];
        } while (h >= 0 && h != first);
    }
}

void PolarMapper::map(SurfacePoint source, double radius) {
    begin(radius);
    const auto weights = barycentric(*surface_, source);
    const auto heaviest = static_cast<int>(std::ranges::max_element(weights) - weights.begin());
    if (weights[at(heaviest)] >= 1 - corner_share) {
        const int h = 3 * source.face + heaviest;
        see_from_vertex(start_of(*surface_, h), arg(edge_vector(*surface_, h)) - surface_->angle[at(h)]);
    } else {
        see_from_face(source);
    }
    spread();
    finish();
}

void PolarMapper::map_of_vertex(int vertex, double radius) {
    begin(radius);
    see_from_vertex(vertex, 0);
    spread();
    finish();
}

namespace {

PolarMap within(const PolarMapper& mapper, SurfacePoint source, double radius) {
    PolarMap map;
    map.source = source;
    map.radius = radius;
    for (const int v : mapper.reached()) {
        if (mapper.distance(v) > radius) break;
        map.vertices.push_back(v);
        map.distance.push_back(mapper.distance(v));
        map.angle.push_back(mapper.angle(v));
    }
    return map;
}

}  // namespace

PolarMap polar_map(const SurfaceMesh& surface, SurfacePoint source, double radius) {
    PolarMapper mapper(surface);
    mapper.map(source, radius);
    return within(mapper, source, radius);
}

PolarMap polar_map_of_vertex(const SurfaceMesh& surface, int vertex, double radius) {
    PolarMapper mapper(surface);
    mapper.map_of_vertex(vertex, radius);
    return within(mapper, at_vertex(surface, vertex), radius);
}

}  // namespace rinceau

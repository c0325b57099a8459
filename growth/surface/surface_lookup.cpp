// A face is asked in its own frame: the place's height above it, and the point of a flat triangle that is nearest to its
// foot.

#include "growth/surface/surface_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/index.h"

namespace rinceau {
namespace {

/// Of a flat triangle that turns counter-clockwise.
Complex nearest_in(const std::array<Complex, 3>& flat, Complex p) {
    bool inside = true;
    Complex best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Complex a = flat[k], side = flat[(k + 1) % 3] - a;
        inside = inside && cross(side, p - a) >= 0;
        const Complex on_side = a + std::clamp(dot(p - a, side) / norm(side), 0.0, 1.0) * side;
        if (norm(p - on_side) >= least) continue;
        least = norm(p - on_side);
        best = on_side;
    }
    return inside ? p : best;
}

struct FacePlace {
    Complex at;
    double square = 0;  ///< of the distance
};

FacePlace nearest_in_face(const SurfaceMesh& surface, int face, SpacePoint p) {
    const auto& [x, y, normal] = surface.frame[at(face)];
    const SpacePoint from = p - surface.mesh.positions[at(surface.mesh.triangles[at(face)][0])];
    const Complex foot{dot(from, x), dot(from, y)};
    const double height = dot(from, normal);
    const Complex place = nearest_in(surface.flat[at(face)], foot);
    return {place, height * height + norm(foot - place)};
}

/// The nearest place so far.
struct BestPlace {
    SurfacePoint at;
    double square = std::numeric_limits<double>::infinity();

    void ask(const SurfaceMesh& surface, int face, SpacePoint p) {
        const FacePlace place = nearest_in_face(surface, face, p);
        if (place.square > square || (place.square == square && face > at.face)) return;
        at = {face, place.at};
        square = place.square;
    }
    NearestOnSurface result() const { return {at, std::sqrt(square)}; }
};

double square_to_box(SpacePoint p, SpacePoint low, SpacePoint high) {
    const auto beyond = [](double value, double from, double to) { return std::max({from - value, 0.0, value - to}); };
    const SpacePoint d{beyond(p.x, low.x, high.x), beyond(p.y, low.y, high.y), beyond(p.z, low.z, high.z)};
    return dot(d, d);
}

double coordinate(SpacePoint p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

SpacePoint lower(SpacePoint a, SpacePoint b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
SpacePoint higher(SpacePoint a, SpacePoint b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

}  // namespace

NearestOnSurface nearest_on_surface(const SurfaceMesh& surface, SpacePoint p) {
    BestPlace best;
    for (int face = 0; face < surface.faces(); ++face) best.ask(surface, face, p);
    return best.result();
}

int nearest_vertex(const SurfaceMesh& surface, SpacePoint p) {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < surface.vertices(); ++v) {
        const SpacePoint d = surface.mesh.positions[at(v)] - p;
        if (dot(d, d) >= least) continue;
        least = dot(d, d);
        best = v;
    }
    return best;
}

SurfaceLookup::SurfaceLookup(const SurfaceMesh& surface) : surface_(&surface), faces_(at(surface.faces())) {
    std::iota(faces_.begin(), faces_.end(), 0);
    std::vector<SpacePoint> middles;
    middles.reserve(faces_.size());
    for (const auto& [a, b, c] : surface.mesh.triangles)
        middles.push_back(surface.mesh.positions[at(a)] + surface.mesh.positions[at(b)] + surface.mesh.positions[at(c)]);
    build(0, surface.faces(), middles);
}

int SurfaceLookup::build(int first, int count, const std::vector<SpacePoint>& middles) {
    constexpr int most_in_leaf = 4;
    const int index = static_cast<int>(nodes_.size());
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Node node{{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}, first, count, 0};
    SpacePoint low = node.low, high = node.high;  // of the middles
    for (int i = first; i < first + count; ++i) {
        for (const int v : surface_->mesh.triangles[at(faces_[at(i)])]) {
            node.low = lower(node.low, surface_->mesh.positions[at(v)]);
            node.high = higher(node.high, surface_->mesh.positions[at(v)]);
        }
        low = lower(low, middles[at(faces_[at(i)])]);
        high = higher(high, middles[at(faces_[at(i)])]);
    }
    nodes_.push_back(node);
    if (count <= most_in_leaf) return index;
    const SpacePoint extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto before = [&](int a, int b) {
        return std::pair{coordinate(middles[at(a)], axis), a} < std::pair{coordinate(middles[at(b)], axis), b};
    };
    const auto begin = faces_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, before);
    build(first, count / 2, middles);
    const int right = build(first + count / 2, count - count / 2, middles);
    nodes_[at(index)].right = right;
    nodes_[at(index)].count = 0;
    return index;
}

NearestOnSurface SurfaceLookup::nearest(SpacePoint p) const {
    BestPlace best;
    constexpr double rounding = 1 + 1e-12;             // of both ways to measure: no face that is as near may be left out
    std::array<std::pair<double, int>, 64> waiting{};  // halves of halves: no deeper than the bits of an int
    std::size_t count = 0;
    waiting[count++] = {0, 0};
    while (count > 0) {
        const auto [square, index] = waiting[--count];
        if (square > best.square * rounding) continue;
        const Node& node = nodes_[at(index)];
        for (int i = node.first; i < node.first + node.count; ++i) best.ask(*surface_, faces_[at(i)], p);
        if (node.count > 0) continue;
        std::pair<double, int> near{0, index + 1}, far{0, node.right};
        for (auto* child : {&near, &far})
            child->first = square_to_box(p, nodes_[at(child->second)].low, nodes_[at(child->second)].high);
        if (far.first < near.first) std::swap(near, far);
        waiting[count++] = far;
        waiting[count++] = near;
    }
    return best.result();
}

SurfaceSampler::SurfaceSampler(const SurfaceMesh& surface) : surface_(&surface) {
    area_up_to_.reserve(surface.flat.size());
    double sum = 0;
    for (const auto& flat : surface.flat) area_up_to_.push_back(sum += cross(flat[1], flat[2]) / 2);
}

SurfacePoint SurfaceSampler::sample(Random& random) const {
    const double wanted = random.uniform() * area_up_to_.back();
    const auto found = std::upper_bound(area_up_to_.begin(), area_up_to_.end() - 1, wanted);
    const double root = std::sqrt(random.uniform()), share = random.uniform();
    return from_barycentric(*surface_, static_cast<int>(found - area_up_to_.begin()),
                            {1 - root, root * (1 - share), root * share});
}

}  // namespace rinceau

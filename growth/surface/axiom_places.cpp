#include "growth/surface/axiom_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/random.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

constexpr double steepest = 0.1;  // length of an axis' shadow in the surface, below which another axis is taken

Complex level_direction(const SurfaceMesh& surface, int face) {
    const auto& frame = surface.frame[static_cast<std::size_t>(face)];
    for (const SpacePoint axis : {SpacePoint{1, 0, 0}, SpacePoint{0, 1, 0}}) {
        const Complex shadow{dot(axis, frame[0]), dot(axis, frame[1])};
        if (abs(shadow) > steepest) return shadow / abs(shadow);
    }
    return {1, 0};
}

AxiomPlace place_at(const SurfaceMesh& surface, const FieldOnSurface* guide, SurfacePoint at) {
    const Complex level = level_direction(surface, at.face);
    const Complex z = guide != nullptr ? guide->at(at) : Complex{};
    return {at, abs(z) > 0 ? root_near(z, guide->n(), level) : level};
}

double squared(SpacePoint a) { return dot(a, a); }

/// Of a triangle, the weights of the point that is nearest to p (Ericson 2005, section 5.1.5).
std::array<double, 3> nearest_weights(SpacePoint p, SpacePoint a, SpacePoint b, SpacePoint c) {
    const SpacePoint ab = b - a, ac = c - a, n = cross(ab, ac);
    const double area = squared(n);
    const double wb = dot(cross(p - a, ac), n) / area, wc = dot(cross(ab, p - a), n) / area, wa = 1 - wb - wc;
    if (wa >= 0 && wb >= 0 && wc >= 0) return {wa, wb, wc};
    const auto share = [&](SpacePoint from, SpacePoint to) {
        return std::clamp(dot(p - from, to - from) / squared(to - from), 0.0, 1.0);
    };
    const double sab = share(a, b), sbc = share(b, c), sca = share(c, a);
    const double dab = squared(a + sab * ab - p), dbc = squared(b + sbc * (c - b) - p), dca = squared(c + sca * (a - c) - p);
    if (dab <= dbc && dab <= dca) return {1 - sab, sab, 0};
    if (dbc <= dca) return {0, 1 - sbc, sbc};
    return {sca, 0, 1 - sca};
}

/// Looks at every face: an axiom asks once.
SurfacePoint nearest_on_surface(const SurfaceMesh& surface, SpacePoint p) {
    double best = std::numeric_limits<double>::infinity();
    SurfacePoint found = at_vertex(surface, 0);  // for places so far away that no face is nearer than another
    for (int f = 0; f < surface.faces(); ++f) {
        const auto [a, b, c] = surface.mesh.triangles[static_cast<std::size_t>(f)];
        const auto corner = [&](int v) { return surface.mesh.positions[static_cast<std::size_t>(v)]; };
        const auto weights = nearest_weights(p, corner(a), corner(b), corner(c));
        const SpacePoint there = weights[0] * corner(a) + weights[1] * corner(b) + weights[2] * corner(c);
        if (squared(there - p) >= best) continue;
        best = squared(there - p);
        found = from_barycentric(surface, f, weights);
    }
    return found;
}

/// Summed areas of the faces, for scattering many points.
std::vector<double> summed_areas(const SurfaceMesh& surface) {
    std::vector<double> sums(static_cast<std::size_t>(surface.faces()));
    double sum = 0;
    for (std::size_t f = 0; f < sums.size(); ++f) sums[f] = sum += cross(surface.flat[f][1], surface.flat[f][2]) / 2;
    return sums;
}

SurfacePoint scattered(const SurfaceMesh& surface, const std::vector<double>& sums, Random& random) {
    const auto found = std::ranges::upper_bound(sums, random.uniform() * sums.back());
    const int face = static_cast<int>(std::min(found, sums.end() - 1) - sums.begin());
    const double root = std::sqrt(random.uniform()), share = random.uniform();
    return from_barycentric(surface, face, {1 - root, root * (1 - share), root * share});
}

int vertex_of(const CompiledShapeAxiom& axiom, const SurfaceMesh& surface) {
    const double number = axiom.numbers.front();
    if (number < surface.vertices()) return static_cast<int>(number);
    throw InputError(axiom.source->place, "expected a vertex of the surface, from 0 to " +
                                              std::to_string(surface.vertices() - 1) + ", found " + number_text(number));
}

}  // namespace

std::vector<AxiomPlace> axiom_places(const CompiledShapeAxiom& axiom, const SurfaceMesh& surface,
                                     const FieldOnSurface* guide, const FieldOnSurface* field, DrawKey key) {
    std::vector<AxiomPlace> places;
    switch (axiom.where) {
        case ShapeAxiom::Where::vertex:
            places.push_back(place_at(surface, guide, at_vertex(surface, vertex_of(axiom, surface))));
            break;
        case ShapeAxiom::Where::nearest:
            places.push_back(place_at(surface, guide,
                                      nearest_on_surface(surface, {axiom.numbers[0], axiom.numbers[1], axiom.numbers[2]})));
            break;
        case ShapeAxiom::Where::scatter: {
            const auto count = static_cast<int>(axiom.numbers.front());
            const std::vector<double> sums = summed_areas(surface);
            Random random(key);
            for (int i = 0; i < count; ++i) places.push_back(place_at(surface, guide, scattered(surface, sums, random)));
            break;
        }
        case ShapeAxiom::Where::each:
            if (field == nullptr) break;
            for (const int face : field->singular_faces())
                places.push_back(place_at(surface, guide, {face, field->zero(face)}));
            break;
    }
    return places;
}

}  // namespace rinceau

// Vertices where a field is exactly 0 have no direction: the sum of the indices is then not the Euler characteristic
// (curvature on the flats of a machine part), and a walk that meets such a vertex sticks. Their directions are spread
// inwards from the vertices that have one, in rings, and smoothed.

#include "growth/surface/field_filled.h"

#include <algorithm>
#include <cmath>

#include "geometry/index.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr double largest_value = 1e100;   ///< products of two of them, and squares, stay finite
constexpr double fill_strength = 1e-6;    ///< of the neighbours': too weak to be seen, strong enough to have a direction
constexpr double least_strength = 1e-12;  ///< of the strongest: products of weaker ones could underflow
constexpr int smoothing_rounds = 20;      ///< over the filled vertices

[[noreturn]] void fail(const SurfaceField& field, const std::string& message) { throw InputError({field.label}, message); }

void check_count(const SurfaceMesh& surface, const SurfaceField& field, std::size_t count, const std::string& what) {
    if (count == at(surface.vertices())) return;
    fail(field, "the field has " + std::to_string(count) + " " + what + " but the surface has " +
                    std::to_string(surface.vertices()) + " vertices; expected one for each vertex");
}

void check_finite(const SurfaceField& field, double value, std::size_t vertex) {
    if (std::abs(value) <= largest_value) return;
    fail(field, "the field's value of vertex " + std::to_string(vertex) + " is not a finite number below 1e100");
}

void check(const SurfaceMesh& surface, const SurfaceField& field) {
    if (field.n != 1 && field.n != 2 && field.n != 4)
        fail(field, "the field has n = " + std::to_string(field.n) +
                        "; expected 1 (vectors), 2 (tensors and line fields) or 4 (crosses)");
    if (!of_plane(field) || !field.values.empty()) check_count(surface, field, field.values.size(), "values");
    if (!field.isotropic.empty()) check_count(surface, field, field.isotropic.size(), "isotropic values");
    if (field.along_picture && (!field.picture || field.n != 2))
        fail(field, "a field along a picture's edges needs the picture, and n = 2");
    if (!field.scalar.empty()) check_count(surface, field, field.scalar.size(), "scalar values");
    for (std::size_t v = 0; v < field.values.size(); ++v) {
        check_finite(field, field.values[v].x, v);
        check_finite(field, field.values[v].y, v);
    }
    for (std::size_t v = 0; v < field.isotropic.size(); ++v) check_finite(field, field.isotropic[v], v);
    for (std::size_t v = 0; v < field.scalar.size(); ++v) check_finite(field, field.scalar[v], v);
}

/// In the frames of the vertices, whose x axis is the way of outgoing[v].
std::vector<Complex> sampled(const SurfaceMesh& surface, const SurfaceField& field) {
    std::vector<Complex> values;
    for (int v = 0; v < surface.vertices(); ++v) {
        const SpacePoint p = surface.mesh.positions[at(v)];
        const int h = surface.outgoing[at(v)];
        const SpacePoint along = surface.mesh.positions[at(end_of(surface, h))] - p;
        const double axis = std::atan2(along.y, along.x) - surface.angle[at(h)];
        values.push_back(plane_value(field, {p.x, p.y}) * polar(1, -field.n * axis));
    }
    return values;
}

/// Calls visit(neighbour, the half-edge from it, or its twin's reverse) for all neighbours of v in a fixed order.
template <class Visit>
void for_neighbours(const SurfaceMesh& surface, int v, Visit visit) {
    int h = surface.outgoing[at(v)];
    const int first = h;
    do {
        visit(end_of(surface, h), conj(transport_along(surface, h)));
        const int before = previous_in_face(h);
        h = surface.twin[at(before)];
        if (h < 0) visit(start_of(surface, before), transport_along(surface, before));
    } while (h >= 0 && h != first);
}

double strength(Complex z) { return std::hypot(z.x, z.y); }  // abs() of less than 1e-160 would be 0

Complex direction(Complex z) {
    const double length = strength(z);
    return {z.x / length, z.y / length};
}

/// The vertices without a direction in rings from the outside in: no ring next to a vertex it does not know.
std::vector<std::vector<int>> rings_of_unknown(const SurfaceMesh& surface, std::vector<bool> known) {
    std::vector<std::vector<int>> rings(1);
    const auto beside_known = [&](int v) {
        bool found = false;
        for_neighbours(surface, v, [&](int other, Complex) { found = found || known[at(other)]; });
        return found;
    };
    for (int v = 0; v < surface.vertices(); ++v)
        if (!known[at(v)] && beside_known(v)) rings.back().push_back(v);
    while (!rings.back().empty()) {
        for (const int v : rings.back()) known[at(v)] = true;
        std::vector<int> next;
        for (const int v : rings.back())
            for_neighbours(surface, v, [&](int other, Complex) {
                if (!known[at(other)]) next.push_back(other);
            });
        std::ranges::sort(next);
        next.erase(std::unique(next.begin(), next.end()), next.end());
        rings.push_back(std::move(next));
    }
    rings.pop_back();
    return rings;
}

/// The mean direction of the neighbours that `use` accepts, carried to v; the first one's where they cancel out.
template <class Use>
Complex mean_of_neighbours(const SurfaceMesh& surface, const std::vector<Complex>& values, int n, int v, Use use) {
    constexpr double cancelled = 1e-9;  // of sums of unit vectors
    Complex sum, first;
    for_neighbours(surface, v, [&](int other, Complex carry) {
        if (!use(other)) return;
        const Complex carried = direction(values[at(other)]) * power(carry, n);
        if (first == Complex{}) first = carried;
        sum += carried;
    });
    return abs(sum) > cancelled ? sum / abs(sum) : first;
}

double mean_strength(const SurfaceMesh& surface, const std::vector<Complex>& values, int v, const std::vector<bool>& known) {
    double sum = 0;
    int count = 0;
    for_neighbours(surface, v, [&](int other, Complex) {
        if (!known[at(other)]) return;
        sum += strength(values[at(other)]);
        ++count;
    });
    return sum / count;
}

void fill(const SurfaceMesh& surface, int n, std::vector<Complex>& values, std::vector<bool> known) {
    const auto rings = rings_of_unknown(surface, known);
    std::vector<int> filled;
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        std::vector<Complex> found;
        for (const int v : rings[ring]) {
            const Complex mean = mean_of_neighbours(surface, values, n, v, [&](int other) { return known[at(other)]; });
            const double weaker = ring == 0 ? fill_strength : 1;
            found.push_back(weaker * mean_strength(surface, values, v, known) * mean);
        }
        for (std::size_t i = 0; i < found.size(); ++i) values[at(rings[ring][i])] = found[i];
        for (const int v : rings[ring]) known[at(v)] = true;
        filled.insert(filled.end(), rings[ring].begin(), rings[ring].end());
    }
    for (int round = 0; round < smoothing_rounds; ++round)
        for (const int v : filled)
            values[at(v)] = strength(values[at(v)]) *
                            mean_of_neighbours(surface, values, n, v, [&](int other) { return known[at(other)]; });
}

void reach_from(const SurfaceMesh& surface, std::vector<int> open, std::vector<bool>& reached) {
    while (!open.empty()) {
        const int v = open.back();
        open.pop_back();
        for_neighbours(surface, v, [&](int other, Complex) {
            if (reached[at(other)]) return;
            reached[at(other)] = true;
            open.push_back(other);
        });
    }
}

/// One vertex of every piece of the surface that has no direction at all gets one.
void start_empty_pieces(const SurfaceMesh& surface, std::vector<Complex>& values, std::vector<bool>& known,
                        double strongest) {
    std::vector<bool> reached = known;
    std::vector<int> open;
    for (int v = 0; v < surface.vertices(); ++v)
        if (known[at(v)]) open.push_back(v);
    reach_from(surface, std::move(open), reached);
    for (int v = 0; v < surface.vertices(); ++v) {
        if (reached[at(v)]) continue;
        values[at(v)] = {strongest > 0 ? fill_strength * strongest : 1, 0};
        known[at(v)] = reached[at(v)] = true;
        reach_from(surface, {v}, reached);
    }
}

}  // namespace

Complex plane_value(const SurfaceField& field, Point place) {
    if (field.along_picture) return edges_along(*field.picture, place);
    const PlaneForm& form = *field.exact;
    if (!form.about_centre) return polar(1, field.n * form.angle);
    const Point ray = place - form.centre;
    const double length = abs(ray);
    if (!(length > 0)) return {};
    return power(ray / length, field.n) * polar(1, field.n * form.angle);
}

bool is_plane(const SurfaceMesh& surface) {
    constexpr double slack = 1e-9;  // diagonals
    const double z = surface.mesh.positions.front().z;
    const auto level = [&](SpacePoint p) { return std::abs(p.z - z) <= slack * surface.diagonal; };
    return std::ranges::all_of(surface.mesh.positions, level) &&
           std::ranges::all_of(surface.frame, [](const auto& frame) { return frame[2].z > 0; });
}

SurfaceField filled_field(const SurfaceMesh& surface, SurfaceField field) {
    check(surface, field);
    if (of_plane(field)) {
        if (!is_plane(surface))
            fail(field,
                 "this kind of field is of the plane, and the surface is not flat in z = 0 and facing +z; use elements");
        field.values = sampled(surface, field);
    }
    double strongest = 0;
    for (const Complex z : field.values) strongest = std::max(strongest, strength(z));
    constexpr double vanishing = 1e-150;  // of the strongest: rounding has eaten the direction
    std::vector<bool> known;
    for (const Complex z : field.values) known.push_back(strength(z) > vanishing * strongest);
    if (std::ranges::find(known, false) != known.end()) {
        start_empty_pieces(surface, field.values, known, strongest);
        fill(surface, field.n, field.values, known);
    }
    for (Complex& z : field.values)
        if (strength(z) < least_strength * strongest) z = least_strength * strongest * direction(z);
    return field;
}

}  // namespace rinceau

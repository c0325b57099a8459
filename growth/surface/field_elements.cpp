// Li et al. 2010, section 4.2, equation (3): T(p) = sum_j exp(-d_j rho) T_j(rho, theta), (rho, theta) being geodesic polar
// coordinates about the element j. T_j = exp(i (k (theta - direction) + n (direction + turn))) in the frame that the ray
// from the element carries along; k = n * index.
//
// Deviations: decays are per diagonal of the surface, so that designs fit any unit; besides the paper's exp(-d rho) there is
// the Gaussian that its text names. Over the cut locus of an element its ray jumps: with the default decay the jump weighs
// little, and smoothing removes the rest.

#include "growth/surface/field_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/angle.h"
#include "geometry/index.h"
#include "growth/surface/field_filled.h"
#include "growth/surface/polar_map.h"
#include "growth/surface/vertex_axes.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

struct KindRow {
    FieldElementKind kind;
    std::string_view name;
    std::array<int, 3> turns;  ///< k for n = 1, 2, 4; unfit where the kind is not of such fields
    double turn;               ///< of its directions
};

constexpr int unfit = std::numeric_limits<int>::max();

constexpr std::array<KindRow, 10> kinds{{{FieldElementKind::regular, "regular", {0, 0, 0}, 0},
                                         {FieldElementKind::wedge, "wedge", {unfit, 1, unfit}, 0},
                                         {FieldElementKind::trisector, "trisector", {unfit, -1, unfit}, 0},
                                         {FieldElementKind::node, "node", {unfit, 2, unfit}, 0},
                                         {FieldElementKind::centre, "centre", {1, 2, unfit}, pi / 2},
                                         {FieldElementKind::saddle, "saddle", {-1, -2, unfit}, 0},
                                         {FieldElementKind::source, "source", {1, unfit, unfit}, 0},
                                         {FieldElementKind::sink, "sink", {1, unfit, unfit}, pi},
                                         {FieldElementKind::quarter, "quarter", {unfit, unfit, 1}, 0},
                                         {FieldElementKind::minus_quarter, "minus-quarter", {unfit, unfit, -1}, 0}}};

constexpr double own_weight = 1e-3;     ///< of a singular element at its own vertex
constexpr double least_weight = 1e-12;  ///< influence at which an element ends

const KindRow& row_of(FieldElementKind kind) { return kinds[static_cast<std::size_t>(kind)]; }

int turns_of(FieldElementKind kind, int n) { return row_of(kind).turns[n == 1 ? 0 : n == 2 ? 1 : 2]; }

std::string names_for(int n) {
    std::string names;
    for (const FieldElementKind kind : field_element_kinds(n))
        names.append(names.empty() ? "" : ", ").append(row_of(kind).name);
    return names;
}

void check(const SurfaceMesh& surface, int n, const std::vector<FieldElement>& elements, const std::string& label) {
    const auto fail = [&](std::size_t i, const std::string& message) {
        throw InputError({label}, "element " + std::to_string(i + 1) + ": " + message);
    };
    if (n != 1 && n != 2 && n != 4)
        throw InputError({label}, "the field has n = " + std::to_string(n) + "; expected 1, 2 or 4");
    if (elements.empty()) throw InputError({label}, "expected at least one element to make a field of");
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const FieldElement& e = elements[i];
        if (turns_of(e.kind, n) == unfit)
            fail(i, "\"" + std::string(row_of(e.kind).name) + "\" is no element of fields with n = " + std::to_string(n) +
                        "; expected one of " + names_for(n));
        if (e.vertex < 0 || e.vertex >= surface.vertices())
            fail(i, "the surface has no vertex " + std::to_string(e.vertex) + "; expected 0 to " +
                        std::to_string(surface.vertices() - 1));
        const auto positive = [](double value) { return value > 0 && value < 1e9; };
        if (!positive(e.weight)) fail(i, "expected a weight above 0");
        if (!positive(e.decay)) fail(i, "expected a decay above 0");
        if (!std::isfinite(e.direction) || !std::isfinite(e.turn)) fail(i, "an angle is not a finite number");
    }
}

/// Distances and angles of all vertices; a negative distance where the map does not reach.
struct PolarTable {
    std::vector<double> distance, angle;
};

PolarTable table_about(const SurfaceMesh& surface, int vertex, double radius) {
    const PolarMap map = polar_map_of_vertex(surface, vertex, radius);
    PolarTable table{std::vector<double>(at(surface.vertices()), -1), std::vector<double>(at(surface.vertices()), 0)};
    for (std::size_t i = 0; i < map.vertices.size(); ++i) {
        table.distance[at(map.vertices[i])] = map.distance[i];
        table.angle[at(map.vertices[i])] = map.angle[i];
    }
    return table;
}

/// The way of the ray at a corner, in the frame of its face: the gradient of the distance, taken from the map's positions,
/// which stay linear up to the source. Of length 1 where the map is smooth.
Complex ray_at(const SurfaceMesh& surface, const PolarTable& table, int h) {
    const auto& face = surface.mesh.triangles[at(face_of(h))];
    const auto& flat = surface.flat[at(face_of(h))];
    std::array<Complex, 3> laid;
    for (std::size_t k = 0; k < 3; ++k) {
        if (table.distance[at(face[k])] < 0) return {};
        laid[k] = polar(table.distance[at(face[k])], table.angle[at(face[k])]);
    }
    const Complex by_x = (laid[1] - laid[0]) / flat[1].x;
    const Complex by_y = (laid[2] - laid[0] - flat[2].x * by_x) / flat[2].y;
    const Complex way = polar(1, table.angle[at(start_of(surface, h))]);
    return {dot(by_x, way), dot(by_y, way)};
}

/// The same from the distances alone: rough near the source, but whole where the angles jump.
Complex slope_of(const SurfaceMesh& surface, const PolarTable& table, int f) {
    const auto& face = surface.mesh.triangles[at(f)];
    const auto& flat = surface.flat[at(f)];
    std::array<double, 3> d;
    for (std::size_t k = 0; k < 3; ++k) {
        d[k] = table.distance[at(face[k])];
        if (d[k] < 0) return {};
    }
    const double by_x = (d[1] - d[0]) / flat[1].x;
    return {by_x, (d[2] - d[0] - flat[2].x * by_x) / flat[2].y};
}

/// By vertex: the way of the ray from the source, in the vertex's frame; of length 1, or 0 where there is none.
std::vector<Complex> rays(const SurfaceMesh& surface, const PolarTable& table) {
    constexpr double least_slope = 0.5, largest_slope = 2;  // beyond them the face lies over the cut locus
    std::vector<Complex> sums(at(surface.vertices())), rough(at(surface.vertices()));
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        const auto v = at(start_of(surface, h));
        const Complex to_vertex = corner_angle(surface, h) * corner_to_vertex(surface, h);
        const Complex ray = ray_at(surface, table, h);
        if (const double slope = abs(ray); slope > least_slope && slope < largest_slope) sums[v] += ray * to_vertex;
        rough[v] += slope_of(surface, table, face_of(h)) * to_vertex;
    }
    constexpr double cancelled = 1e-9;
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const Complex sum = abs(sums[v]) > cancelled ? sums[v] : rough[v];
        sums[v] = abs(sum) > cancelled ? sum / abs(sum) : Complex{};
    }
    return sums;
}

void add_element(const SurfaceMesh& surface, int n, const FieldElement& element, std::vector<Complex>& values) {
    const double decay = element.decay / surface.diagonal, end = -std::log(least_weight);
    const double radius = element.gauss ? std::sqrt(end) / decay : end / decay;
    const PolarTable table = table_about(surface, element.vertex, radius);
    const std::vector<Complex> ray = rays(surface, table);
    const int k = turns_of(element.kind, n);
    const double phase = n * (element.direction + element.turn + row_of(element.kind).turn) - k * element.direction;
    for (int v = 0; v < surface.vertices(); ++v) {
        if (v == element.vertex) {
            values[at(v)] += polar(element.weight * (k == 0 ? 1 : own_weight), phase);
            continue;
        }
        if (table.distance[at(v)] < 0 || ray[at(v)] == Complex{}) continue;
        const double fall = decay * table.distance[at(v)], theta = table.angle[at(v)];
        const double weight = element.weight * std::exp(element.gauss ? -fall * fall : -fall);
        values[at(v)] += polar(weight, phase + (k - n) * theta) * power(ray[at(v)], n);
    }
}

}  // namespace

std::optional<FieldElementKind> field_element_kind(std::string_view name) {
    if (name == "center") name = "centre";
    for (const KindRow& row : kinds)
        if (row.name == name) return row.kind;
    return std::nullopt;
}

std::string_view name_of(FieldElementKind kind) { return row_of(kind).name; }

std::vector<FieldElementKind> field_element_kinds(int n) {
    std::vector<FieldElementKind> fit;
    for (const KindRow& row : kinds)
        if (turns_of(row.kind, n) != unfit) fit.push_back(row.kind);
    return fit;
}

double direction_at_vertex(const SurfaceMesh& surface, int vertex, SpacePoint vector) {
    return arg(from_space_to_vertex(surface, vertex_axis(surface, vertex), vertex, vector));
}

double reference_direction(const SurfaceMesh& surface, int vertex) {
    constexpr double facing = 0.9;
    const bool faces_x = std::abs(surface.vertex_normal[at(vertex)].x) > facing;
    return direction_at_vertex(surface, vertex, faces_x ? SpacePoint{0, 1, 0} : SpacePoint{1, 0, 0});
}

SurfaceField field_of_elements(const SurfaceMesh& surface, int n, const std::vector<FieldElement>& elements,
                               const std::string& label, const Progress& progress) {
    check(surface, n, elements, label);
    SurfaceField field{.n = n, .label = label};
    field.values.assign(at(surface.vertices()), Complex{});
    for (std::size_t i = 0; i < elements.size(); ++i) {
        report(progress, "designing the field", static_cast<double>(i) / static_cast<double>(elements.size()));
        add_element(surface, n, elements[i], field.values);
    }
    return field;
}

}  // namespace rinceau

// Deviations from Li et al. 2010, section 4.2: besides their rounds of local smoothing, which stall with many singular
// points left, an implicit step (M + lambda L) z' = M z with lambda = (radius * diagonal)^2, M the vertices' areas and L the
// Laplacian with cotangent weights whose off-diagonal entries carry a value along the edge (as in Knoeppel, Crane, Pinkall &
// Schroeder 2013, whose smoothest field is the eigenvector of the least eigenvalue).

#include "growth/surface/field_smooth.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "geometry/index.h"
#include "geometry/random.h"
#include "growth/surface/field_filled.h"
#include "growth/surface/polar_map.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr double least_cotangent = 1e-3;  ///< of weights: very obtuse pairs of faces would push values apart
constexpr int most_factored = 150'000;    ///< faces; beyond, filling-in takes longer than iterating

double cotangent_opposite(const SurfaceMesh& surface, int h) {
    const Complex from_end = edge_vector(surface, next_in_face(h)), from_start = -edge_vector(surface, previous_in_face(h));
    return dot(from_end, from_start) / std::abs(cross(from_end, from_start));
}

/// By half-edge, the same for both twins.
std::vector<double> edge_weights(const SurfaceMesh& surface) {
    std::vector<double> weights(surface.twin.size(), 0);
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        const int twin = surface.twin[at(h)];
        const double over = twin < 0 ? 0 : cotangent_opposite(surface, twin);
        weights[at(h)] = std::max(least_cotangent, (cotangent_opposite(surface, h) + over) / 2);
    }
    return weights;
}

std::vector<double> vertex_areas(const SurfaceMesh& surface) {
    std::vector<double> areas(at(surface.vertices()), 0);
    for (int f = 0; f < surface.faces(); ++f) {
        const double third = cross(surface.flat[at(f)][1], surface.flat[at(f)][2]) / 6;
        for (const int v : surface.mesh.triangles[at(f)]) areas[at(v)] += third;
    }
    return areas;
}

/// Calls visit(h, start, end, weight) for one half-edge of every edge.
template <class Visit>
void for_edges(const SurfaceMesh& surface, const std::vector<double>& weights, Visit visit) {
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        const int twin = surface.twin[at(h)];
        if (twin >= 0 && twin < h) continue;
        visit(h, start_of(surface, h), end_of(surface, h), weights[at(h)]);
    }
}

template <class Scalar>
Scalar carrying(const SurfaceMesh& surface, int h, int n) {
    if constexpr (std::is_same_v<Scalar, double>) {
        return 1;
    } else {
        const Complex carry = power(transport_along(surface, h), n);
        return {carry.x, carry.y};
    }
}

/// mass * M + stiffness * L; values of n-fold fields, or plain numbers where Scalar is double.
template <class Scalar>
Eigen::SparseMatrix<Scalar> diffusion(const SurfaceMesh& surface, int n, double mass, double stiffness) {
    std::vector<Eigen::Triplet<Scalar>> entries;
    entries.reserve(at(9 * surface.faces()));
    const std::vector<double> areas = vertex_areas(surface);
    for (int v = 0; v < surface.vertices(); ++v) entries.emplace_back(v, v, Scalar(mass * areas[at(v)]));
    for_edges(surface, edge_weights(surface), [&](int h, int i, int j, double weight) {
        const Scalar carried = stiffness * weight * carrying<Scalar>(surface, h, n);
        entries.emplace_back(i, i, Scalar(stiffness * weight));
        entries.emplace_back(j, j, Scalar(stiffness * weight));
        entries.emplace_back(j, i, -carried);
        if constexpr (std::is_same_v<Scalar, double>)
            entries.emplace_back(i, j, -carried);
        else
            entries.emplace_back(i, j, -std::conj(carried));
    });
    Eigen::SparseMatrix<Scalar> matrix(surface.vertices(), surface.vertices());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

template <class Scalar>
using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// Solves for one right side, which is also near to the solution.
template <class Scalar>
Column<Scalar> solved(const Eigen::SparseMatrix<Scalar>& matrix, const Column<Scalar>& right, const Column<Scalar>& guess,
                      bool factor) {
    if (factor) return Eigen::SimplicialLDLT<Eigen::SparseMatrix<Scalar>>(matrix).solve(right);
    Eigen::ConjugateGradient<Eigen::SparseMatrix<Scalar>, Eigen::Lower | Eigen::Upper> iteration(matrix);
    iteration.setTolerance(1e-6);  // far below what a field's angle can be seen to
    iteration.setMaxIterations(2000);
    return iteration.solveWithGuess(right, guess);
}

/// One implicit step for values of type Scalar.
template <class Scalar>
Column<Scalar> diffused(const SurfaceMesh& surface, int n, double lambda, const Column<Scalar>& values) {
    const std::vector<double> areas = vertex_areas(surface);
    Column<Scalar> right = values;
    for (int v = 0; v < surface.vertices(); ++v) right[v] *= areas[at(v)];
    return solved<Scalar>(diffusion<Scalar>(surface, n, 1, lambda), right, values, surface.faces() <= most_factored);
}

std::vector<double> diffused_numbers(const SurfaceMesh& surface, double lambda, const std::vector<double>& numbers) {
    if (numbers.empty()) return numbers;
    const Column<double> values = Eigen::Map<const Column<double>>(numbers.data(), surface.vertices());
    const Column<double> found = diffused<double>(surface, 0, lambda, values);
    return {found.begin(), found.end()};
}

using Value = std::complex<double>;

Column<Value> column_of(const std::vector<Complex>& values) {
    Column<Value> column(static_cast<Eigen::Index>(values.size()));
    for (std::size_t v = 0; v < values.size(); ++v) column[static_cast<Eigen::Index>(v)] = {values[v].x, values[v].y};
    return column;
}

std::vector<Complex> values_of(const Column<Value>& column) {
    std::vector<Complex> values;
    values.reserve(static_cast<std::size_t>(column.size()));
    for (const Value z : column) values.push_back({z.real(), z.imag()});
    return values;
}

/// With values at its vertices instead of a closed form.
SurfaceField by_vertex(const SurfaceMesh& surface, SurfaceField field) {
    field = filled_field(surface, std::move(field));
    field.exact.reset();
    field.along_picture = false;
    return field;
}

/// The neighbours of every vertex with the weights and turns of the edges to them, side by side.
struct Neighbours {
    struct Edge {
        int other = 0;
        double weight = 0;
        Complex carry;  ///< to the power n, from the other to this
    };
    std::vector<int> first;  ///< by vertex, into edges; one more at the end
    std::vector<Edge> edges;
};

Neighbours neighbours_of(const SurfaceMesh& surface, int n) {
    Neighbours found;
    const std::vector<double> weights = edge_weights(surface);
    std::vector<int> count(at(surface.vertices()) + 1, 0);
    for_edges(surface, weights, [&](int, int i, int j, double) { ++count[at(i) + 1], ++count[at(j) + 1]; });
    std::partial_sum(count.begin(), count.end(), count.begin());
    found.first = count;
    found.edges.resize(at(count.back()));
    for_edges(surface, weights, [&](int h, int i, int j, double weight) {
        const Complex carry = power(transport_along(surface, h), n);
        found.edges[at(count[at(j)]++)] = {i, weight, carry};
        found.edges[at(count[at(i)]++)] = {j, weight, conj(carry)};
    });
    return found;
}

}  // namespace

SurfaceField smoothed(const SurfaceMesh& surface, SurfaceField field, double radius, const Progress& progress) {
    if (!(radius >= 0 && radius < 1e6))
        throw InputError({field.label}, "the smoothing radius is no number of diagonals; expected 0 or more");
    if (radius == 0) return field;
    field = by_vertex(surface, std::move(field));
    report(progress, "smoothing the field", 0);
    const double lambda = std::pow(radius * surface.diagonal, 2);
    field.values = values_of(diffused<Value>(surface, field.n, lambda, column_of(field.values)));
    field.isotropic = diffused_numbers(surface, lambda, field.isotropic);
    field.scalar = diffused_numbers(surface, lambda, field.scalar);
    return field;
}

SurfaceField smoothed_by_rounds(const SurfaceMesh& surface, SurfaceField field, int rounds, const std::vector<int>& only,
                                const Progress& progress) {
    if (rounds <= 0) return field;
    field = by_vertex(surface, std::move(field));
    const Neighbours neighbours = neighbours_of(surface, field.n), plain = neighbours_of(surface, 0);
    std::vector<int> moving = only;
    if (only.empty()) {
        moving.resize(at(surface.vertices()));
        std::iota(moving.begin(), moving.end(), 0);
    }
    const auto mean = [&](const Neighbours& near, int v, auto zero, auto term) {
        double weights = 0;
        auto sum = zero;
        for (int e = near.first[at(v)]; e < near.first[at(v) + 1]; ++e) {
            sum += term(near.edges[at(e)]);
            weights += near.edges[at(e)].weight;
        }
        return sum / weights;
    };
    const auto numbers_round = [&](std::vector<double>& numbers) {
        if (numbers.empty()) return;
        std::vector<double> next = numbers;
        for (const int v : moving)
            next[at(v)] =
                (numbers[at(v)] +
                 mean(plain, v, 0.0, [&](const Neighbours::Edge& edge) { return edge.weight * numbers[at(edge.other)]; })) /
                2;
        numbers = std::move(next);
    };
    for (int round = 0; round < rounds; ++round) {
        report(progress, "smoothing the field", static_cast<double>(round) / rounds);
        std::vector<Complex> next = field.values;
        for (const int v : moving)
            next[at(v)] = (field.values[at(v)] + mean(neighbours, v, Complex{},
                                                      [&](const Neighbours::Edge& edge) {
                                                          return edge.weight * (field.values[at(edge.other)] * edge.carry);
                                                      })) /
                          2;
        field.values = std::move(next);
        numbers_round(field.isotropic);
        numbers_round(field.scalar);
    }
    return field;
}

SurfaceField smoothest_field(const SurfaceMesh& surface, int n, const Progress& progress) {
    constexpr int solves = 20;      // of the inverse power iteration
    constexpr double shift = 1e-8;  // of the mean ratio of both matrices: keeps the least eigenvalue from being 0
    const std::vector<double> areas = vertex_areas(surface);
    Random random(1);
    SurfaceField field{.n = n, .label = "smoothest field"};
    for (int v = 0; v < surface.vertices(); ++v) field.values.push_back(polar(1, random.uniform(-pi, pi)));
    const double mass = shift * surface.vertices() / surface.area;
    const auto matrix = diffusion<Value>(surface, n, mass, 1);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Value>> factored(matrix);
    Column<Value> values = column_of(field.values);
    for (int i = 0; i < solves; ++i) {
        report(progress, "finding the smoothest field", static_cast<double>(i) / solves);
        for (int v = 0; v < surface.vertices(); ++v) values[v] *= areas[at(v)];
        values = factored.solve(values);
        const double mean = values.cwiseAbs().mean();
        values /= mean;
    }
    field.values = values_of(values);
    return field;
}

std::vector<int> vertices_around(const SurfaceMesh& surface, int vertex, double radius) {
    return polar_map_of_vertex(surface, vertex, radius).vertices;
}

}  // namespace rinceau

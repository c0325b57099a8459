// The global step is one sparse factorisation for all rounds. Cotangents are kept above a small number, so that obtuse
// triangles do not fold their neighbours. Bending is the global step alone, with turns that follow the field (a Poisson
// equation): it lays a pattern along a field without the tears that walking from element to element leaves.

#include "growth/surface/relax_chart.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/angle.h"
#include "geometry/index.h"
#include "growth/surface/drawing_chart.h"

namespace rinceau {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// A patch with its vertices counted from 0.
struct Patch {
    std::vector<std::array<int, 3>> corners;
    std::vector<std::array<double, 3>> weight;  ///< of the edge from corner k to the next: half the cotangent opposite
    std::vector<Point> place;
};

Patch patch_of(const SurfaceMesh& surface, const std::vector<ChartTriangle>& triangles) {
    Patch patch;
    std::vector<int> vertices;
    for (const ChartTriangle& triangle : triangles)
        for (const int v : surface.mesh.triangles[at(triangle.face)]) vertices.push_back(v);
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    patch.place.resize(vertices.size());
    constexpr double least_weight = 1e-2;
    for (const ChartTriangle& triangle : triangles) {
        std::array<int, 3> corners{};
        std::array<double, 3> weight{};
        const auto& flat = surface.flat[at(triangle.face)];
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = surface.mesh.triangles[at(triangle.face)][k];
            corners[k] = static_cast<int>(std::ranges::lower_bound(vertices, v) - vertices.begin());
            patch.place[at(corners[k])] = triangle.at[k];
            const Point apex = flat[(k + 2) % 3], u = flat[k] - apex, v2 = flat[(k + 1) % 3] - apex;
            weight[k] = std::max(0.5 * dot(u, v2) / cross(u, v2), least_weight);
        }
        patch.corners.push_back(corners);
        patch.weight.push_back(weight);
    }
    return patch;
}

/// The turn that takes the face's edges best to the chart's (weighted Procrustes in the plane).
Complex best_turn(const Patch& patch, std::size_t t, const std::array<Complex, 3>& flat) {
    Complex sum;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t n = (k + 1) % 3;
        const Point now = patch.place[at(patch.corners[t][n])] - patch.place[at(patch.corners[t][k])];
        sum += patch.weight[t][k] * (now * conj(flat[n] - flat[k]));
    }
    const double size = abs(sum);
    return size > 0 ? sum / size : Complex{1, 0};
}

Sparse laplacian(const Patch& patch) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t t = 0; t < patch.corners.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int i = patch.corners[t][k], j = patch.corners[t][(k + 1) % 3];
            const double w = patch.weight[t][k];
            entries.emplace_back(i, i, w);
            entries.emplace_back(j, j, w);
            entries.emplace_back(i, j, -w);
            entries.emplace_back(j, i, -w);
        }
    // one vertex of each patch is held: the patch is connected
    entries.emplace_back(0, 0, 1.0);
    const auto n = static_cast<Eigen::Index>(patch.place.size());
    Sparse matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// By triangle.
std::vector<Complex> best_turns(const Patch& patch, const SurfaceMesh& surface,
                                const std::vector<ChartTriangle>& triangles) {
    std::vector<Complex> turns;
    turns.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        turns.push_back(best_turn(patch, t, surface.flat[at(triangles[t].face)]));
    return turns;
}

/// Places whose edges are nearest to the faces' edges so turned.
void step(Patch& patch, const SurfaceMesh& surface, const std::vector<ChartTriangle>& triangles,
          const std::vector<Complex>& turns, const Eigen::SimplicialLDLT<Sparse>& solver) {
    Columns right = Columns::Zero(static_cast<Eigen::Index>(patch.place.size()), 2);
    for (std::size_t t = 0; t < patch.corners.size(); ++t) {
        const auto& flat = surface.flat[at(triangles[t].face)];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t n = (k + 1) % 3;
            const Point wanted = patch.weight[t][k] * (turns[t] * (flat[n] - flat[k]));
            const int i = patch.corners[t][k], j = patch.corners[t][n];
            right(i, 0) -= wanted.x;
            right(i, 1) -= wanted.y;
            right(j, 0) += wanted.x;
            right(j, 1) += wanted.y;
        }
    }
    right(0, 0) += patch.place[0].x;
    right(0, 1) += patch.place[0].y;
    const Columns solved = solver.solve(right);
    for (std::size_t v = 0; v < patch.place.size(); ++v) {
        const auto row = static_cast<Eigen::Index>(v);
        patch.place[v] = {solved(row, 0), solved(row, 1)};
    }
}

/// What is at the origin of the chart, with the direction of its x axis in the face.
std::optional<ChartPlace> origin_of(const SurfaceMesh& surface, const std::vector<ChartTriangle>& triangles) {
    return place_in_chart(surface, drawing_chart(surface, triangles), {0, 0});
}

/// Moves and turns the chart so that the place on the surface comes to the origin and its x to the x axis.
void put_back(const SurfaceMesh& surface, std::vector<ChartTriangle>& triangles, const ChartPlace& origin) {
    const auto found = std::ranges::find(triangles, origin.at.face, &ChartTriangle::face);
    const auto weights = barycentric(surface, origin.at);
    Complex centre;
    for (std::size_t k = 0; k < 3; ++k) centre += weights[k] * found->at[k];
    // the image of x under the map from the face to the chart
    const auto& flat = surface.flat[at(origin.at.face)];
    const Point a = flat[1] - flat[0], b = flat[2] - flat[0];
    const double area = cross(a, b), s = cross(origin.x, b) / area, t = cross(a, origin.x) / area;
    const Complex x = s * (found->at[1] - found->at[0]) + t * (found->at[2] - found->at[0]);
    const Complex back = conj(x) / abs(x);
    for (ChartTriangle& triangle : triangles)
        for (Complex& p : triangle.at) p = (p - centre) * back;
}

void take_places(std::vector<ChartTriangle>& triangles, const Patch& patch) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) triangles[t].at[k] = patch.place[at(patch.corners[t][k])];
}

/// By triangle: how far it has to turn for the field to have the angle that it has at the origin. The branches of the field
/// are told apart by going from neighbour to neighbour, from the face of the origin.
std::vector<double> turning_to_field(const FieldOnSurface& field, const std::vector<ChartTriangle>& triangles,
                                     const std::vector<Complex>& turns, const ChartPlace& origin) {
    const SurfaceMesh& surface = field.surface();
    const int n = field.n();
    std::vector<int> triangle_of(at(surface.faces()), -1);
    for (std::size_t t = 0; t < triangles.size(); ++t) triangle_of[at(triangles[t].face)] = static_cast<int>(t);
    const double wanted = arg(field.at(origin.at)) - n * arg(origin.x);
    const auto off = [&](int t) {
        const SurfacePoint middle = from_barycentric(surface, triangles[at(t)].face, {1.0 / 3, 1.0 / 3, 1.0 / 3});
        return wanted - arg(field.at(middle)) - n * arg(turns[at(t)]);
    };
    std::vector<double> turning(triangles.size(), 0);
    std::vector<bool> known(triangles.size(), false);
    std::vector<int> queue{triangle_of[at(origin.at.face)]};
    turning[at(queue.front())] = wrap_angle(off(queue.front())) / n;
    known[at(queue.front())] = true;
    for (std::size_t next = 0; next < queue.size(); ++next) {
        const int from = queue[next];
        for (int h = 3 * triangles[at(from)].face, last = h + 3; h < last; ++h) {
            const int twin = surface.twin[at(h)];
            const int to = twin < 0 ? -1 : triangle_of[at(face_of(twin))];
            if (to < 0 || known[at(to)]) continue;
            known[at(to)] = true;
            turning[at(to)] = turning[at(from)] + wrap_angle(off(to) - n * turning[at(from)]) / n;
            queue.push_back(to);
        }
    }
    return turning;
}

}  // namespace

std::vector<ChartTriangle> relaxed_chart(const SurfaceMesh& surface, std::vector<ChartTriangle> triangles, int rounds) {
    const std::optional<ChartPlace> origin = origin_of(surface, triangles);
    if (!origin) return triangles;
    Patch patch = patch_of(surface, triangles);
    Eigen::SimplicialLDLT<Sparse> solver(laplacian(patch));
    if (solver.info() != Eigen::Success) return triangles;
    for (int round = 0; round < rounds; ++round)
        step(patch, surface, triangles, best_turns(patch, surface, triangles), solver);
    take_places(triangles, patch);
    put_back(surface, triangles, *origin);
    return triangles;
}

std::vector<ChartTriangle> bent_chart(const FieldOnSurface& field, double follow, std::vector<ChartTriangle> triangles) {
    const SurfaceMesh& surface = field.surface();
    const std::optional<ChartPlace> origin = origin_of(surface, triangles);
    if (!origin || !(abs(field.at(origin->at)) > 0)) return triangles;
    Patch patch = patch_of(surface, triangles);
    Eigen::SimplicialLDLT<Sparse> solver(laplacian(patch));
    if (solver.info() != Eigen::Success) return triangles;
    std::vector<Complex> turns = best_turns(patch, surface, triangles);
    const std::vector<double> turning = turning_to_field(field, triangles, turns, *origin);
    for (std::size_t t = 0; t < turns.size(); ++t) turns[t] = turns[t] * polar(1, follow * turning[t]);
    step(patch, surface, triangles, turns, solver);
    take_places(triangles, patch);
    put_back(surface, triangles, *origin);
    return triangles;
}

}  // namespace rinceau

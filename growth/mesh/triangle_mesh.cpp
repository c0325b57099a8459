#include "growth/mesh/triangle_mesh.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

/// Twice the area long.
SpacePoint area_normal(const TriangleMesh& mesh, const std::array<int, 3>& triangle) {
    const auto corner = [&](int k) {
        return mesh.positions[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
    };
    return cross(corner(1) - corner(0), corner(2) - corner(0));
}

/// The triangles about each vertex, in order: those of vertex v are list[first[v]] up to list[first[v + 1]].
struct TrianglesAbout {
    std::vector<std::size_t> first, list;
};

TrianglesAbout triangles_about(const TriangleMesh& mesh) {
    TrianglesAbout about;
    about.first.assign(mesh.positions.size() + 1, 0);
    for (const auto& triangle : mesh.triangles)
        for (const int v : triangle) ++about.first[static_cast<std::size_t>(v) + 1];
    for (std::size_t v = 1; v < about.first.size(); ++v) about.first[v] += about.first[v - 1];
    about.list.resize(3 * mesh.triangles.size());
    std::vector<std::size_t> next(about.first.begin(), about.first.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int v : mesh.triangles[t]) about.list[next[static_cast<std::size_t>(v)]++] = t;
    return about;
}

}  // namespace

double abs(SpacePoint a) { return std::sqrt(dot(a, a)); }

SpacePoint unit(SpacePoint a) {
    const double length = abs(a);
    return length > 0 ? (1 / length) * a : a;
}

std::array<SpacePoint, 2> bounds(const TriangleMesh& mesh) {
    if (mesh.positions.empty()) return {};
    SpacePoint low = mesh.positions.front(), high = low;
    for (const SpacePoint p : mesh.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return {low, high};
}

std::vector<SpacePoint> triangle_normals(const TriangleMesh& mesh) {
    std::vector<SpacePoint> normals;
    normals.reserve(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) normals.push_back(unit(area_normal(mesh, triangle)));
    return normals;
}

std::vector<std::array<SpacePoint, 3>> corner_normals(const TriangleMesh& mesh, double crease) {
    const std::vector<SpacePoint> flat = triangle_normals(mesh);
    const TrianglesAbout about = triangles_about(mesh);
    const double least_cosine = std::cos(crease);
    std::vector<std::array<SpacePoint, 3>> normals(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = static_cast<std::size_t>(mesh.triangles[t][k]);
            SpacePoint sum;
            for (std::size_t i = about.first[v]; i < about.first[v + 1]; ++i)
                if (dot(flat[about.list[i]], flat[t]) >= least_cosine)
                    sum = sum + area_normal(mesh, mesh.triangles[about.list[i]]);
            normals[t][k] = abs(sum) > 0 ? unit(sum) : flat[t];
        }
    return normals;
}

SpacePoint apply(const MeshPose& pose, SpacePoint p) {
    const SpacePoint scaled{pose.scale.x * p.x, pose.scale.y * p.y, pose.scale.z * p.z};
    const SpacePoint axis{pose.rotation[0], pose.rotation[1], pose.rotation[2]};
    const SpacePoint twice = 2 * cross(axis, scaled);
    return pose.translation + scaled + pose.rotation[3] * twice + cross(axis, twice);
}

SpacePoint apply_to_normal(const MeshPose& pose, SpacePoint normal) {
    const SpacePoint s = pose.scale;
    const double outward = is_mirrored(pose) ? -1 : 1;
    const SpacePoint across{s.y * s.z * normal.x, s.z * s.x * normal.y, s.x * s.y * normal.z};  // of a scaled surface
    return unit(apply(MeshPose{.rotation = pose.rotation}, outward * unit(across)));
}

std::array<double, 4> rotation_about(SpacePoint axis, double angle) {
    const double s = std::sin(angle / 2);
    return {s * axis.x, s * axis.y, s * axis.z, std::cos(angle / 2)};
}

std::vector<std::array<SpacePoint, 3>> corner_normals(const NamedMesh& named, double crease) {
    if (named.normals.empty()) return corner_normals(named.mesh, crease);
    std::vector<std::array<SpacePoint, 3>> normals;
    normals.reserve(named.mesh.triangles.size());
    const auto at = [&](int v) { return named.normals[static_cast<std::size_t>(v)]; };
    for (const auto& [a, b, c] : named.mesh.triangles) normals.push_back({at(a), at(b), at(c)});
    return normals;
}

NamedMesh standing(const NamedMesh& named, const MeshPose& pose) {
    NamedMesh result = named;
    for (SpacePoint& p : result.mesh.positions) p = apply(pose, p);
    for (SpacePoint& n : result.normals) n = apply_to_normal(pose, n);
    if (is_mirrored(pose))
        for (auto& triangle : result.mesh.triangles) std::swap(triangle[1], triangle[2]);
    return result;
}

void append(NamedMesh& to, const NamedMesh& more) {
    const int first = static_cast<int>(to.mesh.positions.size());
    to.mesh.positions.insert(to.mesh.positions.end(), more.mesh.positions.begin(), more.mesh.positions.end());
    to.normals.insert(to.normals.end(), more.normals.begin(), more.normals.end());
    for (const auto& [a, b, c] : more.mesh.triangles) to.mesh.triangles.push_back({first + a, first + b, first + c});
}

}  // namespace rinceau

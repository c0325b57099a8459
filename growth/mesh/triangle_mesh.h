#pragma once
// Surfaces made of triangles in space, and copies of them.

#include <array>
#include <string>
#include <vector>

#include "scene/style.h"

namespace rinceau {

/// A point or a vector in space.
struct SpacePoint {
    double x = 0, y = 0, z = 0;
    friend constexpr bool operator==(const SpacePoint&, const SpacePoint&) = default;
};

constexpr SpacePoint operator+(SpacePoint a, SpacePoint b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr SpacePoint operator-(SpacePoint a, SpacePoint b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr SpacePoint operator*(double k, SpacePoint a) { return {k * a.x, k * a.y, k * a.z}; }
constexpr double dot(SpacePoint a, SpacePoint b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr SpacePoint cross(SpacePoint a, SpacePoint b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double abs(SpacePoint a);
/// Of length 1; the zero vector stays.
SpacePoint unit(SpacePoint a);

/// Corners are counter-clockwise seen from outside. Indices are those of positions.
struct TriangleMesh {
    std::vector<SpacePoint> positions;
    std::vector<std::array<int, 3>> triangles;
};

/// Low and high corner of the box of all positions; of a mesh without positions both are 0.
std::array<SpacePoint, 2> bounds(const TriangleMesh& mesh);

/// Of length 1; 0 where a triangle has no area.
std::vector<SpacePoint> triangle_normals(const TriangleMesh& mesh);

/// For each corner of each triangle the mean normal of the triangles about its vertex that lie within `crease` (radians) of
/// this one's plane, weighted by area: edges that are sharper stay sharp. Of length 1, or 0 where there is no area.
std::vector<std::array<SpacePoint, 3>> corner_normals(const TriangleMesh& mesh, double crease);

/// Scale first, then turn, then move, as a node of glTF.
struct MeshPose {
    SpacePoint translation;
    std::array<double, 4> rotation{0, 0, 0, 1};  ///< unit quaternion x, y, z, w
    SpacePoint scale{1, 1, 1};
};

SpacePoint apply(const MeshPose& pose, SpacePoint p);
/// A normal of length 1 as it stands on the scaled and turned surface; of length 1. No scale is 0. A mirrored pose turns the
/// surface inside out; its normals stay outward.
SpacePoint apply_to_normal(const MeshPose& pose, SpacePoint normal);
/// Does the scale make a mirror image?
constexpr bool is_mirrored(const MeshPose& pose) { return pose.scale.x * pose.scale.y * pose.scale.z < 0; }

/// Turning by `angle` (radians, counter-clockwise seen from the tip) about a unit axis, as a quaternion.
std::array<double, 4> rotation_about(SpacePoint axis, double angle);

struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
    Color color{204, 204, 204};
    std::vector<SpacePoint> normals;  ///< by position, of length 1: what the surface looks like; empty = the triangles' own
};

/// Its own normals, or those of its triangles as corner_normals() of the mesh.
std::vector<std::array<SpacePoint, 3>> corner_normals(const NamedMesh& named, double crease);

struct MeshInstance {
    int mesh = 0;  ///< index into MeshAssembly::meshes
    MeshPose pose;
};

/// Many copies of few meshes.
struct MeshAssembly {
    std::vector<NamedMesh> meshes;
    std::vector<MeshInstance> instances;
};

/// The triangles of an instance where they stand, outward sides outward, with the colour and, if it has some, the normals.
NamedMesh standing(const NamedMesh& named, const MeshPose& pose);

/// Adds the other's triangles behind; both have normals, or neither, unless `to` is empty.
void append(NamedMesh& to, const NamedMesh& more);

}  // namespace rinceau

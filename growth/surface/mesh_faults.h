#pragma once
// What keeps a mesh of triangles from being a surface that one can walk on: surface_mesh() wants none of it.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

enum class MeshFaultKind : unsigned char {
    no_face,          ///< of the whole mesh
    unused_vertex,    ///< in no face
    repeated_corner,  ///< a face that has a vertex twice
    no_area,          ///< a face thinner than 1e-9 of its longest edge
    repeated_face,    ///< a face with the vertices of an earlier one, turning as that does
    crowded_edge,     ///< an edge of three or more faces
    opposed_faces,    ///< an edge whose two faces turn against each other
    parted_fan        ///< a vertex at which the faces, going from one to the next over edges, do not reach each other
};
constexpr std::size_t mesh_fault_kinds = 8;

struct MeshFault {
    MeshFaultKind kind = MeshFaultKind::no_face;
    std::vector<int> vertices;  ///< one, the two of an edge, or the three of a face
    std::vector<int> faces;     ///< that have a part in it, rising
    SpacePoint place;           ///< the vertex, or the middle of the edge or face
};

struct MeshFaults {
    std::vector<MeshFault> list;                        ///< by kind, then by vertices and faces; at most `most` of each kind
    std::array<std::size_t, mesh_fault_kinds> count{};  ///< by kind, all of them

    std::size_t count_of(MeshFaultKind kind) const { return count[static_cast<std::size_t>(kind)]; }
    bool empty() const { return list.empty(); }
};

/// All faults of the mesh, whose coordinates are finite. Edges and vertices are looked at without the faces of the kinds
/// repeated_corner, no_area and repeated_face. Of each kind up to `most` are listed, all are counted.
MeshFaults mesh_faults(const TriangleMesh& mesh, std::size_t most = 100);

/// "3 edges of three or more faces": a count with its kind.
std::string fault_count_text(MeshFaultKind kind, std::size_t count);
/// "edge 12-13 of faces 3, 4, 9 at (0.5, 1, 2)"; vertices and faces counted from 0.
std::string fault_place_text(const MeshFault& fault);

/// Is twice the area no more than 1e-9 of the longest edge's square? Also where two corners are the same.
bool has_no_area(const TriangleMesh& mesh, const std::array<int, 3>& face);

/// 3 face + k of the corner k at which the face has the vertex, which is one of its own.
int corner_at(const TriangleMesh& mesh, int face, int vertex);

/// The sides of all faces, sorted by edge: side h = 3 face + k goes from corner k to the next one.
struct FaceSide {
    int low = 0, high = 0;  ///< the edge's vertices
    int side = 0;
    friend constexpr auto operator<=>(const FaceSide&, const FaceSide&) = default;
};
/// Of the faces that are not `left_out` (by face; may be empty).
std::vector<FaceSide> sides_by_edge(const TriangleMesh& mesh, const std::vector<char>& left_out);

}  // namespace rinceau

#pragma once
// A manifold triangle mesh as the ground that patterns grow on: half-edges, flat face frames, vertex frames.
//
// Half-edge h = 3 f + k runs from corner k of face f to corner k + 1. A face frame is the face laid flat: corner 0 at the
// origin, corner 1 on the positive x axis, corner 2 above. A vertex frame counts angles counter-clockwise from the half-edge
// outgoing[v]; the corner angles about an inner vertex are scaled so that they sum to a full turn (Zhang, Mischaikow, Turk
// 2006, section 4).

#include <array>
#include <vector>

#include "geometry/point.h"
#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// A value, made by surface_mesh() and not changed afterwards.
struct SurfaceMesh {
    TriangleMesh mesh;
    std::vector<int> twin;            ///< by half-edge; -1 = border
    std::vector<int> outgoing;        ///< by vertex, one half-edge that starts there; on a border the one without a twin
    std::vector<double> angle;        ///< by half-edge: its scaled angle in the frame of its start
    std::vector<double> angle_back;   ///< by half-edge: scaled angle of the way back in the frame of its end
    std::vector<double> angle_scale;  ///< by vertex: 2 pi / sum of the corners about an inner one, 1 on a border
    std::vector<std::array<Complex, 3>> flat;      ///< by face: its corners in its frame
    std::vector<Complex> across;                   ///< by half-edge: a direction times this = in the frame over the edge
    std::vector<std::array<SpacePoint, 3>> frame;  ///< by face: x axis, y axis, normal in space
    std::vector<SpacePoint> vertex_normal;         ///< weighted by corner angles, of length 1
    double diagonal = 0;                           ///< of the box of all positions
    double mean_edge = 0, longest_edge = 0;
    double area = 0;
    int border_edges = 0;

    int faces() const { return static_cast<int>(mesh.triangles.size()); }
    int vertices() const { return static_cast<int>(mesh.positions.size()); }
};

constexpr int face_of(int h) { return h / 3; }
constexpr int next_in_face(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr int previous_in_face(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
int start_of(const SurfaceMesh& surface, int h);
int end_of(const SurfaceMesh& surface, int h);
/// From its start to its end, in the frame of its face.
Complex edge_vector(const SurfaceMesh& surface, int h);
/// The next half-edge counter-clockwise that starts at the same vertex; -1 behind the last one of a border vertex.
int next_about_start(const SurfaceMesh& surface, int h);
/// The corner between h and the edge before it in its face, unscaled, radians.
double corner_angle(const SurfaceMesh& surface, int h);
/// Turns a direction in the frame of h's start into one in the frame of its end, along the edge: a factor of length 1.
Complex transport_along(const SurfaceMesh& surface, int h);

/// V - E + F.
int euler_characteristic(const SurfaceMesh& surface);

/// Of a mesh that mesh_faults() (mesh_faults.h) finds nothing in: every edge has one or two faces of one orientation, the
/// faces about a vertex form one fan, no face is without area, every position is used. At least one face.
SurfaceMesh surface_mesh(TriangleMesh mesh);

}  // namespace rinceau

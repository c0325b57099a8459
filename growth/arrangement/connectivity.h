#pragma once
// Which points are neighbours: a triangulation whose arbitrary and skewed parts are taken out (Ijiri et al. 2008, section
// 4).

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/angle.h"
#include "geometry/point.h"

namespace rinceau {

struct ConnectivityOptions {
    /// Two Voronoi vertices are one if they are nearer to each other than this share of the spacing and of the edge between
    /// their triangles: four points or more that are nearly on one circle form one face.
    double tie = 0.1;
    double max_angle = radians(119);  ///< radians; wider triangles are taken from the rim
};

struct Connectivity {
    std::vector<std::vector<int>> faces;    ///< corners counter-clockwise, lowest point first; sorted
    std::vector<std::vector<int>> rings;    ///< of each point: its neighbours counter-clockwise, the lowest first
    std::vector<std::vector<bool>> joined;  ///< is neighbour k joined to the next one (the last to the first) by an edge?
    std::vector<bool> inner;                ///< per point: faces all around it
    std::vector<bool> deep;                 ///< inner, and no face at it has an edge on the rim
    std::vector<std::pair<int, int>> rim;   ///< edges with a face on their left alone
    double spacing = 0;                     ///< square root of the area that a point has on the average; 0 = no faces
};

/// Delaunay triangles, merged by `tie`, without those that `max_angle` takes from the rim: one that is too wide is dropped
/// if it lies at the hull or beside a dropped one; a merged face so, if the circle about it is wider than four mean edges.
Connectivity connectivity_of(std::span<const Point> points, const ConnectivityOptions& options = {});

/// The same points with other faces, corners counter-clockwise, that do not overlap.
Connectivity connectivity_from_faces(std::span<const Point> points, std::vector<std::vector<int>> faces);

/// The faces with the edge replaced by the other diagonal of the two triangles beside it (section 4, figure 3); nothing if
/// the edge is not there, has a face on one side only, or the two faces beside it are no triangles that form a convex
/// quadrilateral.
std::optional<std::vector<std::vector<int>>> flipped_edge(std::span<const Point> points, const Connectivity& connectivity,
                                                          std::pair<int, int> edge);

/// Circle through the corners of a triangle, or the mean of those of the triangles about the first corner of a larger face.
struct FaceCircle {
    Point center;
    double radius = 0;
};
FaceCircle face_circle(std::span<const Point> points, const std::vector<int>& face);

}  // namespace rinceau

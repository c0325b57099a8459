#pragma once
// Finding places on a surface: the nearest one to a place in space, random ones; and pieces of the plane as surfaces.

#include <vector>

#include "geometry/box.h"
#include "geometry/random.h"
#include "growth/surface/surface_point.h"

namespace rinceau {

struct NearestOnSurface {
    SurfacePoint at;
    double distance = 0;
};

/// Looks at every face. Of equally near places the one in the face of the lowest number.
NearestOnSurface nearest_on_surface(const SurfaceMesh& surface, SpacePoint p);

/// Of equally near vertices the one of the lowest number.
int nearest_vertex(const SurfaceMesh& surface, SpacePoint p);

/// For many questions: a tree of boxes over the faces; answers are those of nearest_on_surface(). Refers to the surface,
/// which must outlive it. Questions may be asked on several threads at a time.
class SurfaceLookup {
  public:
    explicit SurfaceLookup(const SurfaceMesh& surface);

    NearestOnSurface nearest(SpacePoint p) const;

  private:
    struct Node {
        SpacePoint low, high;
        int first = 0, count = 0;  ///< of faces_; count 0 = an inner node
        int right = 0;             ///< of an inner node; its left child follows it
    };

    int build(int first, int count, const std::vector<SpacePoint>& middles);

    const SurfaceMesh* surface_;
    std::vector<int> faces_;
    std::vector<Node> nodes_;  ///< the root first
};

/// Places spread evenly over the area, each found in O(log faces). Draws as random_surface_point() does.
class SurfaceSampler {
  public:
    /// Refers to the surface, which must outlive it.
    explicit SurfaceSampler(const SurfaceMesh& surface);

    SurfacePoint sample(Random& random) const;

  private:
    const SurfaceMesh* surface_;
    std::vector<double> area_up_to_;  ///< by face: its area and that of all before it
};

/// A piece of the plane z = 0 as a mesh of squares, at most `step` (> 0) wide and high, each cut in two by one diagonal and
/// its neighbours by the other one. The box has an area. Throws LimitError for more than ten million vertices.
TriangleMesh plane_mesh(const Box& box, double step);

}  // namespace rinceau

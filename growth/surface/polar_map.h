#pragma once
// Geodesic polar coordinates about a point, by Dijkstra's order with label correction over triangles unfolded at the source
// (after Melvaer & Reimers 2012; section 4.2 of Li et al. 2010 uses fast marching instead).

#include <cstdint>
#include <vector>

#include "growth/surface/surface_point.h"

namespace rinceau {

/// Distance and direction from the source of the vertices within the radius (and of no others).
struct PolarMap {
    SurfacePoint source;
    double radius = 0;
    std::vector<int> vertices;  ///< by rising distance
    std::vector<double> distance;
    std::vector<double> angle;  ///< radians counter-clockwise from the x axis of the source's face frame, in (-pi, pi]
};

/// `radius` may be infinite. Work is proportional to what lies within.
PolarMap polar_map(const SurfaceMesh& surface, SurfacePoint source, double radius);
/// The same about a vertex; angles are those of the vertex's frame.
PolarMap polar_map_of_vertex(const SurfaceMesh& surface, int vertex, double radius);

/// Makes many maps of one surface: its tables are as large as the surface, a map costs only what lies within its radius.
/// Holds the last map made. Refers to the surface, which must outlive it.
class PolarMapper {
  public:
    explicit PolarMapper(const SurfaceMesh& surface);

    void map(SurfacePoint source, double radius);
    void map_of_vertex(int vertex, double radius);

    const SurfaceMesh& surface() const { return *surface_; }
    /// The vertices of the last map by rising distance: all within the radius, and all other corners of the faces that lie
    /// partly within.
    const std::vector<int>& reached() const { return reached_; }
    bool has(int vertex) const { return label(vertex).map == map_; }
    /// Of a reached vertex.
    double distance(int vertex) const { return label(vertex).distance; }
    /// Of a reached vertex; radians, in (-pi, pi].
    double angle(int vertex) const { return label(vertex).angle; }

  private:
    struct Label {
        std::uint32_t map = 0;      ///< the map that it belongs to
        std::uint32_t changes = 0;  ///< within this map
        double distance = 0;
        double angle = 0;
    };
    struct Waiting {
        double distance = 0;
        int vertex = 0;
    };
    struct View;

    const Label& label(int vertex) const { return labels_[static_cast<std::size_t>(vertex)]; }
    void begin(double radius);
    void finish();
    void offer(int vertex, double distance, double angle);
    void look_through(const View& view);
    void see_from_face(SurfacePoint source);
    void see_from_vertex(int vertex, double turn);
    void spread();
    void spread_over(int half_edge, double start_distance, double end_distance);

    const SurfaceMesh* surface_;
    std::vector<Label> labels_;
    std::vector<Waiting> waiting_;  ///< a heap
    std::vector<int> reached_;
    std::uint32_t map_ = 0;
    double radius_ = 0;
};

}  // namespace rinceau

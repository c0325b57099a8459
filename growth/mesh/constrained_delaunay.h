#pragma once
// A triangulation of points on a grid whose edges can be asked for one by one.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace rinceau {

/// Whole numbers up to 5e8: orientations are exact.
struct GridPoint {
    std::int64_t x = 0, y = 0;
    friend constexpr bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Positive if a, b, c run counter-clockwise.
constexpr std::int64_t orientation(GridPoint a, GridPoint b, GridPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Triangles over the convex hull of distinct points, edges drawn into them (Sloan 1993).
class ConstrainedDelaunay {
  public:
    /// The points' larger extent is the full grid, from -5e8 to 5e8.
    explicit ConstrainedDelaunay(std::vector<GridPoint> points);

    /// Makes the segment an edge, or a chain of edges where it runs through points; each is then drawn once more.
    /// False if it crosses one that was drawn before: then nothing is drawn beyond the crossing.
    bool draw(int from, int to);
    /// Flips edges that were never drawn until triangles are Delaunay.
    void relax();
    /// The triangles that an odd number of drawn edges parts from the outside.
    std::vector<std::array<int, 3>> inside() const;

  private:
    struct Triangle {
        std::array<int, 3> corners{}, neighbors{};
        std::array<int, 3> drawn{};  // how often the edge from corner k to the next one was drawn
    };
    struct Side {
        int triangle = -1, edge = 0;
    };

    const GridPoint& at(int point) const { return points_[static_cast<std::size_t>(point)]; }
    Triangle& triangle(int t) { return triangles_[static_cast<std::size_t>(t)]; }
    const Triangle& triangle(int t) const { return triangles_[static_cast<std::size_t>(t)]; }
    std::vector<int> triangles_about(int point) const;
    Side side(int from, int to) const;
    Side across(Side s) const;
    int opposite(Side s) const;
    bool can_flip(Side s) const;
    void flip(Side s);
    void hand_over(int neighbor, int from, int to);
    void mark(Side s);
    int draw_first(int from, int to);
    bool flip_away(std::vector<std::array<int, 2>> crossed, int from, int to);

    std::vector<GridPoint> points_;
    std::vector<Triangle> triangles_;
    std::vector<int> triangle_of_;  // by point, -1 = none
};

}  // namespace rinceau

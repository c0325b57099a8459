#pragma once
// Outlines that tests draw with: in a frame of their own, about the origin, at most 1 from it unless a size is given.

#include <vector>

#include "geometry/random.h"
#include "scene/element.h"

namespace rinceau::test {

Path polygon(const std::vector<Point>& corners);
std::vector<Path> regular_polygon(int corners, double radius = 1);
/// Four cubics; within 3e-4 of the circle.
std::vector<Path> circle(double radius = 1);
std::vector<Path> rectangle(double width, double height);
std::vector<Path> star(int points, double inner_radius = 0.5);
/// A pointed leaf along +y, mirror symmetric, tip at (0, 1), foot at (0, -1).
std::vector<Path> leaf(double half_width = 0.4);
/// A hook without any symmetry: tells turned and mirrored copies apart.
std::vector<Path> hook();
/// A smooth closed curve through `nodes` random points about the origin; without symmetry.
std::vector<Path> blob(int nodes, Random& random);
/// An open straight line along y of length 2.
std::vector<Path> bar();
/// A frame: an outer polygon and a hole.
std::vector<Path> frame(int corners, double hole = 0.6);

Style filled(Color color);
Style stroked(Color color, double width);
Element element(std::vector<Path> paths, Style style);
/// The element carried along by the map.
Element placed(const Element& element, const Similarity& map);

Color random_color(Random& random);

}  // namespace rinceau::test

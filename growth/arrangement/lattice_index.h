#pragma once
// Points that stand on a lattice, also if each is moved from its place by up to a fifth of a step: column and row of each.
// Internal to the folder.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/point.h"
#include "growth/arrangement/connectivity.h"

namespace rinceau {

struct PointLattice {
    std::vector<std::optional<std::array<int, 2>>> index;  ///< column and row of each point; a few points may have none
    Point origin;                                          ///< place of column 0, row 0
    std::array<Point, 2> basis;  ///< step of a column and of a row: reduced, the second counter-clockwise of the first
    std::vector<std::array<int, 2>> steps;  ///< to neighbours in columns and rows, counter-clockwise; with each its opposite
    std::vector<std::vector<std::array<int, 2>>>
        faces;  ///< of a cell: corners, counter-clockwise, relative to the lowest one
};

/// The lattice, if there is one without doubt: nearly every point has a place of its own, within a share of a step that
/// chance does not give, hardly any place inside is empty, and there are three columns and rows at least. `spacing` is that
/// of the points' connectivity; `free` is how many points chose their places, the others being copies of them.
std::optional<PointLattice> find_lattice(std::span<const Point> points, double spacing, std::size_t free);

/// Neighbours by columns and rows instead of by distances.
Connectivity lattice_connectivity(std::span<const Point> points, const PointLattice& lattice);

}  // namespace rinceau

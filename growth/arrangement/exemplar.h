#pragma once
// The example: which elements it has, which of them are neighbours, and what around an element can be copied (Ijiri et al.
// 2008, section 4).

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/angle.h"
#include "growth/figures.h"

namespace rinceau {

/// The neighbours of an element, counter-clockwise.
struct ExemplarRing {
    std::vector<int> elements;
    std::vector<Point> offsets;  ///< from the element to each
    std::vector<bool> joined;    ///< is neighbour k joined by an edge to the next one, the last to the first?
};

struct ExemplarElement {
    Point position;
    int symbol = 0;     ///< kind: elements of one kind may stand for one another
    int sub_id = 0;     ///< which element of the drawing this is: copies in a tiled exemplar share it
    double radius = 0;  ///< of the circle about the position that holds its outline
    Region outline;     ///< what it paints, relative to its position
    ExemplarRing ring;
    bool usable = false;           ///< has a whole ring of its own: may be chosen for a seed
    std::array<int, 2> lattice{};  ///< column and row, if the exemplar is a lattice
};

/// Elements stand on a lattice: neighbours differ by one of `steps` in column and row.
struct ExemplarLattice {
    std::vector<std::array<int, 2>> steps;  ///< counter-clockwise; the opposite of each is one, too
    std::array<Point, 2> basis;             ///< scene step of a column and of a row, mean
};

struct ExemplarSymbol {
    std::string name;    ///< of the kind: that of its most frequent figure
    double share = 0;    ///< of all elements
    double density = 0;  ///< elements per unit of area
};

/// Example of an arrangement. Lengths are scene lengths.
struct Exemplar {
    std::vector<ExemplarElement> elements;
    /// The first so many are those of the input; the others, of a tiled exemplar, are their copies in the eight tiles
    /// around.
    std::size_t originals = 0;
    std::optional<Box> tile;
    std::vector<ExemplarSymbol> symbols;
    std::vector<std::pair<int, int>> edges;  ///< of the connectivity, lower element first, sorted
    double mean_edge = 1;                    ///< l
    double shortest_edge = 1;
    double longest_edge = 1;
    std::vector<std::vector<double>>
        min_distance;               ///< of centres, per pair of symbols; infinite if a pair was never seen near
    double density = 0;             ///< elements per unit of area
    double largest_empty = 0;       ///< radius of the largest circle without a centre in the inside of the exemplar
    bool outlines_overlap = false;  ///< more than a few outlines of the exemplar cross: then grown ones may, too
    bool irregular = true;          ///< false: a lattice, or rings so alike that no finish is needed
    std::optional<ExemplarLattice> lattice;
};

/// One element before neighbours are known.
struct ExemplarPoint {
    Point position;
    int symbol = 0;
    Region outline;     ///< relative to its position; may be empty in tests
    bool whole = true;  ///< FigureInstance::whole
};

struct ExemplarOptions {
    /// Voronoi vertices nearer to each other than this share of sqrt(area / elements) are one: what is nearly cocircular is
    /// no triangle. 0 = 0.25 for regular exemplars, 0.1 for irregular ones.
    double tie = 0;
    double max_angle = radians(119);  ///< of a triangle at the rim, radians; more -> it is dropped (section 4: 120 degrees)
    bool find_lattice = true;
    std::optional<Box>
        tile;  ///< the exemplar repeats with the width and height of this box: no rim (GROWTH beyond the paper)
    std::vector<std::pair<int, int>>
        flips;  ///< edges to be flipped by hand (section 4, figure 3): elements, as numbered in the input
};

/// Throws InputError in the name of `label`: fewer than 4 elements, elements in one line or in one place, no element with a
/// whole ring, fewer than 4 usable elements in an exemplar that is no lattice, an edge to be flipped that is not there or
/// has no quadrilateral about it. Each message says what can be done.
Exemplar make_exemplar(const std::vector<ExemplarPoint>& points, const std::vector<std::string>& symbol_names,
                       const ExemplarOptions& options, const std::string& label);

/// The same from a drawing; element i of the exemplar is instances[i] of the drawing (with a tile: i modulo their number). A
/// drawing that is a tile comes from as_tile (tile_of_drawing.h). Figures are sorted into kinds: element_kinds (kinds.h).
Exemplar make_exemplar(const FiguredDrawing& drawing, const ExemplarOptions& options, const std::string& label);

}  // namespace rinceau

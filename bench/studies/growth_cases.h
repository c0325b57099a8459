#pragma once
// What the benchmark of growth runs on: lattices and strewn points made here, drawings of a folder, shapes.

#include <optional>
#include <string>
#include <vector>

#include "growth/aggregate/aggregate_options.h"
#include "growth/aggregate/exclusive_region.h"
#include "growth/arrangement/exemplar.h"

namespace rinceau::test {

/// What an exemplar's growth must be.
enum class Demand {
    exact,      ///< a lattice: every ring, every distance
    jittered,   ///< a lattice drawn by hand: every ring
    irregular,  ///< the statistics
};

struct ExemplarCase {
    std::string name;
    Demand demand = Demand::irregular;
    std::optional<Exemplar> exemplar;
    std::string fault;  ///< why there is none
};

std::vector<ExemplarCase> lattice_cases();
/// One, two and three kinds of discs, strewn so that none overlap.
std::vector<ExemplarCase> strewn_cases();
/// Every SVG of the folder whose name holds `only`, as the command reads it: as a tile if it evidently is one.
std::vector<ExemplarCase> drawn_cases(const std::string& folder, const std::string& only);

/// Our own exemplars, samples/growth.
std::vector<ExemplarCase> sample_cases(const std::string& only);

struct ShapeCase {
    std::string name;
    std::vector<ExclusiveRegion> regions;  ///< of silhouettes whose circle has radius 1
    double min_scale = 1, max_scale = 1;
    double share_tolerance = 1;
    double side = 1;  ///< of the square to be filled
};

/// The sets of silhouettes in the folder that figures are known of: boomerang, worm, gecko; two leaves; wrench, saw,
/// feather, snake; all. Those whose names hold `only`. `shapes` are about so many as the default method places.
std::vector<ShapeCase> shape_cases(const std::string& folder, double shapes, const std::string& only);

/// The region of one silhouette, its circle of radius 1.
ExclusiveRegion silhouette(const std::string& file);

}  // namespace rinceau::test

#pragma once
// Where the turtle stands when a part's module is drawn. Parts are centred; productions begin at their first member
// (Stava et al. 2010, r1) or, for rings, at the pivot (docs/analysis.md, 7).

#include <vector>

#include "analyzer/instancing.h"
#include "analyzer/rule_model.h"

namespace rinceau {

struct Anchors {
    std::vector<Similarity> of_part;    ///< turtle frame -> part frame
    std::vector<char> turnable;             ///< looks that may be drawn in any of their equivalent poses: no gradient tells
    std::vector<Similarity> gauge_of_rule;  ///< sequences: how every member is turned, by one of its symmetries, before its anchor
    std::vector<double> largest_scale;  ///< of the turtle at the part's modules, in scene lengths per unit; 0 = not in use
    std::vector<double> extent;         ///< radius of the part in turtle units
};

/// A terminal's turtle frame is the look as it is drawn most often: that size is scale 1, that angle is upright.
Anchors find_anchors(const RuleSet& rules, const Instancing& instancing, const std::vector<int>& roots);

}  // namespace rinceau

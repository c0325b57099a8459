#include "analyzer/natural_pose.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rinceau {

namespace {

constexpr double near_angle = radians(0.5);
constexpr double near_scale = 0.01;
constexpr double outline_reach = 2;  // rms radii that an outline may reach from its centre

struct Leaf {
    Similarity derived;  ///< in the root's frame
    Similarity drawn;    ///< in the scene
    bool continuous = false;
};

void collect_leaves(const RuleSet& rules, int item, const Similarity& derived, std::vector<Leaf>& leaves) {
    const Item& at = rules.items[static_cast<std::size_t>(item)];
    const Part& part = rules.parts[static_cast<std::size_t>(at.part)];
    if (at.members.empty()) leaves.push_back({derived, at.pose, part.symmetry.continuous});
    for (std::size_t k = 0; k < at.members.size(); ++k) {
        if (!is_regular(rules, at, k)) continue;  // an exception puts it where it is drawn
        collect_leaves(rules, at.members[k], derived * part.children[k].pose, leaves);
    }
}

double deviation(const Leaf& leaf, const Similarity& root) {
    const Similarity placed = root * leaf.derived;
    const double turn =
        leaf.continuous ? std::abs(scale_of(placed) - scale_of(leaf.drawn)) : abs(placed.linear - leaf.drawn.linear);
    return abs(placed.translation - leaf.drawn.translation) + outline_reach * turn;
}

double worst(const std::vector<Leaf>& leaves, const Similarity& root) {
    double most = 0;
    for (const Leaf& leaf : leaves) most = std::max(most, deviation(leaf, root));
    return most;
}

/// The same linear part, the place that fits the leaves best.
Similarity placed_best(Similarity root, const std::vector<Leaf>& leaves) {
    Point shift;
    for (const Leaf& leaf : leaves) shift += leaf.drawn.translation - apply(root, leaf.derived.translation);
    root.translation += shift / static_cast<double>(leaves.size());
    return root;
}

}  // namespace

double natural_angle(double angle) {
    const double natural = radians(15 * std::round(degrees(angle) / 15));
    return std::abs(natural - angle) <= near_angle ? natural : angle;
}

Similarity natural_pose(const RuleSet& rules, int root, const Similarity& anchor, double allowed) {
    const Similarity& pose = rules.items[static_cast<std::size_t>(root)].pose;
    std::vector<Leaf> leaves;
    collect_leaves(rules, root, {}, leaves);
    if (leaves.empty()) return pose;
    const double bound = std::max(allowed, worst(leaves, pose));
    const Complex turtle = (pose * anchor).linear;
    const double scale = abs(turtle), angle = arg(turtle);
    const double even = std::abs(scale - 1) <= near_scale ? 1 : scale;
    // Both natural, else one of them.
    for (const auto& [s, a] :
         {std::pair{even, natural_angle(angle)}, std::pair{even, angle}, std::pair{scale, natural_angle(angle)}}) {
        Similarity candidate = pose;
        candidate.linear = pose.linear * (polar(s, a) / turtle);
        candidate = placed_best(candidate, leaves);
        if (worst(leaves, candidate) <= bound) return candidate;
    }
    return pose;
}

}  // namespace rinceau

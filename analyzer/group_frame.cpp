#include "analyzer/group_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rinceau {

std::vector<Similarity> centred(std::vector<Similarity> poses) {
    Point mean;
    for (const Similarity& pose : poses) mean += pose.translation;
    mean = mean / static_cast<double>(poses.size());
    for (Similarity& pose : poses) pose.translation -= mean;
    return poses;
}

Similarity group_pose(std::span<const Similarity> children, std::span<const Similarity> frames,
                      std::span<const double> radii) {
    const bool mirrored = children[0].mirrored != frames[0].mirrored;
    const double share = 1.0 / static_cast<double>(children.size());
    Point child_mean, frame_mean;
    for (std::size_t k = 0; k < children.size(); ++k) {
        child_mean += share * flipped_if(mirrored, children[k].translation);
        frame_mean += share * frames[k].translation;
    }
    // Least squares for a in  a u_k = v_k: offsets of the origins, and linear parts times radius.
    Complex sum{};
    double weight = 0;
    const auto add = [&](Complex u, Complex v, double factor) {
        sum += factor * (conj(u) * v);
        weight += factor * norm(u);
    };
    for (std::size_t k = 0; k < children.size(); ++k) {
        add(flipped_if(mirrored, children[k].translation) - child_mean, frames[k].translation - frame_mean, 1);
        add(flipped_if(mirrored, children[k].linear), frames[k].linear, radii[k] * radii[k]);
    }
    const Complex linear = sum / weight;
    return {linear, frame_mean - linear * child_mean, mirrored};
}

namespace {

constexpr std::size_t most_children_with_symmetry = 130;  // larger groups count as having none

struct Matcher {
    const RuleSet& rules;
    const Part& group;
    double still;
    double turn;

    const Part& part_of(const Child& child) const { return rules.parts[static_cast<std::size_t>(child.part)]; }

    bool same_place(const Child& child, const Similarity& pose) const {
        return abs(child.pose.translation - pose.translation) <= still * scale_of(pose);
    }
    /// Equal up to the part's own symmetry?
    bool same_pose(const Child& child, const Similarity& pose) const {
        if (!same_place(child, pose)) return false;
        const Complex inverse_linear = flipped_if(child.pose.mirrored, Complex{1, 0} / child.pose.linear);
        const Complex ratio = inverse_linear * flipped_if(child.pose.mirrored, pose.linear);
        const SymmetryGroup& symmetry = part_of(child).symmetry;
        if (symmetry.continuous) return std::abs(abs(ratio) - 1) <= turn;
        const bool mirrored = child.pose.mirrored != pose.mirrored;
        return std::ranges::any_of(
            symmetry.elements, [&](const Similarity& s) { return s.mirrored == mirrored && abs(s.linear - ratio) <= turn; });
    }
    bool maps_group_onto_itself(const Similarity& map) const {
        return std::ranges::all_of(group.children, [&](const Child& child) {
            const Similarity image = map * child.pose;
            return std::ranges::any_of(
                group.children, [&](const Child& target) { return target.part == child.part && same_pose(target, image); });
        });
    }
};

/// The maps that could take `child` onto `target`.
std::vector<Similarity> candidate_maps(const Matcher& matcher, const Child& child, const Child& target) {
    std::vector<Similarity> maps;
    const SymmetryGroup& symmetry = matcher.part_of(child).symmetry;
    if (symmetry.continuous) {
        const Complex from = child.pose.translation, to = target.pose.translation;
        if (abs(from) <= matcher.still * scale_of(child.pose)) return maps;
        for (const bool mirrored : {false, true}) {
            const Complex linear = to / flipped_if(mirrored, from);
            maps.push_back({linear / abs(linear), {}, mirrored});
        }
        return maps;
    }
    for (const Similarity& s : symmetry.elements) maps.push_back(target.pose * s * inverse(child.pose));
    return maps;
}

void add_symmetry(SymmetryGroup& symmetry, Similarity map, double turn) {
    map.linear = map.linear / abs(map.linear);
    map.translation = {};
    const bool known = std::ranges::any_of(symmetry.elements, [&](const Similarity& s) {
        return s.mirrored == map.mirrored && abs(s.linear - map.linear) <= turn;
    });
    if (!known) symmetry.elements.push_back(map);
}

SymmetryGroup group_symmetry(const RuleSet& rules, const Part& group, double still, double turn) {
    SymmetryGroup symmetry;
    if (group.children.size() > most_children_with_symmetry) return symmetry;
    const Matcher matcher{rules, group, still, turn};
    // The child that tells most: the farthest out; among concentric ones one with a direction.
    const Child* telling = nullptr;
    double reach = -1;
    for (const Child& child : group.children) {
        const double far = abs(child.pose.translation);
        const bool directed = !matcher.part_of(child).symmetry.continuous;
        const bool concentric = far <= still * scale_of(child.pose);
        const double rank = concentric ? (directed ? 0.0 : -0.5) : far;
        if (rank > reach * (1 + 1e-9)) {
            reach = rank;
            telling = &child;
        }
    }
    if (reach < 0) {  // all concentric and continuous
        symmetry.continuous = true;
        return symmetry;
    }
    for (const Child& target : group.children) {
        const bool comparable =
            target.part == telling->part &&
            std::abs(abs(target.pose.translation) - abs(telling->pose.translation)) <= still * scale_of(telling->pose);
        if (!comparable) continue;
        for (const Similarity& map : candidate_maps(matcher, *telling, target)) {
            const bool isometry =
                std::abs(scale_of(map) - 1) <= turn && abs(map.translation) <= still * scale_of(telling->pose);
            if (isometry && matcher.maps_group_onto_itself({map.linear / abs(map.linear), {}, map.mirrored})) {
                add_symmetry(symmetry, map, turn);
            }
        }
    }
    return symmetry;
}

}  // namespace

Part completed_part(const RuleSet& rules, Part part, double still, double turn) {
    part.radius = 0;
    part.leaves = 0;
    for (const Child& child : part.children) {
        const Part& below = rules.parts[static_cast<std::size_t>(child.part)];
        part.radius = std::max(part.radius, abs(child.pose.translation) + scale_of(child.pose) * below.radius);
        part.leaves += below.leaves;
    }
    part.symmetry = group_symmetry(rules, part, still, turn);
    return part;
}

}  // namespace rinceau

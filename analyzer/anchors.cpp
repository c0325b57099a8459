#include "analyzer/anchors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "analyzer/natural_pose.h"
#include "analyzer/upright_circle.h"

namespace rinceau {

namespace {

/// The pose (size and angle) that most instances of each look share; the first such one.
std::vector<Complex> commonest_poses(const Instancing& instancing) {
    constexpr double bin = 0.01;  // of log size and of radians
    struct Count {
        int times = 0;
        Complex linear;
    };
    std::vector<std::map<std::pair<std::int64_t, std::int64_t>, Count>> counts(instancing.looks.size());
    std::vector<Complex> commonest(instancing.looks.size(), Complex{1, 0});
    std::vector<int> most(instancing.looks.size(), 0);
    for (const Instance& instance : instancing.instances) {
        if (instance.pose.mirrored) continue;
        const auto look = static_cast<std::size_t>(instance.look);
        const std::pair key{std::llround(std::log(scale_of(instance.pose)) / bin),
                            std::llround(arg(instance.pose.linear) / bin)};
        Count& count = counts[look][key];
        if (count.times == 0) count.linear = instance.pose.linear;
        if (++count.times > most[look]) {
            most[look] = count.times;
            commonest[look] = count.linear;
        }
    }
    return commonest;
}

/// A tree's nodes have as many sizes and angles as levels and branches: its largest node is the one to measure by, for all
/// looks that stand there at any depth.
void take_roots_of_trees(const RuleSet& rules, std::vector<Complex>& poses) {
    std::map<std::pair<int, std::size_t>, Complex> largest;  // by rule and member
    std::map<int, std::set<std::pair<int, std::size_t>>> places_of_look;
    for (const Item& item : rules.items) {
        const int index = rules.parts[static_cast<std::size_t>(item.part)].rule;
        if (index < 0 || rules.rules[static_cast<std::size_t>(index)].kind != RuleKind::branch) continue;
        const std::size_t members = rules.rules[static_cast<std::size_t>(index)].members.size();
        for (std::size_t k = 0; k < members && k < item.members.size(); ++k) {
            if (item.members[k] < 0) continue;
            const Item& member = rules.items[static_cast<std::size_t>(item.members[k])];
            const int look = rules.parts[static_cast<std::size_t>(member.part)].look;
            if (look < 0 || member.pose.mirrored) continue;
            places_of_look[look].insert({index, k});
            Complex& most = largest.try_emplace({index, k}, Complex{0, 0}).first->second;
            if (norm(member.pose.linear) > norm(most)) most = member.pose.linear;
        }
    }
    for (const auto& [look, places] : places_of_look) {
        Complex most{0, 0};
        for (const auto& place : places) {
            if (norm(largest[place]) > norm(most)) most = largest[place];
        }
        poses[static_cast<std::size_t>(look)] = most;
    }
}

/// What stands at a tree's nodes and ends beside the first member is drawn as it lies there, in the size that it would have
/// at a node of scale 1: no turns and scales in the rule.
void align_with_nodes(const RuleSet& rules, std::vector<Similarity>& anchors) {
    for (const Rule& rule : rules.rules) {
        if (rule.kind != RuleKind::branch || rule.members.empty()) continue;
        const Child& first = rule.members.front();
        const Similarity turtle = first.pose * anchors[static_cast<std::size_t>(first.part)];
        const auto align = [&](const Child& child) {
            const bool look = rules.parts[static_cast<std::size_t>(child.part)].look >= 0;
            if (!look || child.part == first.part || child.pose.mirrored) return;
            anchors[static_cast<std::size_t>(child.part)].linear = (inverse(child.pose) * turtle).linear;
        };
        for (const Child& member : rule.members) align(member);
        for (const Child& leaf : rule.leaves) align(leaf);
    }
}

/// The middle of the circle, facing the first member, at the member's scale.
Similarity upright_anchor_of(const Rule& rule, const Child& first, const Similarity& member) {
    const Point centre = apply(first.pose, circle_centre(rule));
    const Point way = first.pose.translation - centre;
    return {way / abs(way) * Complex{0, -1} * scale_of(first.pose * member), centre, false};
}

Similarity anchor_of(const RuleSet& rules, const Part& part, const std::vector<Similarity>& anchors) {
    const Child& first = part.children.front();
    const Rule& rule = rules.rules[static_cast<std::size_t>(part.rule)];
    const RuleKind kind = rule.kind;
    if (kind == RuleKind::branch) {  // the same frame at every node, whatever its depth
        const Child& stands = rule.members.empty() ? rule.leaves.front() : rule.members.front();
        return part.node * stands.pose * anchors[static_cast<std::size_t>(stands.part)];
    }
    if (rule.upright) return upright_anchor_of(rule, first, anchors[static_cast<std::size_t>(first.part)]);
    if (kind == RuleKind::spiral) return first.pose * inverse(spiral_pose(rule.spiral, spiral_index(rule.spiral, 0)));
    Similarity member = anchors[static_cast<std::size_t>(first.part)];
    if (kind == RuleKind::linear) member.translation = {};  // alpha and beta are linear about the member's own origin
    const Similarity head = first.pose * translate(rule.seat) * member;
    if (part.pivot) return {part.pivot->linear * (scale_of(head) / scale_of(*part.pivot)), part.pivot->translation, part.pivot->mirrored};
    if (kind != RuleKind::ring) return head;
    // The pivot, facing the first member, at the member's scale.
    const double reach = abs(head.translation);
    const bool off_centre = reach > 1e-9 * scale_of(head);
    const Complex heading = off_centre ? head.translation / reach * Complex{0, -1} : head.linear / scale_of(head);
    return {heading * scale_of(head), {}, false};
}

/// By part: the derived pose of the item that a reader meets first; parts that are not in use have none.
std::vector<std::optional<Similarity>> first_poses(const RuleSet& rules, const std::vector<int>& roots) {
    std::vector<std::optional<Similarity>> poses(rules.parts.size());
    std::vector<std::pair<int, Similarity>> open;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) {
        open.emplace_back(*root, rules.items[static_cast<std::size_t>(*root)].pose);
    }
    while (!open.empty()) {
        const auto [at, pose] = open.back();
        open.pop_back();
        const Item& item = rules.items[static_cast<std::size_t>(at)];
        const Part& part = rules.parts[static_cast<std::size_t>(item.part)];
        auto& first = poses[static_cast<std::size_t>(item.part)];
        if (!first) first = pose;
        for (std::size_t k = item.members.size(); k-- > 0;) {
            if (item.members[k] >= 0) open.emplace_back(item.members[k], pose * part.children[k].pose);
        }
    }
    return poses;
}

/// The symmetry of a part's first member, a look, that makes it as upright in the scene as it can be; `pose` is the part's.
Similarity upright_gauge(const RuleSet& rules, const Part& part, const Similarity& anchor, const Similarity& pose) {
    const Child& first = part.children.front();
    constexpr double clearly = 1e-3;  // radians
    Similarity best;
    const auto tilt = [&](const Similarity& gauge) { return std::abs(arg((pose * first.pose * gauge * anchor).linear)); };
    for (const Similarity& gauge : rules.parts[static_cast<std::size_t>(first.part)].symmetry.elements) {
        if (!gauge.mirrored && tilt(gauge) < tilt(best) - clearly) best = gauge;
    }
    return best;
}

/// A gradient that is symmetric to the eye need not be so to the proof.
bool has_gradient(const Style& style) {
    const auto is_gradient = [](const Paint& paint) { return std::holds_alternative<std::shared_ptr<const Gradient>>(paint); };
    return is_gradient(style.fill) || is_gradient(style.stroke.paint);
}

std::vector<char> turnable_parts(const RuleSet& rules, const Instancing& instancing) {
    std::vector<char> turnable(rules.parts.size(), 0);
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        if (rules.parts[p].look < 0) continue;
        const Look& look = instancing.looks[static_cast<std::size_t>(rules.parts[p].look)];
        turnable[p] = !has_gradient(look.unit_style) && std::ranges::none_of(look.tints, has_gradient);
    }
    return turnable;
}

bool begins_with_a_look(const RuleSet& rules, const Part& part, const std::vector<char>& turnable) {
    const RuleKind kind = rules.rules[static_cast<std::size_t>(part.rule)].kind;
    return (kind == RuleKind::group || kind == RuleKind::sequence) &&
           turnable[static_cast<std::size_t>(part.children.front().part)] != 0;
}

/// Groups and sequences whose first member looks the same when it is turned stand as upright as they can where they are met
/// first. A rule has one gauge for all its counts.
Similarity upright_anchor(const RuleSet& rules, const Part& part, const std::optional<Similarity>& pose, Anchors& anchors,
                          std::vector<bool>& decided) {
    const Child& first = part.children.front();
    const auto rule = static_cast<std::size_t>(part.rule);
    const Similarity& anchor = anchors.of_part[static_cast<std::size_t>(first.part)];
    if (!decided[rule] && pose) {
        anchors.gauge_of_rule[rule] = upright_gauge(rules, part, anchor, *pose);
        decided[rule] = true;
    }
    return first.pose * anchors.gauge_of_rule[rule] * anchor;
}

void spread_scale(const RuleSet& rules, int item, const Anchors& anchors, std::vector<double>& largest) {
    const Item& at = rules.items[static_cast<std::size_t>(item)];
    const auto part = static_cast<std::size_t>(at.part);
    largest[part] = std::max(largest[part], scale_of(at.pose) * scale_of(anchors.of_part[part]));
    for (const int member : at.members) {
        if (member >= 0) spread_scale(rules, member, anchors, largest);
    }
}

}  // namespace

Anchors find_anchors(const RuleSet& rules, const Instancing& instancing, const std::vector<int>& roots) {
    Anchors anchors;
    anchors.of_part.resize(rules.parts.size());
    anchors.extent.resize(rules.parts.size());
    anchors.largest_scale.assign(rules.parts.size(), 0);
    std::vector<Complex> commonest = commonest_poses(instancing);
    take_roots_of_trees(rules, commonest);
    const std::vector<std::optional<Similarity>> poses = first_poses(rules, roots);
    anchors.turnable = turnable_parts(rules, instancing);
    anchors.gauge_of_rule.resize(rules.rules.size());
    std::vector<bool> decided(rules.rules.size(), false);
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        if (rules.parts[p].look < 0) continue;
        const Complex pose = commonest[static_cast<std::size_t>(rules.parts[p].look)];
        anchors.of_part[p].linear = Complex{1, 0} / polar(abs(pose), natural_angle(arg(pose)));
    }
    align_with_nodes(rules, anchors.of_part);
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {  // children come before their parents
        const Part& part = rules.parts[p];
        if (part.look < 0 && begins_with_a_look(rules, part, anchors.turnable)) {
            anchors.of_part[p] = upright_anchor(rules, part, poses[p], anchors, decided);
        } else if (part.look < 0) {
            anchors.of_part[p] = anchor_of(rules, part, anchors.of_part);
        }
        const double reach = abs(anchors.of_part[p].translation);
        anchors.extent[p] = (part.radius + reach) / scale_of(anchors.of_part[p]);
    }
    for (const int root : roots) spread_scale(rules, root, anchors, anchors.largest_scale);
    return anchors;
}

}  // namespace rinceau

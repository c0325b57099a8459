#include "analyzer/gather.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analyzer/group_frame.h"
#include "analyzer/regauge.h"
#include "analyzer/substitute.h"

namespace rinceau {

namespace {

constexpr std::size_t few_missing = 2;  // are named one by one; for more, a sequence with another count stands in
constexpr std::size_t most_children = 400;  // of a part that is looked for member by member

RuleKind kind_of(const SearchState& state, int part) {
    return state.rules.rules[static_cast<std::size_t>(state.part(part).rule)].kind;
}

/// A living run of the same rule at the places from `begin` on.
struct Run {
    int item = -1;
    std::size_t begin = 0, count = 0;
};

std::vector<Run> runs_at(const SearchState& state, GridCache& grids, int p, const Similarity& pose, double distance) {
    const Part& whole = state.part(p);
    std::vector<Run> runs;
    for (std::size_t q = 0; q < state.rules.parts.size(); ++q) {
        const Part& part = state.rules.parts[q];
        if (part.rule != whole.rule || part.count >= whole.count || state.members[q].empty()) continue;
        const Similarity to_run = inverse(part.children.front().pose);
        const std::size_t count = part.children.size();
        for (std::size_t begin = 0; begin + count <= whole.children.size(); ++begin) {
            const Similarity predicted = pose * whole.children[begin].pose * to_run;
            const double reach = distance + abs(predicted.translation - pose.translation);
            const auto match = grids.of(static_cast<int>(q)).find(predicted, reach, link_tolerance(state));
            const bool known = match && std::ranges::find(runs, match->item, &Run::item) != runs.end();
            if (match && !known) runs.push_back({match->item, begin, count});
        }
    }
    return runs;
}

std::optional<Gathered> gather_sequence(const SearchState& state, GridCache& grids, int p, const Similarity& pose,
                                        double distance) {
    const Part& whole = state.part(p);
    const std::size_t count = whole.children.size();
    Gathered plan;
    plan.members.resize(count);
    std::vector<char> taken(count, 0);
    std::size_t present = 0;
    const std::vector<Run> runs = runs_at(state, grids, p, pose, distance);
    for (const Run& run : runs) {
        const auto begin = static_cast<std::ptrdiff_t>(run.begin);
        const auto end = begin + static_cast<std::ptrdiff_t>(run.count);
        if (std::any_of(taken.begin() + begin, taken.begin() + end, [](char t) { return t != 0; })) continue;
        const std::vector<int> members = members_from(state, run.item, pose * whole.children[run.begin].pose);
        for (std::size_t k = 0; k < run.count; ++k) {
            plan.members[run.begin + k].item = members[k];
            taken[run.begin + k] = 1;
            present += members[k] >= 0 ? 1 : 0;
        }
        plan.runs.push_back(run.item);
    }
    const std::size_t of_runs = present;
    std::size_t missing = 0, known = 0;  // gaps, and those that the runs have themselves
    for (std::size_t k = 0; k < count && 2 * (missing + known) <= count; ++k) {
        if (taken[k]) {
            known += plan.members[k].item < 0 ? 1 : 0;
            continue;
        }
        const Similarity place = pose * whole.children[k].pose;
        const double reach = distance + abs(place.translation - pose.translation);
        if (const auto member = gather(state, grids, whole.children[k].part, place, reach); member && member->exceptions == 0) {
            plan.members[k] = *member;
            taken[k] = 1;
            ++present;
        } else {
            ++missing;
        }
    }
    // What reads shorter: the gaps, or the longest run instead, which leaves the other pieces where they were.
    const std::size_t pieces = plan.runs.size() + present - of_runs;
    const bool gaps_are_few = missing <= few_missing + (pieces > 0 ? 2 * (pieces - 1) : 0);
    plan.exceptions = static_cast<int>(missing);
    if (present >= 2 && 2 * (missing + known) <= count && gaps_are_few && !has_even_gaps(taken)) return plan;
    if (plan.runs.empty()) return std::nullopt;
    const int longest = *std::ranges::max_element(plan.runs, {}, [&](int run) { return state.item(run).members.size(); });
    return Gathered{longest, {}, {}, 1};
}

std::optional<Gathered> gather_group(const SearchState& state, GridCache& grids, int p, const Similarity& pose,
                                     double distance, bool witnessed) {
    const Part& whole = state.part(p);
    Gathered plan;
    const int leaves_that_may_lack = (whole.leaves - (witnessed ? 0 : 1)) / 2;
    int missing_leaves = 0;
    for (const Child& child : whole.children) {
        const Similarity place = pose * child.pose;
        auto member = gather(state, grids, child.part, place, distance + abs(place.translation - pose.translation));
        const bool whole_member = member && member->exceptions == 0;
        missing_leaves += whole_member ? 0 : state.part(child.part).leaves;
        if (missing_leaves > leaves_that_may_lack) return std::nullopt;
        plan.exceptions += whole_member ? 0 : 1;
        plan.members.push_back(whole_member ? std::move(*member) : Gathered{});
    }
    return plan;
}

}  // namespace

std::optional<Gathered> gather(const SearchState& state, GridCache& grids, int part, const Similarity& pose, double distance,
                               bool witnessed) {
    if (!state.alive(part).empty()) {
        if (const auto match = grids.of(part).find(pose, distance, link_tolerance(state))) return Gathered{match->item, {}, {}, 0};
    }
    if (state.part(part).rule < 0 || state.part(part).children.size() > most_children) return std::nullopt;
    switch (kind_of(state, part)) {
        case RuleKind::sequence:
            return gather_sequence(state, grids, part, pose, distance);
        case RuleKind::group:
            return gather_group(state, grids, part, pose, distance, witnessed);
        default:
            return std::nullopt;
    }
}

bool has_even_gaps(const std::vector<char>& taken) {
    std::vector<std::size_t> begins, widths;
    for (std::size_t k = 0; k < taken.size(); ++k) {
        if (taken[k]) continue;
        if (k == 0 || taken[k - 1]) {
            begins.push_back(k);
            widths.push_back(0);
        }
        ++widths.back();
    }
    if (begins.size() < 3) return false;
    for (std::size_t g = 2; g < begins.size(); ++g) {
        if (begins[g] - begins[g - 1] != begins[1] - begins[0]) return false;
    }
    return std::ranges::all_of(widths, [&](std::size_t width) { return width == widths.front(); });
}

std::vector<int> members_from(const SearchState& state, int item, const Similarity& first) {
    const Item& run = state.item(item);
    const std::vector<Child>& children = state.part(run.part).children;
    const auto apart = [&](const Child& child) {
        const Similarity place = run.pose * child.pose;
        return abs(place.translation - first.translation) + std::abs(scale_of(place) - scale_of(first));
    };
    std::vector<int> members = run.members;
    if (apart(children.back()) < apart(children.front())) std::ranges::reverse(members);
    return members;
}

int part_of_count(SearchState& state, int rule, int count) {
    for (std::size_t p = 0; p < state.rules.parts.size(); ++p) {
        if (state.rules.parts[p].rule == rule && state.rules.parts[p].count == count) return static_cast<int>(p);
    }
    state.rules.parts.push_back(made_part(state, rule, count));
    state.members.emplace_back();
    state.costs.emplace_back();
    return static_cast<int>(state.rules.parts.size()) - 1;
}

namespace {

/// The pose of an item with these members, and the members' poses in the gauges that it predicts; nothing if one misses its
/// place.
struct Fit {
    Similarity whole;
    std::vector<Similarity> frames;
};

std::optional<Fit> fitted_pose(const SearchState& state, int p, const std::vector<int>& members, const Similarity& near) {
    const Part& part = state.part(p);
    const double sense = guard_slack;
    Fit fit{near, std::vector<Similarity>(members.size())};
    std::vector<Similarity> children, frames;
    std::vector<double> radii;
    std::vector<std::size_t> slots;
    for (std::size_t k = 0; k < members.size(); ++k) {
        if (members[k] < 0 || state.item(members[k]).part != part.children[k].part) continue;
        const Part& below = state.part(part.children[k].part);
        fit.frames[k] = nearest_pose(below, state.item(members[k]).pose, near * part.children[k].pose);
        children.push_back(part.children[k].pose);
        frames.push_back(fit.frames[k]);
        radii.push_back(std::max(1.0, below.radius));
        slots.push_back(k);
    }
    if (slots.empty()) return std::nullopt;
    fit.whole = group_pose(children, frames, radii);
    for (std::size_t n = 0; n < slots.size(); ++n) {
        const Similarity predicted = fit.whole * children[n];
        const double size = scale_of(frames[n]);
        const double far = abs(predicted.translation - fit.whole.translation);
        const double turn = state.tolerance.turn(radii[n]);
        if (predicted.mirrored != frames[n].mirrored ||
            abs(predicted.translation - frames[n].translation) > sense * state.tolerance.shift(size, far) ||
            abs(predicted.linear - frames[n].linear) > sense * turn * size)
            return std::nullopt;
    }
    return fit;
}

/// Has nothing else taken what the plan needs?
bool is_free(const SearchState& state, const Gathered& plan) {
    std::set<int> held;
    for (const int run : plan.runs) {
        if (!state.item(run).alive) return false;
        held.insert(state.item(run).members.begin(), state.item(run).members.end());
    }
    return std::ranges::all_of(plan.members, [&](const Gathered& member) {
        if (member.item >= 0) return state.item(member.item).alive || held.contains(member.item);
        return is_free(state, member);
    });
}

void remove_run(SearchState& state, int run, std::set<int>& touched) {
    Item& item = state.rules.items[static_cast<std::size_t>(run)];
    item.alive = false;
    item.members.clear();
    touched.insert(item.part);
}

}  // namespace

int make_item(SearchState& state, int part, const Gathered& plan, const Similarity& pose, std::set<int>& touched) {
    if (plan.item >= 0) return plan.item;
    if (!is_free(state, plan)) return -1;
    std::vector<int> members;
    for (std::size_t k = 0; k < plan.members.size(); ++k) {
        const Gathered& member = plan.members[k];
        const Child child = state.part(part).children[k];
        members.push_back(member.missing() ? -1 : make_item(state, child.part, member, pose * child.pose, touched));
    }
    const auto fit = fitted_pose(state, part, members, pose);
    if (!fit) return -1;
    for (const int run : plan.runs) remove_run(state, run, touched);
    Item whole;
    whole.part = part;
    whole.pose = fit->whole;
    whole.first = std::numeric_limits<int>::max();
    for (std::size_t k = 0; k < members.size(); ++k) {
        if (members[k] < 0) continue;
        Item& below = state.rules.items[static_cast<std::size_t>(members[k])];
        below.alive = false;
        touched.insert(below.part);
        whole.first = std::min(whole.first, below.first);
        if (below.part == state.part(part).children[k].part) regauge(state.rules, members[k], fit->frames[k]);
    }
    whole.members = std::move(members);
    const int index = static_cast<int>(state.rules.items.size());
    state.rules.items.push_back(std::move(whole));
    state.members[static_cast<std::size_t>(part)].push_back(index);
    touched.insert(part);
    return index;
}

}  // namespace rinceau

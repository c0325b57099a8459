#include "analyzer/propose.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "analyzer/canonical_step.h"
#include "analyzer/regauge.h"
#include "geometry/kd_tree.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

constexpr std::size_t neighbours_in_part = 8;
constexpr std::size_t neighbours_for_triples = 6;
constexpr std::size_t neighbours_in_scene = 12;
constexpr std::size_t small_part = 40;       // all pairs are tried up to here
constexpr std::size_t few_items = 6;         // a single vote is enough up to here
constexpr std::size_t most_sequences = 200;  // hypotheses kept for one part
constexpr std::size_t most_groups = 50;      // ... for one pair of parts
constexpr double cells_per_tolerance = 3;

VoteCell vote_cell(const SearchState& state, int to) {
    VoteCell cell;
    cell.place = cells_per_tolerance * state.tolerance.size;
    cell.spin = cells_per_tolerance * state.tolerance.turn(state.part(to).radius) / 1.5;
    cell.per_distance = state.tolerance.per_distance;
    return cell;
}

/// The living items of a part in a row, with their nearest others: what votes are made of. Others are known by their places
/// in the row.
struct Voting {
    const Part& part;
    const std::vector<int>& items;
    std::vector<Similarity> poses;
    std::vector<int> others;
    std::size_t others_each = 0;

    std::span<const int> near(std::size_t k) const { return {others.data() + k * others_each, others_each}; }
    std::span<const int> nearest_few(std::size_t k) const {
        return near(k).first(std::min(others_each, neighbours_for_triples));
    }
    const Similarity& pose(int k) const { return poses[static_cast<std::size_t>(k)]; }
    int item(int k) const { return items[static_cast<std::size_t>(k)]; }
};

Voting voting_of(const SearchState& state, int p) {
    Voting voting{state.part(p), state.alive(p), {}, {}};
    std::vector<Point> origins;
    voting.poses.reserve(voting.items.size());
    origins.reserve(voting.items.size());
    for (const int i : voting.items) {
        voting.poses.push_back(state.item(i).pose);
        origins.push_back(state.item(i).pose.translation);
    }
    const std::size_t all_others = voting.items.size() - 1;
    voting.others_each = voting.items.size() <= small_part ? all_others : std::min(neighbours_in_part, all_others);
    voting.others = KdTree(origins).nearest_others(voting.others_each);
    return voting;
}

void add_hypothesis(std::vector<Hypothesis>& hypotheses, const Hypothesis& pattern, const StepCluster& cluster,
                    const Similarity& step, std::size_t votes_in_space) {
    Hypothesis hypothesis = pattern;
    hypothesis.step = step;
    hypothesis.turn_change = cluster.turn_change;
    hypothesis.spin_change = cluster.spin_change;
    hypothesis.votes.reserve(cluster.votes.size());
    for (const Voters& vote : cluster.votes) hypothesis.votes.emplace_back(vote.source, vote.target);
    hypothesis.votes_in_space = static_cast<double>(votes_in_space);
    hypotheses.push_back(std::move(hypothesis));
}

void add_hypotheses(std::vector<Hypothesis>& hypotheses, const Hypothesis& pattern, const std::vector<StepCluster>& clusters,
                    std::size_t votes_in_space) {
    for (const StepCluster& cluster : clusters) add_hypothesis(hypotheses, pattern, cluster, cluster.step, votes_in_space);
}

double still_of(const SearchState& state) { return state.tolerance.size; }

/// A clustered step stands for all step * t, t a symmetry of the part; a sequence under each of them runs another way. Those
/// that pairs of votes in a row suggest by their turn, the commonest first.
std::vector<Similarity> continuing_steps(const SearchState& state, const Part& part, const StepCluster& cluster) {
    constexpr std::size_t most_variants = 3;
    if (part.symmetry.elements.size() < 2 || abs(cluster.step.translation) <= still_of(state)) return {cluster.step};
    // The votes stand in the order of their sources.
    const std::vector<Voters>& votes = cluster.votes;
    struct Variant {
        Similarity step;
        int pairs = 0;
    };
    std::vector<Variant> variants;
    for (const Similarity& t : part.symmetry.elements) {
        const Similarity step = cluster.step * t;
        if (!step.mirrored) variants.push_back({step, 0});
    }
    std::ranges::stable_sort(variants, {}, [](const Variant& v) { return std::abs(arg(v.step.linear)); });
    const double turn = state.tolerance.turn(part.radius) + state.tolerance.shift(1, 0);
    for (const Voters& vote : votes) {
        const Point here = state.item(vote.target).pose.translation;
        const Point way = here - state.item(vote.source).pose.translation;
        const auto first = std::ranges::lower_bound(votes, vote.target, {}, &Voters::source);
        const auto last = std::ranges::upper_bound(votes, vote.target, {}, &Voters::source);
        for (const Voters& onward : std::span(first, last)) {
            if (onward.target == vote.source) continue;
            const Complex ratio = (state.item(onward.target).pose.translation - here) / way;
            for (Variant& variant : variants) {
                if (abs(ratio / abs(ratio) - variant.step.linear / abs(variant.step.linear)) <= turn) ++variant.pairs;
            }
        }
    }
    std::ranges::stable_sort(variants, [](const Variant& v, const Variant& w) { return v.pairs > w.pairs; });
    std::vector<Similarity> steps;
    for (const Variant& variant : variants) {
        if (variant.pairs > 0 && steps.size() < most_variants) steps.push_back(variant.step);
    }
    if (steps.empty()) steps.push_back(variants.empty() ? cluster.step : variants.front().step);
    return steps;
}

/// Constant steps between directed items, and concentric steps of any.
void propose_constant_steps(const SearchState& state, int p, const Voting& voting, std::vector<Hypothesis>& hypotheses) {
    const Part& part = voting.part;
    const VoteCell cell = vote_cell(state, p);
    StepVotes votes;
    for (std::size_t k = 0; k < voting.items.size(); ++k) {
        const Similarity from_here = inverse(voting.poses[k]);
        for (const int j : voting.near(k)) {
            const Similarity step = from_here * voting.pose(j);
            if (part.symmetry.continuous && abs(step.translation) > still_of(state)) continue;
            const Similarity canonical = canonical_step(part, part, step, still_of(state));
            votes.add({canonical, voting.items[k], voting.item(j)}, step_coordinates(canonical, cell));
        }
    }
    const std::size_t least = voting.items.size() <= few_items ? 1 : 2;
    for (const StepCluster& cluster : votes.clusters(least, most_sequences)) {
        for (const Similarity& step : continuing_steps(state, part, cluster)) {
            add_hypothesis(hypotheses, {RuleKind::sequence, p, p}, cluster, step, votes.size());
        }
    }
}

/// Parts without direction: pairs (distance and size) and triples (turn as well).
void propose_directed_steps(const SearchState& state, int p, const Voting& voting, std::vector<Hypothesis>& hypotheses) {
    const VoteCell cell = vote_cell(state, p);
    StepVotes pairs, triples;
    for (std::size_t k = 0; k < voting.items.size(); ++k) {
        const Similarity& a = voting.poses[k];
        for (const int j : voting.near(k)) {
            const Similarity& b = voting.pose(j);
            const Point way = b.translation - a.translation;
            const double advance = abs(way) / scale_of(a);
            const double growth = scale_of(b) / scale_of(a);
            if (advance <= still_of(state)) continue;
            const Voters voters{voting.items[k], voting.item(j)};
            const Similarity pair{{growth, 0}, {0, advance}, false};
            if (growth <= 1 + state.tolerance.angle)
                pairs.add({pair, voters.source, voters.target}, step_coordinates(pair, cell));
            for (const int l : voting.nearest_few(static_cast<std::size_t>(j))) {
                if (static_cast<std::size_t>(l) == k) continue;
                const Similarity& c = voting.pose(l);
                const Point next_way = c.translation - b.translation;
                const double reach = state.tolerance.shift(scale_of(b), abs(next_way));
                if (std::abs(abs(next_way) - advance * scale_of(b)) > reach) continue;
                if (std::abs(scale_of(c) / scale_of(b) / growth - 1) > state.tolerance.turn(1)) continue;
                const double turn = arg(next_way / way);
                // Walked the other way, an even chain turns the other way.
                if (turn < -state.tolerance.angle && std::abs(growth - 1) <= state.tolerance.angle) continue;
                const Similarity step{polar(growth, turn), {0, advance}, false};
                triples.add({step, voters.source, voters.target}, step_coordinates(step, cell));
            }
        }
    }
    Hypothesis pattern{RuleKind::sequence, p, p};
    pattern.directed = true;
    add_hypotheses(hypotheses, pattern, triples.clusters(1, most_sequences), triples.size());
    pattern.pairs_only = true;
    const std::size_t least = voting.items.size() <= few_items ? 1 : 2;
    add_hypotheses(hypotheses, pattern, pairs.clusters(least, most_sequences), pairs.size());
}

/// A step of two neighbours, and whether they have one heading.
struct NearStep {
    TurtleStep turtle;
    bool upright = false;
};

/// The steps from every item of a row to its nearest few, in a row as well. Of symmetric items, those poses are compared
/// that turn least.
std::vector<NearStep> steps_to_nearest_few(const SearchState& state, const Voting& voting) {
    const bool symmetric = voting.part.symmetry.elements.size() > 2;
    const double turn = state.tolerance.turn(voting.part.radius);
    std::vector<NearStep> steps;
    for (std::size_t k = 0; k < voting.items.size(); ++k) {
        const Similarity& here = voting.poses[k];
        const Similarity from_here = inverse(here);
        for (const int j : voting.nearest_few(k)) {
            const Similarity step =
                from_here * (symmetric ? nearest_pose(voting.part, voting.pose(j), here) : voting.pose(j));
            steps.push_back(
                {to_turtle_step(step, still_of(state)), !step.mirrored && abs(step.linear - Complex{1, 0}) <= turn});
        }
    }
    return steps;
}

/// The angle between two steps, as the first item sees it.
double bend(const Voting& voting, std::size_t first, std::size_t second, std::size_t third) {
    const Point here = voting.poses[second].translation;
    const double angle = arg((voting.poses[third].translation - here) / (here - voting.poses[first].translation));
    return voting.poses[first].mirrored ? -angle : angle;
}

/// Steps of constant d and s whose alpha and beta grow evenly (eq. 4); of symmetric parts only those that turn nothing,
/// along a circle.
void propose_linear_steps(const SearchState& state, int p, const Voting& voting, std::vector<Hypothesis>& hypotheses) {
    constexpr double largest_change = pi / 3;
    constexpr double largest_upright_change = 1.01 * two_pi / 5;  // five make the smallest circle
    const bool symmetric = voting.part.symmetry.elements.size() > 2;
    const VoteCell cell = vote_cell(state, p);
    const std::vector<NearStep> steps = steps_to_nearest_few(state, voting);
    const std::size_t few = voting.nearest_few(0).size();
    StepVotes bent, upright;
    for (std::size_t k = 0; k < voting.items.size(); ++k) {
        for (std::size_t n = 0; n < few; ++n) {
            const auto& [t1, upright1] = steps[k * few + n];
            if (t1.advance <= 0 || t1.mirrored || (symmetric && !upright1)) continue;
            const auto j = static_cast<std::size_t>(voting.near(k)[n]);
            for (std::size_t m = 0; m < few; ++m) {
                if (static_cast<std::size_t>(voting.near(j)[m]) == k) continue;
                const auto& [t2, upright2] = steps[j * few + m];
                if (t2.mirrored || std::abs(t2.advance - t1.advance) > state.tolerance.shift(1, t1.advance)) continue;
                if (std::abs(t2.scale / t1.scale - 1) > state.tolerance.turn(1)) continue;
                const bool keeps_heading = upright1 && upright2;
                if (symmetric && !keeps_heading) continue;
                const double turn_change = keeps_heading ? bend(voting, k, j, static_cast<std::size_t>(voting.near(j)[m]))
                                                         : wrap_angle(t2.turn - t1.turn);
                const double spin_change = keeps_heading ? -turn_change : wrap_angle(t2.spin - t1.spin);
                const double largest = keeps_heading ? largest_upright_change : largest_change;
                if (std::abs(turn_change) > largest || std::abs(spin_change) > largest) continue;
                if (std::abs(turn_change) + std::abs(spin_change) < 2 * state.tolerance.angle) continue;
                const Similarity first = to_similarity(t1);
                const StepVote vote{first, voting.items[k], voting.items[j], turn_change, spin_change};
                (keeps_heading ? upright : bent).add(vote, linear_coordinates(vote, cell));
            }
        }
    }
    Hypothesis pattern{RuleKind::linear, p, p};
    add_hypotheses(hypotheses, pattern, bent.clusters(2, most_sequences), bent.size());
    pattern.upright = true;
    add_hypotheses(hypotheses, pattern, upright.clusters(3, most_sequences), upright.size());
}

}  // namespace

std::vector<Hypothesis> propose_sequences(const SearchState& state, int p) {
    std::vector<Hypothesis> hypotheses;
    const std::vector<int>& items = state.alive(p);
    if (items.size() < 2) return hypotheses;
    const Voting voting = voting_of(state, p);
    propose_constant_steps(state, p, voting, hypotheses);
    if (state.part(p).symmetry.continuous) {
        propose_directed_steps(state, p, voting, hypotheses);
    } else if (items.size() >= 4) {
        propose_linear_steps(state, p, voting, hypotheses);
    }
    return hypotheses;
}

namespace {

/// Less symmetric parts lead: their frame says more.
bool leads(const SearchState& state, int a, int b) {
    const auto rank = [&](int p) {
        const SymmetryGroup& symmetry = state.part(p).symmetry;
        return symmetry.continuous ? std::size_t{1000} : symmetry.elements.size();
    };
    return std::pair{rank(a), a} < std::pair{rank(b), b};
}

struct PairSpace {
    StepVotes votes;
    bool directed = false;
};

}  // namespace

std::vector<Hypothesis> propose_groups(const SearchState& state, const std::vector<int>& items) {
    std::vector<int> living;
    for (const auto& members : state.members) living.insert(living.end(), members.begin(), members.end());
    std::ranges::sort(living);
    std::vector<Point> origins;
    for (const int i : living) origins.push_back(state.item(i).pose.translation);
    std::vector<Hypothesis> hypotheses;
    if (living.size() < 2) return hypotheses;
    const KdTree tree(origins);

    std::map<std::pair<int, int>, PairSpace> spaces, directed_spaces;
    for (const int i : items) {
        for (const Neighbor& neighbour : tree.nearest(state.item(i).pose.translation, neighbours_in_scene + 1)) {
            const int j = living[neighbour.index];
            const int part_of_i = state.item(i).part, part_of_j = state.item(j).part;
            if (part_of_i == part_of_j) continue;
            const bool i_leads = leads(state, part_of_i, part_of_j);
            const int from = i_leads ? i : j, to = i_leads ? j : i;
            const Part& from_part = state.part(state.item(from).part);
            const Part& to_part = state.part(state.item(to).part);
            Similarity step = step_between(state.item(from).pose, state.item(to).pose);
            const bool directed = from_part.symmetry.continuous && abs(step.translation) > still_of(state);
            if (directed) {
                step = {{abs(step.linear), 0}, {0, abs(step.translation)}, false};
            } else {
                step = canonical_step(from_part, to_part, step, still_of(state));
            }
            auto& map = directed ? directed_spaces : spaces;
            const std::pair key{state.item(from).part, state.item(to).part};
            const auto at = map.try_emplace(key).first;
            at->second.directed = directed;
            at->second.votes.add({step, from, to}, step_coordinates(step, vote_cell(state, key.second)));
        }
    }
    for (const auto* map : {&spaces, &directed_spaces}) {
        for (const auto& [key, space] : *map) {
            const std::size_t least =
                std::min(state.alive(key.first).size(), state.alive(key.second).size()) <= few_items ? 1 : 2;
            Hypothesis pattern{RuleKind::group, key.first, key.second};
            pattern.directed = space.directed;
            add_hypotheses(hypotheses, pattern, space.votes.clusters(least, most_groups), space.votes.size());
        }
    }
    return hypotheses;
}

}  // namespace rinceau

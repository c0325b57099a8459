#include "analyzer/evaluate.h"

#include <math.h>  // lgamma_r, of POSIX

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analyzer/claim_pairs.h"
#include "analyzer/fit_step.h"
#include "analyzer/upright_circle.h"

namespace rinceau {

const PoseGrid& GridCache::of(int part) {
    auto& grid = grids_[part];
    if (!grid) grid = std::make_unique<PoseGrid>(state_->rules, part, state_->alive(part));
    return *grid;
}

namespace {

constexpr double rule_head_bits = 9;
constexpr double instance_bits = 6;    // the count m of one use of a sequence
constexpr double linear_bits = 24;     // the two changes of a linear rule
constexpr double upright_bits = 10;    // the one change of a circle whose members keep their heading
constexpr double directed_bits = 10;   // saying that the heading follows the step
constexpr double closing_credit = 26;  // the last pair of groups joins even at this loss, so that the axiom is one symbol
constexpr std::size_t closing_groups = 3;
constexpr double ambiguity_price = 0.75;
constexpr double turn_price = 1;  // a square lattice is rows as well as rings of four: of equals, rows are what a person sees
constexpr double false_alarm_bits = -7;
constexpr double link_hope = 1.5;  // links that a sequence may have for each vote of neighbours
constexpr double link_slack = 2;

/// Where the search starts: all items, or only those that voted when these are few.
std::vector<int> sources_of(const SearchState& state, const Hypothesis& hypothesis) {
    constexpr std::size_t few = 8;
    const std::vector<int>& all = state.alive(hypothesis.from);
    if (few * hypothesis.votes.size() >= all.size()) return all;
    std::vector<int> sources;
    for (const auto& [from, to] : hypothesis.votes) sources.push_back(from);
    std::ranges::sort(sources);
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    return sources;
}

/// Pairs for a group of two parts; each item in at most one pair, the nearer to the prediction first.
std::vector<Chain> group_pairs(const SearchState& state, GridCache& grids, const Hypothesis& hypothesis,
                               const Similarity& step, double& ambiguity) {
    std::vector<PairCandidate> candidates;
    const PoseTolerance tolerance = link_tolerance(state);
    const PoseGrid& grid = grids.of(hypothesis.to);
    const Part& from_part = state.part(hypothesis.from);
    const auto consider = [&](int from, const Similarity& frame) {
        const Similarity predicted = frame * step;
        const auto match = grid.find(predicted, abs(predicted.translation - frame.translation), tolerance);
        if (!match) return;
        const Similarity gauge = state.part(hypothesis.to).symmetry.elements[static_cast<std::size_t>(match->gauge)];
        Similarity target = state.item(match->item).pose * gauge;
        if (state.part(hypothesis.to).symmetry.continuous) {  // no angle of its own: the predicted one
            target.linear = predicted.linear * (abs(target.linear) / abs(predicted.linear));
            target.mirrored = predicted.mirrored;
        }
        candidates.push_back({match->shift, {{from, match->item}, {frame, target}, false, 0}});
    };
    if (hypothesis.directed) {
        for (const auto& [from, to] : hypothesis.votes) {
            if (!state.item(from).alive || !state.item(to).alive) continue;
            const Point way = state.item(to).pose.translation - state.item(from).pose.translation;
            consider(from, {scale_of(state.item(from).pose) * (way / abs(way) * Complex{0, -1}),
                            state.item(from).pose.translation, false});
        }
    } else {
        for (const int from : sources_of(state, hypothesis)) {
            if (!state.item(from).alive) continue;
            for (const Similarity& gauge : from_part.symmetry.elements) consider(from, state.item(from).pose * gauge);
        }
    }
    return claimed_pairs(state.rules, std::move(candidates), ambiguity);
}

std::vector<Chain> pairs_of_votes(const SearchState& state, const Hypothesis& hypothesis) {
    std::vector<Chain> pairs;
    for (const auto& [from, to] : hypothesis.votes) {
        if (!state.item(from).alive || !state.item(to).alive) continue;
        const Similarity& a = state.item(from).pose;
        const Similarity& b = state.item(to).pose;
        const Point way = b.translation - a.translation;
        const Complex heading = way / abs(way) * Complex{0, -1};
        pairs.push_back({{from, to},
                         {{scale_of(a) * heading, a.translation, false}, {scale_of(b) * heading, b.translation, false}},
                         false,
                         0});
    }
    return pairs;
}

std::vector<Chain> linear_of_equal_start(const SearchState& state, GridCache& grids, const Hypothesis& hypothesis,
                                         Similarity& first_step) {
    Rule rule;
    rule.kind = RuleKind::linear;
    rule.turn_change = hypothesis.turn_change;
    rule.spin_change = hypothesis.spin_change;
    const PoseGrid& grid = grids.of(hypothesis.from);
    auto found = hypothesis.upright
                     ? upright_chains(state.rules, grid, hypothesis.votes, hypothesis.turn_change, link_tolerance(state))
                     : linear_chains(state.rules, grid, hypothesis.votes, rule, link_tolerance(state));
    if (found.empty()) return {};
    // The longest chain and those that begin as it does: one production.
    const auto longest = std::ranges::max_element(found, {}, [](const LinearChain& c) { return c.chain.items.size(); });
    first_step = longest->first_step;
    std::vector<Chain> chains;
    for (const LinearChain& each : found) {
        const bool alike = abs(each.first_step.translation - first_step.translation) <= state.tolerance.size &&
                           abs(each.first_step.linear - first_step.linear) <= state.tolerance.angle;
        if (alike) chains.push_back(each.chain);
    }
    return chains;
}

std::vector<Chain> chains_of(const SearchState& state, GridCache& grids, const Hypothesis& hypothesis, Similarity& step,
                             double& ambiguity) {
    if (hypothesis.kind == RuleKind::group) return group_pairs(state, grids, hypothesis, step, ambiguity);
    if (hypothesis.kind == RuleKind::linear) {
        return claimed(state.rules, linear_of_equal_start(state, grids, hypothesis, step));
    }
    if (hypothesis.pairs_only) return claimed(state.rules, pairs_of_votes(state, hypothesis));
    const PoseGrid& grid = grids.of(hypothesis.from);
    if (hypothesis.directed) {
        return claimed(state.rules, directed_chains(state.rules, grid, hypothesis.votes, step, link_tolerance(state)));
    }
    return claimed(state.rules,
                   sequence_chains(state.rules, grid, sources_of(state, hypothesis), step, link_tolerance(state)));
}

struct Tally {
    double pairs = 0, chains = 0, gap_bits = 0, residual_bits = 0, repeats = 0;
    std::size_t longest = 0;
};

Tally tally(const SearchState& state, const std::vector<Chain>& chains, const Similarity& step, bool constant) {
    Tally sum;
    std::map<std::size_t, int> by_length;
    for (const Chain& chain : chains) {
        sum.chains += 1;
        sum.longest = std::max(sum.longest, chain.items.size());
        sum.repeats += by_length[chain.items.size()]++ > 0 ? 1 : 0;
        for (std::size_t k = 0; k + 1 < chain.items.size(); ++k) {
            const Item& a = state.item(chain.items[k]);
            const Item& b = state.item(chain.items[k + 1]);
            const double gap = abs(a.pose.translation - b.pose.translation) - scale_of(a.pose) * state.part(a.part).radius -
                               scale_of(b.pose) * state.part(b.part).radius;
            sum.pairs += 1;
            sum.gap_bits += std::log2(1 + std::max(0.0, gap) / state.neighbour_distance);
            if (!constant) continue;
            const Point predicted = apply(chain.frames[k] * step, {});
            const double size = state.tolerance.size * scale_of(b.pose);
            sum.residual_bits += std::log2(1 + abs(predicted - chain.frames[k + 1].translation) / size);
        }
    }
    return sum;
}

/// Probability that an item of the part stands by chance where a link looks for one.
double chance_of_link(const SearchState& state, const Hypothesis& hypothesis) {
    const PartCost& cost = state.cost(hypothesis.to);
    const double sides = cost.neighbour_distance / state.cost(hypothesis.from).size;  // in sizes of `from`
    const double density = 0.25 / (sides * sides);  // of random points with that mean distance to the nearest
    const double reach = abs(hypothesis.step.translation);
    const double shift = link_slack * state.tolerance.shift(1, reach);
    // Pairs of undirected parts look anywhere on a circle, everything else at a point.
    const double area = hypothesis.pairs_only || (hypothesis.directed && hypothesis.kind == RuleKind::group)
                            ? two_pi * 2 * reach * shift
                            : pi * shift * shift;
    return std::min(0.5, density * area) * std::exp2(-cost.angle_bits - cost.scale_bits);
}

/// std::lgamma would tell the sign in a variable that all threads share.
double log2_gamma(double x) {
    int sign = 0;
    return ::lgamma_r(x, &sign) / std::log(2.0);
}

}  // namespace

/// Expected number, as a power of two, of such findings in a drawing without structure: the first link is anyone's (the
/// second as well where it sets the turn), each further one a coincidence, each further chain may begin anywhere.
double log2_chance(const SearchState& state, const Hypothesis& hypothesis, double links, double chains) {
    const double given = hypothesis.directed && !hypothesis.pairs_only && hypothesis.kind != RuleKind::group ? 2
                         : hypothesis.kind == RuleKind::linear                                               ? 2
                                                                                                             : 1;
    const double beginnings = static_cast<double>(state.alive(hypothesis.from).size());
    return std::log2(std::max(1.0, hypothesis.votes_in_space)) +
           std::max(0.0, links - given) * std::log2(chance_of_link(state, hypothesis)) +
           (chains - 1) * std::log2(beginnings) - log2_gamma(chains);
}

namespace {

int known_rule(const SearchState& state, const Hypothesis& hypothesis, const Similarity& step) {
    if (hypothesis.kind != RuleKind::sequence) return -1;
    const double turn = state.tolerance.turn(state.part(hypothesis.from).radius);
    for (std::size_t r = 0; r < state.rules.rules.size(); ++r) {
        const Rule& rule = state.rules.rules[r];
        if (rule.kind != RuleKind::sequence || rule.repeated != hypothesis.from) continue;
        const bool alike =
            rule.step.mirrored == step.mirrored &&
            abs(rule.step.translation - step.translation) <= state.tolerance.shift(1, abs(step.translation)) &&
            abs(rule.step.linear - step.linear) <= turn;
        if (alike) return static_cast<int>(r);
    }
    return -1;
}

/// Do the steps differ by so little that they find the same?
bool much_the_same(const SearchState& state, const Similarity& a, const Similarity& b) {
    constexpr double little = 0.01;  // of the tolerance
    return abs(a.translation - b.translation) <= little * state.tolerance.size &&
           abs(a.linear - b.linear) <= little * state.tolerance.angle;
}

bool closes_the_scene(const SearchState& state, const Hypothesis& hypothesis, const Evaluation& evaluation) {
    const std::size_t living = state.alive(hypothesis.from).size();
    return hypothesis.kind == RuleKind::sequence && state.part(hypothesis.from).rule >= 0 && living <= closing_groups &&
           evaluation.chains.size() == 1 && evaluation.chains.front().items.size() == living;
}

}  // namespace

PoseTolerance link_tolerance(const SearchState& state) {
    return {link_slack * state.tolerance.size, link_slack * state.tolerance.angle, state.tolerance.per_distance};
}

double optimistic_score(const SearchState& state, const Hypothesis& hypothesis, const SearchOptions& options) {
    if (options.objective == Objective::paper) return greatest_importance(options.weights);
    const bool closing = state.part(hypothesis.from).rule >= 0 && state.alive(hypothesis.from).size() <= closing_groups;
    const auto votes = static_cast<double>(hypothesis.votes.size());
    if (!closing && log2_chance(state, hypothesis, link_hope * votes, 1) > false_alarm_bits) return 0;
    const double pairs = static_cast<double>(std::min(hypothesis.votes.size(), state.alive(hypothesis.from).size()));
    return link_hope * pairs * state.cost(hypothesis.to).item_bits + (pairs <= closing_groups ? closing_credit : 0);
}

Evaluation evaluate(const SearchState& state, GridCache& grids, const Hypothesis& hypothesis, const SearchOptions& options,
                    std::size_t rivals) {
    Evaluation evaluation;
    evaluation.step = hypothesis.step;
    evaluation.chains = chains_of(state, grids, hypothesis, evaluation.step, evaluation.ambiguity);
    evaluation.gain = evaluation.score = -1;
    if (evaluation.chains.empty()) return evaluation;
    if (hypothesis.kind != RuleKind::linear) {
        // Refine the step on its chains and extract again; keep the better of both.
        Similarity refined = mean_step(evaluation.chains);
        if (hypothesis.directed && hypothesis.kind == RuleKind::group) refined.translation = {0, abs(refined.translation)};
        double again_ambiguity = 1;
        std::vector<Chain> again;
        if (much_the_same(state, evaluation.step, refined)) {
            evaluation.step = refined;
        } else {
            again = chains_of(state, grids, hypothesis, refined, again_ambiguity);
        }
        const auto links = [](const std::vector<Chain>& chains) {
            std::ptrdiff_t count = 0;
            for (const Chain& chain : chains) count += static_cast<std::ptrdiff_t>(chain.items.size()) - 1;
            return count;
        };
        if (!again.empty() && links(again) >= links(evaluation.chains)) {
            evaluation.chains = std::move(again);
            evaluation.step = refined;
            evaluation.ambiguity = again_ambiguity;
        }
    }
    evaluation.known_rule = known_rule(state, hypothesis, evaluation.step);
    if (options.objective == Objective::paper) {
        evaluation.terms = importance_terms(state, evaluation.chains, evaluation.step);
        evaluation.gain = evaluation.score = 1;  // whatever repeats is taken
        return evaluation;
    }
    const bool repeats = hypothesis.kind != RuleKind::group;
    const Tally sum = tally(state, evaluation.chains, evaluation.step, hypothesis.kind != RuleKind::linear);
    double rule_bits = 0;
    if (evaluation.known_rule < 0) {
        rule_bits = rule_head_bits + step_bits(state, hypothesis.from, hypothesis.to, evaluation.step);
        if (hypothesis.kind == RuleKind::linear) rule_bits += hypothesis.upright ? upright_bits : linear_bits;
        if (hypothesis.directed) rule_bits += directed_bits;
        const double select = std::log2(1.0 + static_cast<double>(rivals));
        rule_bits += sum.pairs <= 3 ? select : 0.5 * select;
    }
    const double item_bits = state.cost(hypothesis.to).item_bits;
    const double use_bits = repeats ? instance_bits * sum.chains : 0;
    evaluation.gain = sum.pairs * item_bits - use_bits - rule_bits;
    const bool closing = closes_the_scene(state, hypothesis, evaluation);
    if (closing && evaluation.gain > -closing_credit) {
        evaluation.gain = evaluation.score = std::max(evaluation.gain, 1.0);
        return evaluation;
    }
    if (evaluation.known_rule < 0 && log2_chance(state, hypothesis, sum.pairs, sum.chains) > false_alarm_bits) {
        evaluation.gain = evaluation.score = -1;
        return evaluation;
    }
    const ImportanceWeights& w = options.weights;
    const double future = options.future * item_bits * (repeats ? sum.repeats : sum.pairs - 1);
    evaluation.score = w.count * (sum.pairs * item_bits + future) - w.length * use_bits - 2 * w.nearness * sum.gap_bits -
                       w.similarity * sum.residual_bits - rule_bits;
    // Two halves in one place are one thing, if each has its partner there: whatever is said of the one, is said of both.
    const bool on_each_other = repeats && abs(evaluation.step.translation) <= state.tolerance.size &&
                               std::abs(std::log(scale_of(evaluation.step))) <= state.tolerance.angle;
    if (on_each_other && sum.pairs + sum.chains == static_cast<double>(state.alive(hypothesis.from).size()))
        evaluation.score += w.count * sum.pairs * item_bits;
    constexpr double turned = 0.01;  // radians
    if (repeats && std::abs(arg(evaluation.step.linear)) > turned) evaluation.score -= turn_price;
    // A partner that could as well be another one is no partner: rows and rings of each part come first.
    evaluation.score -= ambiguity_price * (evaluation.ambiguity - 1) * sum.pairs * item_bits;
    return evaluation;
}

}  // namespace rinceau

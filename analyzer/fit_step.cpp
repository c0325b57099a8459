#include "analyzer/fit_step.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>

#include "analyzer/canonical_step.h"
#include "analyzer/group_frame.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

Similarity mean_step(std::span<const Chain> chains) {
    Similarity mean{{0, 0}, {0, 0}, false};
    double log_size = 0, count = 0;
    for (const Chain& chain : chains) {
        for (std::size_t k = 0; k + 1 < chain.frames.size(); ++k) {
            const Similarity step = step_between(chain.frames[k], chain.frames[k + 1]);
            const double size = abs(step.linear);
            mean.mirrored = step.mirrored;
            mean.linear += step.linear / size;
            mean.translation += step.translation;
            log_size += std::log(size);
            ++count;
        }
    }
    mean.translation = mean.translation / count;
    mean.linear = mean.linear * (std::exp(log_size / count) / abs(mean.linear));
    return mean;
}

namespace {

/// What may change in a rule's step, as numbers: position, log scale, angle; for linear rules the changes and the seat as well.
struct Parameters {
    static Eigen::VectorXd of(const Rule& rule) {
        Eigen::VectorXd values(rule.kind == RuleKind::linear ? 11 : 4);
        values.head<4>() << rule.step.translation.x, rule.step.translation.y, std::log(scale_of(rule.step)),
            arg(rule.step.linear);
        if (rule.kind == RuleKind::linear) {
            values.tail<7>() << rule.turn_change, rule.spin_change, rule.advance_change, std::log(rule.advance_factor),
                rule.size_change, rule.seat.x, rule.seat.y;
        }
        return values;
    }
    static Rule in(Rule rule, const Eigen::VectorXd& values) {
        rule.step.translation = {values(0), values(1)};
        rule.step.linear = polar(std::exp(values(2)), values(3));
        if (rule.kind == RuleKind::linear) {
            rule.turn_change = values(4);
            rule.spin_change = rule.upright ? -values(4) : values(5);
            rule.advance_change = values(6);
            rule.advance_factor = std::exp(values(7));
            rule.size_change = values(8);
            rule.seat = {values(9), values(10)};
        }
        return rule;
    }
};

/// Per item of a chain: shift and turn against the rule, in item sizes, the chain in its best pose.
void add_residuals(const Rule& rule, const Chain& chain, double radius, std::vector<double>& residuals) {
    std::vector<Similarity> poses = repetition_poses(rule, static_cast<int>(chain.frames.size()));
    std::vector<Similarity> frames = chain.frames;
    std::size_t present = 0;
    for (std::size_t k = 0; k < poses.size(); ++k) {
        if (k < chain.items.size() && chain.items[k] < 0) continue;
        poses[present] = poses[k];
        frames[present++] = frames[k];
    }
    poses.resize(present);
    frames.resize(present);
    const std::vector<double> radii(poses.size(), radius);
    const Similarity whole = group_pose(poses, frames, radii);
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const Similarity predicted = whole * poses[k];
        const double size = scale_of(frames[k]);
        const Point shift = (predicted.translation - frames[k].translation) / size;
        const Complex turn = (predicted.linear - frames[k].linear) * (radius / size);
        residuals.insert(residuals.end(), {shift.x, shift.y, turn.x, turn.y});
    }
}

Eigen::VectorXd all_residuals(const Rule& rule, std::span<const Chain> chains, double radius) {
    std::vector<double> residuals;
    for (const Chain& chain : chains) add_residuals(rule, chain, radius, residuals);
    return Eigen::Map<const Eigen::VectorXd>(residuals.data(), static_cast<Eigen::Index>(residuals.size()));
}

/// Gauss-Newton with numerical derivatives over the parameters that are `free`; the chains' poses are eliminated (variable
/// projection). Keeps the best rule met.
Rule gauss_newton(const Rule& start, std::span<const Chain> chains, double radius, std::span<const int> free) {
    constexpr int most_rounds = 12;
    constexpr double probe = 1e-6;
    constexpr double enough = 1e-12;
    Rule best = start;
    Eigen::VectorXd residuals = all_residuals(best, chains, radius);
    double error = residuals.squaredNorm();
    for (int round = 0; round < most_rounds && std::isfinite(error); ++round) {
        const Eigen::VectorXd at = Parameters::of(best);
        Eigen::MatrixXd jacobian(residuals.size(), static_cast<Eigen::Index>(free.size()));
        for (std::size_t c = 0; c < free.size(); ++c) {
            Eigen::VectorXd moved = at;
            const double h = probe * std::max(1.0, std::abs(at(free[c])));
            moved(free[c]) += h;
            jacobian.col(static_cast<Eigen::Index>(c)) =
                (all_residuals(Parameters::in(best, moved), chains, radius) - residuals) / h;
        }
        const Eigen::VectorXd change = jacobian.colPivHouseholderQr().solve(-residuals);
        // Halve the change until the error falls.
        bool better = false;
        for (double share = 1; share > 0.05 && !better; share /= 2) {
            Eigen::VectorXd moved = at;
            for (std::size_t c = 0; c < free.size(); ++c) moved(free[c]) += share * change(static_cast<Eigen::Index>(c));
            const Rule candidate = Parameters::in(best, moved);
            const Eigen::VectorXd candidate_residuals = all_residuals(candidate, chains, radius);
            const double candidate_error = candidate_residuals.squaredNorm();
            if (candidate_error < error) {
                better = true;
                const double gain = error - candidate_error;
                best = candidate;
                residuals = candidate_residuals;
                error = candidate_error;
                if (gain < enough * error) return best;
            }
        }
        if (!better) break;
    }
    return best;
}

/// A ring of n turns by 2 pi k / n and neither grows nor mirrors.
Rule closed_rule(Rule rule, int n) {
    const double turns = arg(rule.step.linear) * n / two_pi;
    rule.step.linear = polar(1, two_pi * std::round(turns) / n);
    return rule;
}

/// What a linear rule has, may change: what it does not say stays unsaid.
std::vector<int> free_parameters(const Rule& rule) {
    if (rule.kind != RuleKind::linear) return {0, 1, 2, 3};
    if (rule.upright) return {0, 1, 4};
    std::vector<int> free{0, 1, 3};
    const bool straight = rule.advance_change != 0 || rule.advance_factor != 1 || rule.size_change != 0;
    if (rule.size_change == 0 && rule.advance_factor == 1) free.push_back(2);
    if (!straight || rule.turn_change != 0 || rule.spin_change != 0) free.insert(free.end(), {4, 5});
    if (rule.advance_change != 0) free.push_back(6);
    if (rule.advance_factor != 1) free.push_back(7);
    if (rule.size_change != 0) free.push_back(8);
    if (rule.seat.x != 0 || rule.seat.y != 0) free.insert(free.end(), {9, 10});
    return free;
}

std::vector<int> without(std::vector<int> free, std::initializer_list<int> fixed) {
    for (const int each : fixed) std::erase(free, each);
    return free;
}

constexpr std::size_t most_fitted_items = 20'000;  // enough to fit 4 numbers; keeps the cost of a fit bounded

/// Every so manieth chain, so that not more items than that take part.
std::vector<Chain> sampled(std::span<const Chain> chains) {
    std::size_t items = 0;
    for (const Chain& chain : chains) items += chain.items.size();
    const std::size_t stride = 1 + items / most_fitted_items;
    std::vector<Chain> some;
    for (std::size_t c = 0; c < chains.size(); c += stride) some.push_back(chains[c]);
    return some;
}

}  // namespace

Rule fitted(const Rule& rule, std::span<const Chain> chains, double radius) {
    const std::vector<Chain> some = sampled(chains);
    if (rule.kind == RuleKind::ring) {
        const Rule closed = closed_rule(rule, static_cast<int>(chains.front().items.size()));
        constexpr int place_only[] = {0, 1};
        return gauss_newton(closed, some, radius, place_only);
    }
    return gauss_newton(rule, some, radius, free_parameters(rule));
}

double worst_deviation(const Rule& rule, std::span<const Chain> chains, double radius) {
    double worst = 0;
    for (const Chain& chain : chains) {
        std::vector<double> residuals;
        add_residuals(rule, chain, radius, residuals);
        for (std::size_t k = 0; k + 3 < residuals.size(); k += 4) {
            const double shift = std::hypot(residuals[k], residuals[k + 1]);
            const double turn = std::hypot(residuals[k + 2], residuals[k + 3]);
            worst = std::max(worst, shift + turn);
        }
    }
    return worst;
}

namespace {

/// The nearest multiple of 15 degrees.
double natural_angle(double angle) { return radians(15 * std::round(degrees(angle) / 15)); }

/// May all members of the rule keep their heading, on a circle?
bool may_be_upright(const Rule& rule) {
    constexpr double nearly = 0.05;  // radians and relative: what is not, does not fit in the end
    return rule.kind == RuleKind::linear && rule.advance_change == 0 && rule.advance_factor == 1 && rule.size_change == 0 &&
           rule.seat == Point{} && !rule.step.mirrored && rule.turn_change != 0 &&
           abs(rule.step.linear - Complex{1, 0}) < nearly && std::abs(rule.turn_change + rule.spin_change) < nearly;
}

Rule made_upright(Rule rule) {
    rule.upright = true;
    rule.step.linear = {1, 0};
    rule.spin_change = -rule.turn_change;
    return rule;
}

/// The rule whose every `count`-th member would stand on the first one.
Rule closed_circle(Rule rule, std::size_t count) {
    rule.turn_change = std::copysign(two_pi / static_cast<double>(count), rule.turn_change);
    rule.spin_change = -rule.turn_change;
    return rule;
}

}  // namespace

Rule with_natural_values(Rule rule, std::span<const Chain> chains, double radius, double slack) {
    const std::vector<Chain> some = sampled(chains);
    double allowed = worst_deviation(rule, some, radius) + slack;
    const auto adopt = [&](const Rule& candidate) {
        if (worst_deviation(candidate, some, radius) > allowed) return false;
        rule = candidate;
        return true;
    };
    if (may_be_upright(rule) && adopt(gauss_newton(made_upright(rule), some, radius, free_parameters(made_upright(rule))))) {
        constexpr int place_only[] = {0, 1};
        if (!adopt(gauss_newton(closed_circle(rule, some.front().items.size()), some, radius, place_only))) {
            Rule even = rule;
            even.turn_change = radians(std::round(degrees(rule.turn_change)));
            even.spin_change = -even.turn_change;
            adopt(gauss_newton(even, some, radius, place_only));
        }
        return rule;
    }
    if (rule.kind != RuleKind::ring) {
        // What is left free makes up for what is made natural.
        const std::vector<int> all_but_scale = without(free_parameters(rule), {2});
        const std::vector<int> places = without(free_parameters(rule), {2, 3});
        Rule even = rule;
        even.step.linear = even.step.linear / scale_of(even.step);
        adopt(gauss_newton(even, some, radius, all_but_scale));
        Rule straight = rule;
        straight.step.linear = polar(scale_of(rule.step), natural_angle(arg(rule.step.linear)));
        adopt(gauss_newton(straight, some, radius, places));
    }
    // The direction of the advance, against the element's heading or, for a steady turn, against the bisector.
    const double length = abs(rule.step.translation);
    if (length > 0) {
        Rule aimed = rule;
        aimed.step.translation = polar(length, natural_angle(arg(rule.step.translation)));
        adopt(aimed);
    }
    if (rule.kind == RuleKind::linear) {
        Rule even = rule;
        even.turn_change = natural_angle(2 * rule.turn_change) / 2;
        adopt(even);
        even = rule;
        even.spin_change = natural_angle(2 * rule.spin_change) / 2;
        adopt(even);
    }
    return rule;
}

}  // namespace rinceau

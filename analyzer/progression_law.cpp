#include "analyzer/progression_law.h"

#include <algorithm>
#include <cmath>

#include "analyzer/fit_step.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

/// A value that may change evenly from step to step.
struct Line {
    double first = 0, change = 0;
    double off_constant = 0, off_line = 0;  // largest distance of a value from the mean and from the line
};

Line line_of(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    double sum = 0, sum_k = 0, sum_kk = 0, sum_ky = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const auto x = static_cast<double>(k);
        sum += values[k];
        sum_k += x;
        sum_kk += x * x;
        sum_ky += x * values[k];
    }
    Line line;
    line.change = (n * sum_ky - sum_k * sum) / (n * sum_kk - sum_k * sum_k);
    line.first = (sum - line.change * sum_k) / n;
    for (std::size_t k = 0; k < values.size(); ++k) {
        line.off_constant = std::max(line.off_constant, std::abs(values[k] - sum / n));
        line.off_line =
            std::max(line.off_line, std::abs(values[k] - line.first - line.change * static_cast<double>(k)));
    }
    return line;
}

/// Angles that follow each other without jumps by whole turns.
std::vector<double> unwrapped(std::vector<double> angles) {
    for (std::size_t k = 1; k < angles.size(); ++k) angles[k] = angles[k - 1] + wrap_angle(angles[k] - angles[k - 1]);
    return angles;
}

std::vector<double> logarithms(std::vector<double> values) {
    for (double& value : values) value = std::log(value);
    return values;
}

/// What the steps of a row say, lengths in sizes of the first member.
struct Measured {
    std::vector<double> sizes, distances, own_distances, directions, turns;  // own: in sizes of the member before
};

Measured measured(const Chain& row) {
    Measured m;
    const double unit = scale_of(row.frames.front());
    for (const Similarity& frame : row.frames) m.sizes.push_back(scale_of(frame) / unit);
    for (std::size_t k = 0; k + 1 < row.frames.size(); ++k) {
        const Similarity step = inverse(row.frames[k]) * row.frames[k + 1];
        const TurtleStep turtle = to_turtle_step(step);
        m.own_distances.push_back(turtle.advance);
        m.distances.push_back(turtle.advance * m.sizes[k]);
        m.directions.push_back(turtle.turn);
        m.turns.push_back(arg(step.linear));
    }
    m.directions = unwrapped(std::move(m.directions));
    m.turns = unwrapped(std::move(m.turns));
    return m;
}

class LawFinder {
  public:
    LawFinder(const SearchState& state, int p, const Chain& row, double slack)
        : row_(row), m_(measured(row)), slack_(slack), part_(state.part(p)), radius_(std::max(1.0, part_.radius)) {
        nearest_ = *std::ranges::min_element(m_.own_distances);
    }

    std::optional<Progression> run() {
        if (!(nearest_ > slack_) || !choose_sizes()) return std::nullopt;
        const Line turns = line_of(m_.turns), directions = line_of(m_.directions);
        const double angle = 2 * slack_ / radius_;
        if (turns.off_line > angle) return std::nullopt;
        const double aim = angle + 2 * slack_ / nearest_;
        const bool turning = turns.off_constant > angle;
        const bool bending = directions.off_constant > aim;
        rule_.turn_change = bending || turning ? directions.change : 0;
        rule_.spin_change = bending || turning ? turns.change - directions.change : 0;
        const bool even_distances = choose_distances();
        if (even_distances && directions.off_line <= aim) {
            // Of undirected members a steady bend is an arc, which has a constant step.
            const bool bends_only = part_.symmetry.continuous || !(bending || turning);
            if (bends_only && !grows_) return std::nullopt;
            set_step(turns, directions);
            if (auto found = tried()) return found;
        }
        if (part_.symmetry.continuous || !turning) return std::nullopt;
        return seated(turns, directions);
    }

  private:
    /// Constant, even or geometric sizes; false if none holds.
    bool choose_sizes() {
        const Line even = line_of(m_.sizes), geometric = line_of(logarithms(m_.sizes));
        const double smallest = *std::ranges::min_element(m_.sizes);
        const double fine = 2 * slack_ / radius_;
        if (geometric.off_constant <= fine) return true;
        if (geometric.off_line <= fine) {
            scale_ = std::exp(geometric.change);
            return true;
        }
        if (even.off_line > fine * smallest) return false;
        rule_.size_change = even.change / even.first;
        grows_ = true;
        return true;
    }

    bool choose_distances() {
        const std::vector<double>& distances = scale_ == 1 ? m_.distances : m_.own_distances;
        const Line even = line_of(distances), geometric = line_of(logarithms(distances));
        const double fine = 2 * slack_;
        advance_ = even.first + even.change * 0.5 * static_cast<double>(distances.size() - 1);
        if (even.off_constant <= fine) return true;
        if (even.off_line <= fine) {
            advance_ = even.first;
            rule_.advance_change = even.change;
            grows_ = true;
            return true;
        }
        if (scale_ != 1 || geometric.off_line * *std::ranges::max_element(distances) > fine) return false;
        advance_ = std::exp(geometric.first);
        rule_.advance_factor = std::exp(geometric.change);
        grows_ = true;
        return true;
    }

    void set_step(const Line& turns, const Line& directions) {
        const double turn = rule_.turn_change != 0 ? directions.first
                                                   : directions.first + directions.change * middle();
        const double whole = rule_.turn_change + rule_.spin_change != 0 ? turns.first : turns.first + turns.change * middle();
        rule_.kind = RuleKind::linear;
        rule_.step = to_similarity({turn, advance_, scale_, whole - turn, false});
    }
    double middle() const { return 0.5 * static_cast<double>(m_.turns.size() - 1); }

    std::optional<Progression> tried() const {
        const Rule rule = fitted(rule_, {&row_, 1}, radius_);
        const double worst = worst_deviation(rule, {&row_, 1}, radius_);
        if (!(worst <= slack_)) return std::nullopt;
        return Progression{rule, worst};
    }

    /// The seat unknown: from several guesses about the member, at its centroid and around.
    std::optional<Progression> seated(const Line& turns, const Line& directions) {
        constexpr int guesses = 8;
        std::optional<Progression> best;
        for (int guess = 0; guess < guesses; ++guess) {
            rule_.seat = polar(radius_, two_pi * guess / guesses);
            rule_.turn_change = 0.5 * turns.change;
            rule_.spin_change = 0.5 * turns.change;
            rule_.advance_change = 0;
            rule_.advance_factor = 1;
            set_step(turns, directions);
            const auto found = tried();
            if (found && (!best || found->worst < best->worst)) best = found;
        }
        return best;
    }

    const Chain& row_;
    Measured m_;
    double slack_;
    const Part& part_;
    double radius_;
    double nearest_ = 0;  // the shortest step
    Rule rule_;
    double scale_ = 1, advance_ = 0;
    bool grows_ = false;  // distances or sizes, as no constant step does
};

}  // namespace

std::optional<Progression> progression_of(const SearchState& state, int p, const Chain& row, double slack) {
    return LawFinder(state, p, row, slack).run();
}

}  // namespace rinceau

#include "lsystem/drag_point.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lsystem/number_slots.h"

namespace rinceau {

namespace {

constexpr int most_steps = 12;
constexpr int most_dampings = 5;
constexpr double first_damping = 1e-9;
constexpr double damping_growth = 100;
constexpr double largest_turn = 40;     ///< degrees in one step: beyond, a turn is not nearly linear
constexpr double largest_growth = 0.4;  ///< share of a scale in one step
constexpr std::size_t most_numbers = 2;

using Values = std::vector<double>;

/// A little of the number, to see what it does.
double trial(const GrammarNumber& number) {
    constexpr double degrees_tried = 1e-3;
    constexpr double share_tried = 1e-5;
    constexpr double least_length = 1e-4;
    if (number.kind == NumberKind::angle) return degrees_tried;
    if (number.kind == NumberKind::scale) return share_tried * number.value;
    return std::max(least_length, share_tried * std::abs(number.value));
}

double bounded_step(const GrammarNumber& number, double value, double step) {
    if (number.kind == NumberKind::angle) return std::clamp(step, -largest_turn, largest_turn);
    if (number.kind == NumberKind::scale) return std::clamp(step, -largest_growth * value, largest_growth * value);
    const double wanted = value + step;
    return std::clamp(wanted, number.low, number.high) - value;
}

/// The step of least squares towards what is left, a little shorter the more it is damped.
std::array<double, most_numbers> damped_step(const std::vector<Point>& columns, Point left, double damping) {
    std::array<double, most_numbers> step{};
    if (columns.size() == 1) {
        const double size = norm(columns[0]) * (1 + damping);
        if (size > 0) step[0] = dot(columns[0], left) / size;
        return step;
    }
    const double a = norm(columns[0]) * (1 + damping);
    const double b = dot(columns[0], columns[1]);
    const double c = norm(columns[1]) * (1 + damping);
    const double determinant = a * c - b * b;
    if (!(determinant > 0)) return step;
    const double u = dot(columns[0], left);
    const double v = dot(columns[1], left);
    step[0] = (c * u - b * v) / determinant;
    step[1] = (a * v - b * u) / determinant;
    return step;
}

/// The point as a function of the numbers.
class Approaching {
  public:
    Approaching(const PointDrag& drag, const AttachedPoint& point, const std::vector<GrammarNumber>& numbers)
        : drag_(drag), point_(point), numbers_(numbers) {}

    std::optional<Point> at(const Values& values) const {
        const auto pose = drag_.pose(point_, numbers_, values);
        if (!pose) return std::nullopt;
        return apply(*pose, point_.local);
    }

    std::vector<Point> columns(const Values& values, Point here) const {
        std::vector<Point> found;
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            Values tried = values;
            const double step = trial(numbers_[i]);
            tried[i] += step;
            const auto there = at(tried);
            found.push_back(there ? (*there - here) / step : Point{});
        }
        return found;
    }

    /// Values nearest to the target, from these on; nothing if there is no place at them.
    std::optional<Values> nearest(Values values, Point target, double tolerance) const {
        auto here = at(values);
        if (!here) return std::nullopt;
        for (int step = 0; step < most_steps && abs(target - *here) > tolerance; ++step) {
            const std::vector<Point> slopes = columns(values, *here);
            if (!improve(values, *here, slopes, target)) break;
        }
        return values;
    }

    /// As few digits as the tolerance allows.
    Values shortened(Values values, double tolerance) const {
        const auto here = at(values);
        if (!here) return values;
        const std::vector<Point> slopes = columns(values, *here);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double slope = abs(slopes[i]);
            if (slope <= 0 || values[i] == numbers_[i].value) continue;
            const double unit = std::pow(10.0, std::floor(std::log10(tolerance / slope)));
            values[i] = rounded(std::round(values[i] / unit) * unit);
        }
        return values;
    }

  private:
    const PointDrag& drag_;
    const AttachedPoint& point_;
    const std::vector<GrammarNumber>& numbers_;

    bool improve(Values& values, Point& here, const std::vector<Point>& slopes, Point target) const {
        double damping = first_damping;
        for (int i = 0; i < most_dampings; ++i, damping = std::max(damping, 1e-3) * damping_growth) {
            const auto step = damped_step(slopes, target - here, damping);
            Values tried = values;
            for (std::size_t k = 0; k < tried.size(); ++k) tried[k] += bounded_step(numbers_[k], values[k], step[k]);
            const auto there = at(tried);
            if (!there || abs(target - *there) >= abs(target - here)) continue;
            values = std::move(tried);
            here = *there;
            return true;
        }
        return false;
    }
};

Values own_values(const std::vector<GrammarNumber>& numbers) {
    Values values;
    for (const GrammarNumber& number : numbers) values.push_back(number.value);
    return values;
}

}  // namespace

PointDrag::PointDrag(const Grammar& written, const Grammar& resolved, const DeriveOptions& options)
    : options_(options),
      constants_before_(static_cast<int>(resolved.constants.size()) - static_cast<int>(written.constants.size())) {
    grammar_.constants = resolved.constants;
    grammar_.axiom = resolved.axiom;
    grammar_.productions = resolved.productions;
    grammar_.exceptions = resolved.exceptions;
    grammar_.seed = resolved.seed;
    grammar_.ignored = resolved.ignored;
    for (const NumberedStyle& style : resolved.styles) grammar_.styles.push_back({.number = style.number});
    for (const Terminal& terminal : resolved.terminals)
        grammar_.terminals.push_back({.symbol = terminal.symbol, .style = terminal.style});
}

std::optional<Similarity> PointDrag::pose(const AttachedPoint& point, const std::vector<GrammarNumber>& numbers,
                                          const std::vector<double>& values) const {
    try {
        if (numbers.empty()) return pose_on_path(grammar_, point.order, point.module, options_);
        Grammar changed = grammar_;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            for (NumberSlot slot : numbers[i].slots) {
                if (slot.in != NumberSlot::In::expression) continue;
                if (slot.place.in == ExpressionPlace::In::constant) slot.place.index += constants_before_;
                changed = with_slot(std::move(changed), slot, number_expression(values[i]));
            }
        }
        return pose_on_path(changed, point.order, point.module, options_);
    } catch (const InputError&) {  // a scale of 0, say
        return std::nullopt;
    } catch (const LimitError&) {
        return std::nullopt;
    }
}

std::optional<PointChange> PointDrag::change(const AttachedPoint& point, const GrammarNumber& number) const {
    const double step = trial(number);
    const auto before = pose(point);
    const auto after = pose(point, {number}, {number.value + step});
    if (!before || !after) return std::nullopt;
    const Complex turned = after->linear / before->linear;
    return PointChange{(apply(*after, point.local) - apply(*before, point.local)) / step, arg(turned) / step,
                       std::log(abs(turned)) / step};
}

std::optional<std::vector<double>> PointDrag::solve(const AttachedPoint& point, const std::vector<GrammarNumber>& numbers,
                                                    Point target, double tolerance, double snap) const {
    constexpr double search_share = 0.1;    // of the tolerance: what rounding may use up is the rest ..
    constexpr double rounding_share = 0.4;  // .. for each of two numbers
    const Values start = own_values(numbers);
    const Approaching all(*this, point, numbers);
    const auto here = all.at(start);
    if (!here || abs(target - *here) <= tolerance) return here ? std::optional(start) : std::nullopt;
    for (std::size_t i = 0; numbers.size() > 1 && i < numbers.size(); ++i) {
        const std::vector<GrammarNumber> one{numbers[i]};
        const Approaching alone(*this, point, one);
        const auto found = alone.nearest({start[i]}, target, search_share * tolerance);
        const auto there = found ? alone.at(*found) : std::nullopt;
        if (!there || abs(target - *there) > snap) continue;
        Values values = start;
        values[i] = alone.shortened(*found, rounding_share * tolerance).front();
        return values;
    }
    const auto found = all.nearest(start, target, search_share * tolerance);
    if (!found || *found == start) return std::nullopt;
    return all.shortened(*found, rounding_share * tolerance);
}

}  // namespace rinceau

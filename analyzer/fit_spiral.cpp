#include "analyzer/fit_spiral.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/kd_tree.h"

namespace rinceau {

namespace {

constexpr std::size_t least_members = 16;
constexpr std::size_t inner_points = 48;      // among which the angle is looked for
constexpr std::size_t least_run = 7;          // points in a row that show it
constexpr double near_angle = 0.08;           // radians: two increments are the same
constexpr double straight = 0.035;            // radians: an angle this near to 0 or half a turn makes a row
constexpr double match_share = 0.3;           // of the distance to the nearest point: how far off a prediction may be
constexpr double least_power = 0.1, most_power = 3;
constexpr std::size_t most_fitted = 1500;     // enough for 7 numbers

using Parameters = Eigen::Matrix<double, 9, 1>;
enum : int { at_pivot_x, at_pivot_y, at_phase, at_angle, at_reach, at_power, at_start, at_seat_x, at_seat_y };

/// Where the member k steps after the first is expected. `phase` is the direction of the first.
Point place_of(const Parameters& p, double k) {
    const double index = std::max(0.0, p(at_start) + k);
    const double reach = std::exp(p(at_reach)) * std::pow(index, p(at_power));
    return Point{p(at_pivot_x), p(at_pivot_y)} + Point(polar(reach, p(at_phase) + p(at_angle) * k));
}

/// Points numbered along the spiral: member k is points[order[k - first]].
struct Numbered {
    int first = 0;
    std::vector<int> order;
};

struct Fitter {
    std::span<const Point> points;
    const Numbered& numbered;
    std::span<const Complex> linear = {};  // of the members, or none: their seat is 0

    /// How far member `number` stands from its place.
    Point miss(const Parameters& p, int number) const {
        const auto k = static_cast<std::size_t>(number - numbered.first);
        Point there = points[static_cast<std::size_t>(numbered.order[k])];
        if (!linear.empty()) there += Point(linear[k] * Complex{p(at_seat_x), p(at_seat_y)});
        return place_of(p, number) - there;
    }
    /// Every so manieth member; the one in the pivot says nothing about the law.
    std::vector<int> sample(const Parameters& p) const {
        const std::size_t stride = 1 + numbered.order.size() / most_fitted;
        std::vector<int> some;
        for (std::size_t k = 0; k < numbered.order.size(); k += stride) {
            constexpr double in_the_pivot = 0.25;
            const int number = numbered.first + static_cast<int>(k);
            if (p(at_start) + number > in_the_pivot) some.push_back(number);
        }
        return some;
    }
    Eigen::VectorXd residuals(const Parameters& p, const std::vector<int>& members) const {
        Eigen::VectorXd all(2 * static_cast<Eigen::Index>(members.size()));
        for (std::size_t r = 0; r < members.size(); ++r) {
            const Point shift = miss(p, members[r]);
            all(2 * static_cast<Eigen::Index>(r)) = shift.x;
            all(2 * static_cast<Eigen::Index>(r) + 1) = shift.y;
        }
        return all;
    }
    double worst(const Parameters& p) const {
        double far = 0;
        for (std::size_t k = 0; k < numbered.order.size(); ++k) {
            far = std::max(far, abs(miss(p, numbered.first + static_cast<int>(k))));
        }
        return far;
    }
};

/// Levenberg and Marquardt's least squares over the free parameters.
Parameters refined(const Fitter& fitter, Parameters best, const std::vector<int>& free) {
    constexpr int most_rounds = 30;
    constexpr double probe = 1e-6, enough = 1e-14;
    const std::vector<int> members = fitter.sample(best);
    Eigen::VectorXd residuals = fitter.residuals(best, members);
    double error = residuals.squaredNorm(), damping = 1e-3;
    const auto columns = static_cast<Eigen::Index>(free.size());
    for (int round = 0; round < most_rounds; ++round) {
        Eigen::MatrixXd jacobian(residuals.size(), columns);
        for (Eigen::Index c = 0; c < columns; ++c) {
            Parameters moved = best;
            const int parameter = free[static_cast<std::size_t>(c)];
            const double h = probe * std::max(1.0, std::abs(best(parameter)));
            moved(parameter) += h;
            jacobian.col(c) = (fitter.residuals(moved, members) - residuals) / h;
        }
        const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
        const Eigen::VectorXd slope = jacobian.transpose() * residuals;
        bool better = false;
        constexpr double most_damping = 1e8;
        while (!better && damping < most_damping) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() *= 1 + damping;
            const Eigen::VectorXd change = damped.ldlt().solve(-slope);
            Parameters moved = best;
            for (Eigen::Index c = 0; c < columns; ++c) moved(free[static_cast<std::size_t>(c)]) += change(c);
            const bool sound = moved(at_power) > least_power && moved(at_power) < most_power &&
                               moved(at_start) + fitter.numbered.first > -0.5;
            const Eigen::VectorXd moved_residuals = fitter.residuals(moved, members);
            const double moved_error = moved_residuals.squaredNorm();
            if (sound && moved_error < error) {
                better = true;
                const bool done = error - moved_error < enough * error;
                best = moved;
                residuals = moved_residuals;
                error = moved_error;
                damping /= 10;
                if (done) return best;
            } else {
                damping *= 10;
            }
        }
        if (!better) break;
    }
    return best;
}

const std::vector<int> law_parameters{at_pivot_x, at_pivot_y, at_phase, at_angle, at_reach, at_power, at_start};
const std::vector<int> law_and_seat{at_pivot_x, at_pivot_y, at_phase, at_angle, at_reach,
                                    at_power,   at_start,   at_seat_x, at_seat_y};

/// A run of points, each turned against the one before by about the same angle, seen from the pivot.
struct Run {
    std::vector<int> points;
    std::vector<double> radii;
    double angle = 0, phase = 0;
    double agreeing = 0;  // share of all increments, in a row or not
    double gap = 0;       // mean difference of radii
};

std::vector<int> innermost(std::span<const Point> points, std::vector<int> order, Point pivot, std::size_t most) {
    const auto nearer = [&](int a, int b) {
        const double da = norm(points[static_cast<std::size_t>(a)] - pivot);
        const double db = norm(points[static_cast<std::size_t>(b)] - pivot);
        return std::pair{da, a} < std::pair{db, b};
    };
    const std::size_t count = std::min(most, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(), nearer);
    order.resize(count);
    return order;
}

/// Nothing if a point stands in the pivot that cannot be the spiral's own.
std::optional<Run> longest_run(std::span<const Point> points, const std::vector<int>& among, Point pivot) {
    std::vector<int> order = innermost(points, among, pivot, inner_points);
    const auto radius = [&](int i) { return abs(points[static_cast<std::size_t>(i)] - pivot); };
    // What lies in the pivot has no direction.
    constexpr double in_the_pivot = 0.2;
    if (order.size() > 2 && radius(order[0]) < in_the_pivot * radius(order[1])) order.erase(order.begin());
    std::vector<double> increments;
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
        const Complex a = points[static_cast<std::size_t>(order[k])] - pivot;
        const Complex b = points[static_cast<std::size_t>(order[k + 1])] - pivot;
        if (!(abs(a) > 0)) return std::nullopt;
        increments.push_back(arg(b / a));
    }
    // The commonest increment.
    const auto agree = [](double a, double b) { return std::abs(wrap_angle(a - b)) < near_angle; };
    double commonest = 0;
    std::ptrdiff_t most = 0;
    for (const double increment : increments) {
        const auto votes = std::ranges::count_if(increments, [&](double other) { return agree(other, increment); });
        if (votes > most) {
            most = votes;
            commonest = increment;
        }
    }
    std::size_t begin = 0, length = 0;
    for (std::size_t k = 0; k < increments.size();) {
        std::size_t end = k;
        while (end < increments.size() && agree(increments[end], commonest)) ++end;
        if (end - k > length) {
            begin = k;
            length = end - k;
        }
        k = end + 1;
    }
    Run run;
    run.agreeing = static_cast<double>(most) / static_cast<double>(std::max<std::size_t>(1, increments.size()));
    run.gap = (radius(order.back()) - radius(order.front())) / static_cast<double>(order.size());
    double excess = 0;
    for (std::size_t k = begin; k <= begin + length; ++k) {
        run.points.push_back(order[k]);
        run.radii.push_back(radius(order[k]));
        if (k < begin + length) excess += wrap_angle(increments[k] - commonest);
    }
    run.angle = commonest + excess / static_cast<double>(std::max<std::size_t>(1, length));
    run.phase = arg(points[static_cast<std::size_t>(order[begin])] - pivot);
    return run;
}

/// The run seen from near `pivot`: where that shows a part of one, a place beside it may show all. (A spiral that begins far
/// from its pivot has radii that differ by less than the pivot is known.)
std::optional<std::pair<Run, Point>> run_near(std::span<const Point> points, Point pivot) {
    std::vector<int> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    const std::vector<int> among = innermost(points, std::move(all), pivot, 3 * inner_points);
    std::optional<Run> best = longest_run(points, among, pivot);
    if (!best) return std::nullopt;
    Point seen_from = pivot;
    constexpr double promising = 0.2;
    if (best->points.size() < 2 * least_run && best->agreeing > promising) {
        constexpr int reach = 4;
        const double step = 0.5 * best->gap;
        for (int row = -reach; row <= reach; ++row) {
            for (int column = -reach; column <= reach; ++column) {
                const Point beside = pivot + step * Point{static_cast<double>(column), static_cast<double>(row)};
                std::optional<Run> run = longest_run(points, among, beside);
                if (!run || run->points.size() <= best->points.size()) continue;
                best = std::move(run);
                seen_from = beside;
            }
        }
    }
    if (best->points.size() < least_run) return std::nullopt;
    return std::pair{*best, seen_from};
}

/// r^(1/power) grows evenly along a run: reach and start from the line of best fit.
std::optional<Parameters> line_through(const Run& run, Point pivot, double power) {
    const auto n = static_cast<double>(run.radii.size());
    double sum_k = 0, sum_y = 0, sum_kk = 0, sum_ky = 0;
    for (std::size_t i = 0; i < run.radii.size(); ++i) {
        const auto k = static_cast<double>(i);
        const double y = std::pow(run.radii[i], 1 / power);
        sum_k += k;
        sum_y += y;
        sum_kk += k * k;
        sum_ky += k * y;
    }
    const double slope = (n * sum_ky - sum_k * sum_y) / (n * sum_kk - sum_k * sum_k);
    if (!(slope > 0)) return std::nullopt;
    const double start = std::max(0.0, (sum_y - slope * sum_k) / n / slope);
    Parameters p;
    p << pivot.x, pivot.y, run.phase, run.angle, power * std::log(slope), power, start, 0, 0;
    return p;
}

/// Takes in points that stand where the law expects the next members, at both ends, while there are any.
class Growth {
  public:
    Growth(std::span<const Point> points, const KdTree& tree) : points_(points), tree_(tree), used_(points.size(), 0) {}

    Parameters grow(Numbered& numbered, Parameters p) {
        for (const int i : numbered.order) used_[static_cast<std::size_t>(i)] = 1;
        for (;;) {
            p = refined({points_, numbered}, p, law_parameters);
            const std::size_t most = 2 + numbered.order.size() / 3;
            std::size_t added = 0;
            while (added < most && add(numbered, p, true)) ++added;
            while (added < 2 * most && add(numbered, p, false)) ++added;
            if (added == 0) return p;
        }
    }

  private:
    bool add(Numbered& numbered, const Parameters& p, bool outward) {
        const int number = outward ? numbered.first + static_cast<int>(numbered.order.size()) : numbered.first - 1;
        constexpr double rounding = 0.3;  // an index may come out a little below 0
        if (p(at_start) + number < -rounding) return false;
        const Point wanted = place_of(p, number);
        const Neighbor nearest = tree_.nearest(wanted, 1).front();
        if (used_[nearest.index]) return false;
        const std::vector<Neighbor> around = tree_.nearest(points_[nearest.index], 2);
        if (around.size() < 2 || nearest.distance > match_share * around[1].distance) return false;
        used_[nearest.index] = 1;
        numbered.order.insert(outward ? numbered.order.end() : numbered.order.begin(), static_cast<int>(nearest.index));
        if (!outward) --numbered.first;
        return true;
    }

    std::span<const Point> points_;
    const KdTree& tree_;
    std::vector<char> used_;
};

/// Round exponents and starts where no point then lies farther off than before by more than `slack`.
Parameters with_round_numbers(const Fitter& fitter, Parameters p, std::vector<int> free, double slack) {
    const double allowed = fitter.worst(p) + slack;
    const auto fix = [&](int parameter, double value) {
        std::vector<int> others = free;
        std::erase(others, parameter);
        Parameters moved = p;
        moved(parameter) = value;
        moved = refined(fitter, moved, others);
        if (fitter.worst(moved) > allowed) return false;
        p = moved;
        free = others;
        return true;
    };
    const auto nearest = [](double value, double unit) { return unit * std::round(value / unit); };
    for (const double unit : {1.0, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 10}) {
        const double power = nearest(p(at_power), unit);
        if (power > 0 && fix(at_power, power)) break;
    }
    const double first = p(at_start) + fitter.numbered.first;
    for (const double unit : {1.0, 1.0 / 2}) {
        if (fix(at_start, nearest(first, unit) - fitter.numbered.first)) break;
    }
    return p;
}

SpiralFit as_fit(const Fitter& fitter, const Parameters& p, Numbered numbered) {
    SpiralFit fit;
    fit.worst = fitter.worst(p);
    fit.law.angle = wrap_angle(p(at_angle));
    fit.law.reach = std::exp(p(at_reach));
    fit.law.power = p(at_power);
    fit.law.start = std::max(0.0, p(at_start) + numbered.first);
    // Direction of index 0: member k = -start; the heading is +y.
    const double zero = p(at_phase) - fit.law.angle * p(at_start);
    fit.pivot = {polar(1, zero - pi / 2), {p(at_pivot_x), p(at_pivot_y)}, false};
    fit.law.seat = {p(at_seat_x), p(at_seat_y)};
    fit.order = std::move(numbered.order);
    return fit;
}

/// The mean with weights that fade out towards the innermost and the outermost points, whose directions do not balance.
Point tapered_mean(std::span<const Point> points, Point mean) {
    constexpr int rounds = 3;
    std::vector<std::pair<double, std::size_t>> by_distance(points.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < points.size(); ++i) by_distance[i] = {norm(points[i] - mean), i};
        std::ranges::sort(by_distance);
        Point sum;
        double total = 0;
        for (std::size_t rank = 0; rank < by_distance.size(); ++rank) {
            const double part = (static_cast<double>(rank) + 0.5) / static_cast<double>(points.size());
            const double weight = std::pow(std::sin(pi * part), 2);
            sum += weight * points[by_distance[rank].second];
            total += weight;
        }
        mean = sum / total;
    }
    return mean;
}

std::vector<Point> possible_pivots(std::span<const Point> points, const KdTree& tree) {
    Point mean, low = points.front(), high = points.front();
    for (const Point& point : points) {
        mean += point / static_cast<double>(points.size());
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    return {tapered_mean(points, mean), mean, 0.5 * (low + high), points[tree.nearest(mean, 1).front().index]};
}

}  // namespace

std::optional<SpiralFit> fit_spiral(std::span<const Point> points, double slack) {
    if (points.size() < least_members) return std::nullopt;
    const KdTree tree(points);
    std::optional<SpiralFit> best;
    for (const Point& pivot : possible_pivots(points, tree)) {
        const auto found = run_near(points, pivot);
        if (!found) continue;
        const auto& [run, seen_from] = *found;
        const double from_row = std::min(std::abs(wrap_angle(run.angle)), pi - std::abs(wrap_angle(run.angle)));
        if (from_row < straight) continue;
        for (const double power : {0.5, 1.0}) {
            const std::optional<Parameters> line = line_through(run, seen_from, power);
            if (!line) continue;
            Numbered numbered{0, run.points};
            const Parameters grown = Growth(points, tree).grow(numbered, *line);
            if (numbered.order.size() < least_members) continue;
            if (best && best->order.size() >= numbered.order.size()) continue;
            const Fitter fitter{points, numbered};
            best = as_fit(fitter, with_round_numbers(fitter, grown, law_parameters, slack), numbered);
        }
        if (best && 2 * best->order.size() > points.size()) break;
    }
    return best;
}

SpiralFit fit_seats(std::span<const Point> points, std::span<const Complex> linear, const SpiralFit& fit, double slack) {
    const Numbered numbered{0, fit.order};
    const Fitter fitter{points, numbered, linear};
    const double first = arg(fit.pivot.linear) + pi / 2 + fit.law.angle * fit.law.start;
    Parameters p;
    p << fit.pivot.translation.x, fit.pivot.translation.y, first, fit.law.angle, std::log(fit.law.reach), fit.law.power,
        fit.law.start, 0, 0;
    const Parameters seated = refined(fitter, p, law_and_seat);
    const SpiralFit better = as_fit(fitter, with_round_numbers(fitter, seated, law_and_seat, slack), numbered);
    return better.worst < fit.worst ? better : fit;
}

}  // namespace rinceau

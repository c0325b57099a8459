#include "analyzer/arrangement.h"

#include <algorithm>
#include <cmath>

#include "geometry/kd_tree.h"

namespace rinceau {

double laid_along(double direction, const BodyForm& form, double error) {
    constexpr double largest_error = 0.1;  // radians
    constexpr double deviations = 3;
    if (!form.axis || form.fold == 0) return direction;
    const double between_axes = pi / (form.fold % 2 == 0 ? form.fold : 2 * form.fold);
    const double off = std::remainder(direction + *form.axis, between_axes);
    return std::abs(off) <= std::min(largest_error, deviations * error) ? direction - off : direction;
}

double off_natural(double angle, double unit, double error) {
    constexpr double deviations = 3;
    constexpr double clear = 4;
    const double off = std::remainder(angle, unit);
    return unit < clear * error || std::abs(off) > deviations * error ? 0 : off;
}

std::optional<CommonLinear> common_linear(std::span<const Complex> linears, const BodyForm& form) {
    const double largest_turn = radians(25);
    constexpr double largest_log_ratio = 0.25;
    if (linears.empty()) return std::nullopt;
    const auto n = static_cast<double>(linears.size());
    Complex sum{};
    double log_size = 0;
    for (const Complex linear : linears) {
        sum += polar(1, form.fold * arg(linear));
        log_size += std::log(abs(linear)) / n;
    }
    const double direction = form.fold > 0 ? arg(sum) / form.fold : 0;
    CommonLinear common;
    for (const Complex linear : linears) {
        if (std::abs(std::log(abs(linear)) - log_size) > largest_log_ratio) return std::nullopt;
        if (form.fold == 0) continue;
        const double off = wrap_angle(form.fold * (arg(linear) - direction)) / form.fold;
        if (std::abs(off) > largest_turn) return std::nullopt;
        common.turned += off * off / n;
    }
    common.turned = std::sqrt(common.turned);
    common.linear = polar(std::exp(log_size), direction);
    return common;
}

bool lies_along(double direction, const BodyForm& form) {
    constexpr double hardly_turned = 1e-9;
    if (form.fold == 0) return true;
    return form.axis && std::abs(std::remainder(direction + *form.axis, pi / form.fold)) < hardly_turned;
}

double median_spacing(std::span<const Point> points) {
    if (points.size() < 2) return 0;
    const KdTree tree(points);
    std::vector<double> distances;
    for (const Point p : points) distances.push_back(tree.nearest(p, 2).back().distance);
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::ranges::nth_element(distances, middle);
    return *middle;
}

bool is_smooth(std::span<const Point> deviations, std::span<const std::pair<int, int>> neighbours) {
    constexpr double smooth = 0.3;
    double squares = 0, differences = 0;
    for (const Point each : deviations) squares += norm(each) / static_cast<double>(deviations.size());
    for (const auto& [a, b] : neighbours) {
        const Point step = deviations[static_cast<std::size_t>(a)] - deviations[static_cast<std::size_t>(b)];
        differences += norm(step) / static_cast<double>(neighbours.size());
    }
    return !neighbours.empty() && differences < smooth * 2 * squares;
}

double log2_hit(double spread, double gap) {
    // A uniform distribution is sqrt(12) standard deviations wide; a hundredth of the gap is what nobody can place better.
    const double share = std::max(std::sqrt(12.0) * spread / gap, 0.01);
    return std::log2(std::min(1.0, share));
}

}  // namespace rinceau

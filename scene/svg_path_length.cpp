#include "scene/svg_path_length.h"

#include <algorithm>
#include <cmath>

#include "scene/svg_number.h"

namespace rinceau {
namespace {

constexpr double endless = 1e15;  // px: longer than any outline that is read

}  // namespace

std::optional<double> parse_path_length(std::string_view text) {
    const std::optional<std::vector<double>> numbers = parse_numbers(trimmed(text));
    if (!numbers || numbers->size() != 1 || numbers->front() < 0) return std::nullopt;
    return numbers->front();
}

SvgStyle with_measured_dashes(SvgStyle style, const SvgNode& node, const std::vector<Path>& outline, const Affine& map,
                              double pixel) {
    const std::string_view* text = find_attribute(node, "pathLength");
    const std::optional<double> stated = text == nullptr ? std::nullopt : parse_path_length(*text);
    if (!stated || style.dashes.empty()) return style;
    const double drawn = style.non_scaling_stroke ? length(transformed(outline, map)) / pixel : length(outline);
    const auto measured = [&](double dash) { return dash * drawn / *stated; };
    // Too long or too short for numbers, or nothing at all: the line is whole.
    const double longest = measured(std::ranges::max(style.dashes));
    if (!(longest > 0 && std::max(longest, std::abs(measured(style.dash_offset))) < endless)) {
        style.dashes.clear();
        return style;
    }
    for (double& dash : style.dashes) dash = measured(dash);
    style.dash_offset = measured(style.dash_offset);
    return style;
}

}  // namespace rinceau

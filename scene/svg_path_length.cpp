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
    const double longest = std::max(std::ranges::max(style.dashes), std::abs(style.dash_offset));
    if (longest * drawn >= endless * *stated) {
        style.dashes.clear();
        return style;
    }
    for (double& dash : style.dashes) dash *= drawn / *stated;
    style.dash_offset *= drawn / *stated;
    return style;
}

}  // namespace rinceau

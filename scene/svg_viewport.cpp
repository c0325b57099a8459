#include "scene/svg_viewport.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include "scene/svg_number.h"

namespace rinceau {

namespace {

std::optional<double> alignment(std::string_view word) {
    if (word == "Min") return 0.0;
    if (word == "Mid") return 0.5;
    if (word == "Max") return 1.0;
    return std::nullopt;
}

std::string_view next_word(TextCursor& cursor) {
    skip_space(cursor);
    const std::size_t start = cursor.at;
    while (!cursor.at_end() && !is_svg_space(cursor.peek())) ++cursor.at;
    return cursor.text.substr(start, cursor.at - start);
}

}  // namespace

std::optional<ViewBox> parse_view_box(std::string_view text) {
    const std::optional<std::vector<double>> numbers = parse_numbers(text);
    if (!numbers || numbers->size() != 4) return std::nullopt;
    const ViewBox box{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
    return box.width >= 0 && box.height >= 0 ? std::optional(box) : std::nullopt;
}

std::optional<AspectRatio> parse_aspect_ratio(std::string_view text) {
    TextCursor cursor{text};
    std::string_view word = next_word(cursor);
    if (word == "defer") word = next_word(cursor);
    AspectRatio aspect;
    if (word == "none") {
        aspect.stretch = true;
    } else {
        if (word.size() != 8 || word[0] != 'x' || word[4] != 'Y') return std::nullopt;
        const std::optional<double> x = alignment(word.substr(1, 3));
        const std::optional<double> y = alignment(word.substr(5, 3));
        if (!x || !y) return std::nullopt;
        aspect.align_x = *x;
        aspect.align_y = *y;
    }
    const std::string_view fit = next_word(cursor);
    if (!fit.empty() && fit != "meet" && fit != "slice") return std::nullopt;
    aspect.slice = fit == "slice" && !aspect.stretch;
    return next_word(cursor).empty() ? std::optional(aspect) : std::nullopt;
}

Affine view_box_map(const ViewBox& box, const AspectRatio& aspect, double width, double height) {
    assert(box.width > 0 && box.height > 0);
    double scale_x = width / box.width;
    double scale_y = height / box.height;
    if (!aspect.stretch) scale_x = scale_y = aspect.slice ? std::max(scale_x, scale_y) : std::min(scale_x, scale_y);
    const double free_x = width - scale_x * box.width;
    const double free_y = height - scale_y * box.height;
    const double align_x = aspect.stretch ? 0 : aspect.align_x;
    const double align_y = aspect.stretch ? 0 : aspect.align_y;
    return {scale_x, 0, 0, scale_y, align_x * free_x - scale_x * box.x, align_y * free_y - scale_y * box.y};
}

}  // namespace rinceau

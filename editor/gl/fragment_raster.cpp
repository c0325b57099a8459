#include "editor/gl/fragment_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/input_error.h"
#include "scene/svg_number.h"
#include "scene/svg_raster.h"
#include "scene/svg_write.h"

namespace rinceau {
namespace {

constexpr double room_around = 0.15;        // of the frame's size, on each side: moving a little needs no new pixels
constexpr int smoothing_reach = 2;          // pixels that smoothed edges may add to a box
constexpr double same_place = 1.0 / 256;    // of a pixel
constexpr double largest_coordinate = 1e9;  // pixels

Affine view_map(const ViewTransform& view) {
    return {view.zoom,
            0,
            0,
            -view.zoom,
            0.5 * view.size.x - view.zoom * view.center.x,
            0.5 * view.size.y + view.zoom * view.center.y};
}

bool in_range(const Affine& map) {
    return std::ranges::all_of(std::array{map.a, map.b, map.c, map.d, map.e, map.f},
                               [](double number) { return std::abs(number) < largest_coordinate; });
}

/// Whole pixels that cover the part of the box within the bounds.
PixelRect covering(const Box& box, const Box& bounds) {
    const double left = std::floor(std::max(box.low.x, bounds.low.x));
    const double top = std::floor(std::max(box.low.y, bounds.low.y));
    const double right = std::ceil(std::min(box.high.x, bounds.high.x));
    const double bottom = std::ceil(std::min(box.high.y, bounds.high.y));
    if (!(right > left && bottom > top)) return {};
    return {static_cast<int>(left), static_cast<int>(top), static_cast<int>(right - left), static_cast<int>(bottom - top)};
}

}  // namespace

std::optional<FragmentPlace> fragment_place(const std::shared_ptr<const std::string>& text, const Box& box,
                                            const Similarity& pose, const ViewTransform& view) {
    const Affine of_terminal = view_map(view) * to_affine(pose);
    const Affine to_pixels = of_terminal * Affine{1, 0, 0, -1, 0, 0};
    if (!in_range(to_pixels) || !(std::abs(determinant(to_pixels)) > 0)) return {};
    const Box frame{{0, 0}, view.size};
    const Box near_frame = grown(frame, room_around * std::max(view.size.x, view.size.y));
    Box drawn;
    for (const Point corner : {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
        drawn = is_empty(box) ? near_frame : including(drawn, apply(of_terminal, corner));
    drawn = grown(drawn, smoothing_reach);
    const PixelRect rect = covering(drawn, near_frame);
    if (rect.width == 0) return {};
    return FragmentPlace{text, to_pixels, rect, covering(drawn, frame)};
}

bool serves(const FragmentPlace& drawn, const FragmentPlace& wanted) {
    if (drawn.text != wanted.text) return false;
    const Affine& a = drawn.to_pixels;
    const Affine& b = wanted.to_pixels;
    const double reach = std::max(wanted.rect.width, wanted.rect.height);
    const auto turned_apart = std::max({std::abs(a.a - b.a), std::abs(a.b - b.b), std::abs(a.c - b.c), std::abs(a.d - b.d)});
    const double size = std::max({std::abs(a.a), std::abs(a.b), std::abs(a.c), std::abs(a.d)});
    if (turned_apart * reach > same_place * size) return false;
    const Point moved{b.e - a.e, b.f - a.f};
    const Point whole{std::round(moved.x), std::round(moved.y)};
    if (std::max(std::abs(moved.x - whole.x), std::abs(moved.y - whole.y)) > same_place) return false;
    const double left = drawn.rect.left + whole.x;
    const double top = drawn.rect.top + whole.y;
    const PixelRect& needed = wanted.on_frame;
    return left <= needed.left && top <= needed.top && left + drawn.rect.width >= needed.left + needed.width &&
           top + drawn.rect.height >= needed.top + needed.height;
}

std::optional<TransparentPicture> fragment_pixels(const FragmentPlace& place) {
    const Affine& map = place.to_pixels;
    std::string matrix;
    for (const double number : {map.a, map.b, map.c, map.d, map.e - place.rect.left, map.f - place.rect.top})
        matrix += svg_number(number) + " ";
    const Box page{{0, -static_cast<double>(place.rect.height)}, {static_cast<double>(place.rect.width), 0}};
    const std::string svg =
        svg_root_tag(page, true) + "<g transform=\"matrix(" + matrix + ")\">" + *place.text + "</g></svg>";
    try {
        return svg_to_transparent_picture(svg);
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace rinceau

// One shape in many colours or widths: the layout is a rule, and so is the colouring.

#include <cmath>

#include "closed_loop/known_grammar.h"
#include "closed_loop/listed_scenes.h"

namespace rinceau::test {

namespace {

Color mixed(const Color& a, const Color& b, double share) {
    const auto channel = [&](std::uint8_t low, std::uint8_t high) {
        return static_cast<std::uint8_t>(std::lround((1 - share) * low + share * high));
    };
    return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

/// rows x columns copies of one shape, each in the style that `style` gives for its row and column.
template <class StyleOf>
Scene styled_grid(int rows, int columns, StyleOf style) {
    Scene scene;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            scene.elements.push_back(placed(element(rectangle(8, 8), style(row, column)), translate({12.0 * column, 12.0 * row})));
            scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
        }
    }
    return scene;
}

template <class StyleOf>
ListedScene grid(const std::string& name, int rows, int columns, StyleOf style) {
    const int rules = rows > 1 ? 2 : 1;
    return {"style", name, rules, rules, 1, 1, 1, [=](std::uint64_t seed) {
                Random random(seed);
                return shuffled(styled_grid(rows, columns, style), random);
            }};
}

ListedScene ring_of_hues() {
    return {"style", "ring_of_hues", 1, 1, 1, 1, 1, [](std::uint64_t seed) {
                Scene scene;
                for (int k = 0; k < 12; ++k) {
                    const Color color = k < 6 ? mixed(clay, sky, k / 6.0) : mixed(sky, clay, (k - 6) / 6.0);
                    scene.elements.push_back(placed(element(leaf(), filled(color)), rotate(two_pi * k / 12) * translate({0, 60}) * scale_by(10)));
                    scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
                }
                Random random(seed);
                return shuffled(scene, random);
            }};
}

/// Twelve copies, each smaller than the one before; strokes of one width, or as they were scaled.
ListedScene shrinking(const std::string& name, bool fixed) {
    return {"style", name, 1, 1, 1, 1, 1, [=](std::uint64_t seed) {
                Scene scene;
                Similarity pose;
                for (int k = 0; k < 12; ++k, pose = pose * translate({28, 0}) * scale_by(0.9)) {
                    Element copy = placed(element(transformed(hook(), scale_by(10)), stroked(ink, 2)), pose);
                    if (fixed) copy.style.stroke.width = 2;
                    scene.viewport = including(scene.viewport, painted_box(copy));
                    scene.elements.push_back(std::move(copy));
                }
                Random random(seed);
                return shuffled(scene, random);
            }};
}

}  // namespace

std::vector<ListedScene> style_scenes() {
    const std::vector<Color> palette{ink, clay, sky, gold};
    const auto color = [=](int k) { return filled(palette[static_cast<std::size_t>(k) % palette.size()]); };
    return {
        grid("row_alternating", 1, 16, [=](int, int c) { return color(c % 2); }),
        grid("row_of_period_three", 1, 18, [=](int, int c) { return color(c % 3); }),
        grid("row_gradient", 1, 16, [](int, int c) { return filled(mixed(clay, sky, c / 15.0)); }),
        grid("row_of_widths", 1, 12, [](int, int c) { return stroked(ink, 0.3 + 0.2 * c); }),
        grid("checkerboard", 8, 8, [=](int r, int c) { return color((r + c) % 2); }),
        grid("rows_alternating", 8, 10, [=](int r, int) { return color(r % 2); }),
        grid("columns_gradient", 8, 12, [](int, int c) { return filled(mixed(gold, ink, c / 11.0)); }),
        grid("rows_gradient", 10, 8, [](int r, int) { return filled(mixed(gold, ink, r / 9.0)); }),
        grid("diagonal_stripes", 9, 9, [=](int r, int c) { return color((r + c) % 3); }),
        grid("grid_of_random_colours", 10, 12, [=](int r, int c) { return color((r * 7919 + c * 104729 + r * c * 31) / 3); }),
        ring_of_hues(),
        shrinking("shrinking_strokes_scaled", false),
        shrinking("shrinking_strokes_fixed", true),
    };
}

}  // namespace rinceau::test

// Strokes that scale with their shapes, and strokes of one width in all sizes.
#include <catch2/catch.hpp>

#include <set>

#include "analyzer/instancing.h"
#include "analyzer/redrawn.h"
#include "analyzer/stroke_lengths.h"
#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double seen = 0.02;

std::set<int> groups_of(const std::vector<StrokeLengths>& found) {
    std::set<int> groups;
    for (const StrokeLengths& lengths : found) groups.insert(lengths.group);
    return groups;
}

Instancing grouped(std::vector<Element> elements) {
    return group_similar_elements(Scene{{{-100, -100}, {100, 100}}, true, std::move(elements)});
}

Element hook_of(double size, double width, std::vector<double> dashes = {}) {
    Element result = element(transformed(hook(), scale_by(size)), stroked({}, width));
    result.style.stroke.dashes = std::move(dashes);
    return result;
}

/// Every element's width and dashes are its look's, to what can be seen.
void check_lengths(const std::vector<Element>& elements, const Instancing& found) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const Instance& instance = found.instances[i];
        const Style& unit = found.looks[static_cast<std::size_t>(instance.look)].unit_style;
        CHECK(same_style(transformed(unit, instance.pose), elements[i].style, 0.0225));  // 7.8e-5 of the diagonal
    }
}

}  // namespace

TEST_CASE("equal widths on copies of all sizes are one fixed stroke") {
    std::vector<Element> elements;
    for (int i = 1; i <= 20; ++i) elements.push_back(hook_of(0.3 * i, 0.4));
    const Instancing found = grouped(elements);
    REQUIRE(found.looks.size() == 1);
    CHECK(found.looks[0].unit_style.stroke.fixed);
    CHECK(found.looks[0].unit_style.stroke.width == Approx(0.4));
    check_lengths(elements, found);
}

TEST_CASE("widths that grow with the copies are one scaling stroke, and so are copies of one size") {
    const Instancing growing = grouped({hook_of(1, 0.1), hook_of(2, 0.2), hook_of(5, 0.5)});
    REQUIRE(growing.looks.size() == 1);
    CHECK_FALSE(growing.looks[0].unit_style.stroke.fixed);
    const Instancing equal = grouped({hook_of(2, 0.3), hook_of(2, 0.3), hook_of(2, 0.7)});
    REQUIRE(equal.looks.size() == 2);
    CHECK_FALSE(equal.looks[0].unit_style.stroke.fixed);
    CHECK_FALSE(equal.looks[1].unit_style.stroke.fixed);
}

TEST_CASE("two pens on many sizes are two fixed strokes, and sizes that differ by rounding are one scaling stroke") {
    std::vector<Element> elements;
    for (int i = 1; i <= 6; ++i) {
        elements.push_back(hook_of(i, 0.4));
        elements.push_back(hook_of(i, 0.9));
    }
    const Instancing two = grouped(elements);
    CHECK(two.looks.size() == 2);
    CHECK(two.shapes == 1);
    check_lengths(elements, two);
    const std::vector<Element> rounded{hook_of(8, 0.4), hook_of(8.01, 0.4), hook_of(7.99, 0.4)};
    const Instancing one = grouped(rounded);
    REQUIRE(one.looks.size() == 1);
    CHECK_FALSE(one.looks[0].unit_style.stroke.fixed);
    check_lengths(rounded, one);
}

TEST_CASE("lines of all lengths and one dash pattern are one look, patterns that differ are two") {
    const std::vector<Element> dashed{hook_of(1, 0.4, {2, 1}), hook_of(3, 0.4, {2, 1}), hook_of(4, 0.4, {2, 1})};
    const Instancing one = grouped(dashed);
    REQUIRE(one.looks.size() == 1);
    CHECK(one.looks[0].unit_style.stroke.dashes == std::vector<double>{2, 1});
    check_lengths(dashed, one);
    CHECK(grouped({hook_of(1, 0.4, {2, 1}), hook_of(3, 0.4, {1, 2}), hook_of(4, 0.4)}).looks.size() == 3);
}

TEST_CASE("a single shape takes part in the fixed stroke of others, so that they share its style") {
    const Element one = element(star(5), stroked({}, 0.4));
    CHECK_FALSE(grouped({one}).looks[0].unit_style.stroke.fixed);
    const Instancing found = grouped({hook_of(1, 0.4), one, hook_of(3, 0.4)});
    REQUIRE(found.looks.size() == 2);
    CHECK(found.styles == 1);
    CHECK(grouped({hook_of(1, 0.4), hook_of(3, 0.4), element(star(5), stroked({}, 0.8))}).styles == 2);
}

TEST_CASE("a stretched pen always scales, dots scale by their width") {
    std::vector<Element> stretched{hook_of(1, 0.4), hook_of(3, 0.4)};
    for (Element& e : stretched) e.style.stroke.pen = {2, 0, 0, 1};
    CHECK(grouped(stretched).looks.size() == 2);
    std::vector<Element> dots;
    for (const double width : {1.0, 2.0, 5.0}) {
        Style style = stroked({}, width);
        style.stroke.cap = LineCap::round;
        dots.push_back(element({Path{.start = {3, width}, .segments = {line_to({3, width})}}}, style));
    }
    const Instancing found = grouped(dots);
    REQUIRE(found.looks.size() == 1);
    CHECK_FALSE(found.looks[0].unit_style.stroke.fixed);
}

TEST_CASE("no length is moved by more than can be seen") {
    std::vector<DrawnStroke> strokes;
    for (int i = 0; i < 200; ++i)
        strokes.push_back({.shape = i % 2, .kind = 7, .width = 0.2 + 0.013 * i, .scale = 1 + i % 7 * 0.7});
    const std::vector<StrokeLengths> found = common_stroke_lengths(strokes, seen);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const double drawn = found[i].width * (found[i].fixed ? 1 : strokes[i].scale);
        CHECK(std::abs(drawn - strokes[i].width) <= seen * (1 + 1e-9));
    }
    CHECK(groups_of(found).size() < strokes.size());
}

TEST_CASE("the reading with fewer groups is taken, of equally many the scaling one") {
    const auto stroke = [](double width, double scale) { return DrawnStroke{.kind = 1, .width = width, .scale = scale}; };
    const auto groups = [&](const std::vector<DrawnStroke>& strokes) { return common_stroke_lengths(strokes, seen); };
    CHECK(groups({stroke(1, 1), stroke(2, 2), stroke(3, 3), stroke(3, 1)}).front().fixed == false);
    CHECK(groups({stroke(1, 1), stroke(1, 2), stroke(1, 3), stroke(3, 1)}).front().fixed == true);
    CHECK(groups({stroke(1, 1), stroke(2, 1)}).front().fixed == false);
}

// Looks: which styles are one, and how a gradient chooses among the poses of a symmetric shape.
#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/instancing.h"
#include "analyzer/redrawn.h"
#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

Style with_gradient(GradientKind kind, const Affine& map) {
    Gradient gradient;
    gradient.kind = kind;
    gradient.stops = {{0, {255, 0, 0}, 1}, {1, {0, 0, 255}, 1}};
    gradient.map = map;
    Style style;
    style.fill = std::make_shared<const Gradient>(gradient);
    return style;
}

Style across() { return with_gradient(GradientKind::linear, {2, 0, 0, 2, -1, 0}); }

Instancing grouped(std::vector<Element> elements) {
    return group_similar_elements(Scene{{{-100, -100}, {100, 100}}, true, std::move(elements)});
}

/// The style of every element is its look's style under its pose.
void check_styles(const std::vector<Element>& elements, const Instancing& found) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const Instance& instance = found.instances[i];
        const Style& unit = found.looks[static_cast<std::size_t>(instance.look)].unit_style;
        CHECK(same_style(transformed(unit, instance.pose), elements[i].style, 0.02 * scale_of(instance.pose)));
    }
}

std::vector<Element> copies(const Element& original, int count, Random& random) {
    std::vector<Element> all;
    for (int i = 0; i < count; ++i) all.push_back(placed(original, random_similarity(random)));
    return all;
}

}  // namespace

TEST_CASE("one shape in two colours is two looks of one shape, and a style is shared between shapes") {
    const Instancing found = grouped(
        {element(hook(), filled({255, 0, 0})), element(hook(), filled({0, 0, 255})), element(leaf(), filled({0, 0, 255}))});
    REQUIRE(found.looks.size() == 3);
    CHECK(found.shapes == 2);
    CHECK(found.styles == 2);
    CHECK(found.looks[0].shape == found.looks[1].shape);
    CHECK(found.looks[1].style == found.looks[2].style);
}

TEST_CASE("strokes that scale with their shapes are one look, and so are equal strokes on two sizes") {
    const Element original = element(hook(), stroked({}, 0.2));
    CHECK(grouped({original, placed(original, scale_by(3))}).looks.size() == 1);
    const auto plain = [](double size) { return element(transformed(hook(), scale_by(size)), stroked({}, 0.2)); };
    CHECK(grouped({plain(1), plain(3), plain(1), plain(3)}).looks.size() == 1);
}

TEST_CASE("copies with gradients of their own are one look") {
    Random random(1);
    for (const auto& outline : {hook(), rectangle(2, 1), rectangle(1, 1), star(5), circle(), leaf()}) {
        const std::vector<Element> elements = copies(element(outline, across()), 48, random);
        const Instancing found = grouped(elements);
        CHECK(found.looks.size() == 1);
        CHECK(found.styles == 1);
        check_styles(elements, found);
    }
}

TEST_CASE("a gradient fixes the turn of a symmetric shape") {
    const Element original = element(rectangle(1, 1), across());
    // The same square with the gradient turned by 90 degrees is a turned copy, whatever the numbers of its path say.
    Element turned = element(rectangle(1, 1), transformed(across(), rotate(pi / 2)));
    const Instancing found = grouped({original, turned});
    REQUIRE(found.looks.size() == 1);
    CHECK(arg(found.instances[1].pose.linear) == Approx(pi / 2));
    check_styles({original, turned}, found);
    // Turned by 45 degrees it is another look.
    turned.style = transformed(across(), rotate(pi / 4));
    CHECK(grouped({original, turned}).looks.size() == 2);
}

TEST_CASE("a look keeps those symmetries of its shape that keep its style") {
    const auto symmetry = [](const std::vector<Path>& paths, const Style& style) {
        return grouped({element(paths, style)}).looks[0].symmetry;
    };
    const Style centred = with_gradient(GradientKind::radial, {1, 0, 0, 1, 0, 0});
    const Style aside = with_gradient(GradientKind::radial, {1, 0, 0, 1, 0.3, 0.1});
    const Style oval = with_gradient(GradientKind::radial, {1, 0, 0, 0.5, 0, 0});
    CHECK(symmetry(rectangle(1, 1), filled({})).elements.size() == 8);
    CHECK(symmetry(rectangle(1, 1), across()).elements.size() == 2);
    CHECK(symmetry(rectangle(1, 1), centred).elements.size() == 8);
    CHECK(symmetry(rectangle(1, 1), aside).elements.size() == 1);
    CHECK(symmetry(rectangle(1, 1), oval).elements.size() == 4);
    CHECK(symmetry(circle(), filled({})).continuous);
    CHECK(symmetry(circle(), centred).continuous);
    CHECK_FALSE(symmetry(circle(), across()).continuous);
    CHECK(symmetry(circle(), across()).elements.size() == 2);
    CHECK(symmetry(circle(), aside).elements.size() == 2);
    CHECK(symmetry(circle(), oval).elements.size() == 4);
}

TEST_CASE("circles with a light from one side are one look, turned") {
    Random random(3);
    const Style aside = with_gradient(GradientKind::radial, {1, 0, 0, 1, 0.3, 0.1});
    const std::vector<Element> elements = copies(element(circle(), aside), 20, random);
    const Instancing found = grouped(elements);
    CHECK(found.looks.size() == 1);
    check_styles(elements, found);
}

TEST_CASE("dashes tie a look to its start point and direction") {
    Style dashed = stroked({}, 0.05);
    dashed.stroke.dashes = {0.3, 0.1};
    const Element original = element(regular_polygon(6), dashed);
    const std::vector<Element> elements{original, placed(original, translate({5, 0}) * rotate(0.4)),
                                        placed(original, translate({9, 0}) * rotate(pi / 3))};
    const Instancing found = grouped(elements);
    REQUIRE(found.looks.size() == 1);
    CHECK(found.looks[0].symmetry.elements.size() == 1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const Point start = apply(found.instances[i].pose, found.looks[0].paths[0].start);
        CHECK(abs(start - elements[i].paths[0].start) < 1e-9);
    }
    CHECK(arg(found.instances[2].pose.linear) == Approx(pi / 3));
    // The other way round, the first dash lies elsewhere: a mirror image.
    Element backwards = original;
    std::ranges::reverse(backwards.paths[0].segments);
    const Instancing both = grouped({original, backwards});
    REQUIRE(both.looks.size() == 1);
    CHECK(both.instances[1].pose.mirrored);
}

TEST_CASE("a gap at the end of a stroke counts, a round joint hides it") {
    Path open = rectangle(2, 1)[0];
    open.segments.push_back(line_to(open.start));
    open.closed = false;
    Style style = stroked({}, 0.2);
    CHECK(grouped({element(rectangle(2, 1), style), element({open}, style)}).looks.size() == 2);
    style.stroke.cap = LineCap::round;
    style.stroke.join = LineJoin::round;
    CHECK(grouped({element(rectangle(2, 1), style), element({open}, style)}).looks.size() == 1);
}

TEST_CASE("a stretched pen fixes the turn of a shape as soon as its width shows") {
    const auto hooked = [](double turn, const Linear2& pen) {
        Element drawn = element(transformed(hook(), rotate(turn) * scale_by(40)), stroked({}, 3));
        drawn.style.stroke.pen = pen;
        return drawn;
    };
    const Linear2 seen{1.04, 0, 0, 0.97}, unseen{1.002, 0, 0, 0.999};
    CHECK(grouped({hooked(0, seen), hooked(pi / 2, seen)}).looks.size() == 2);
    CHECK(grouped({hooked(0, seen), hooked(0, seen)}).looks.size() == 1);
    CHECK(grouped({hooked(0, unseen), hooked(pi / 2, unseen)}).looks.size() == 1);
}

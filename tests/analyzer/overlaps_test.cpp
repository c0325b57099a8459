#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/overlaps.h"
#include "closed_loop/shapes.h"
#include "geometry/polygon.h"
#include "geometry/random.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr Color red{255, 0, 0};
constexpr Color green{0, 128, 0};

Scene scene_of(std::vector<Element> elements, double size = 100) {
    return {.viewport = {{0, 0}, {size, size}}, .elements = std::move(elements)};
}

bool lists(const Overlaps& overlaps, int lower, int upper) {
    return std::count(overlaps.pairs.begin(), overlaps.pairs.end(), OverlapPair{lower, upper}) == 1;
}

Element circle_at(Point center, double radius, Color color) { return placed(element(circle(radius), filled(color)), translate(center)); }

}  // namespace

TEST_CASE("circles of many colours are listed exactly when they overlap by more than an edge") {
    Random random(11);
    std::vector<Element> elements;
    std::vector<std::pair<Point, double>> circles;
    for (int i = 0; i < 300; ++i) {
        const Point center{random.uniform(0, 100), random.uniform(0, 100)};
        const double radius = i % 40 == 0 ? 30 : random.uniform(0.5, 4);
        circles.emplace_back(center, radius);
        // Any two differ by 20 or more in some channel.
        const auto shade = [](int digit) { return static_cast<std::uint8_t>(20 + 30 * digit); };
        elements.push_back(circle_at(center, radius, {shade(i % 7), shade(i / 7 % 7), shade(i / 49)}));
    }
    const Scene scene = scene_of(elements);
    const Overlaps found = find_overlaps(scene, {.antialiasing = false});
    const double pixel = 100 / OverlapOptions{}.picture_width;
    CHECK(found.complete);
    for (const std::vector<OverlapPair>& list : {found.pairs, found.faint}) {
        CHECK(std::is_sorted(list.begin(), list.end(), [](const OverlapPair& a, const OverlapPair& b) {
            return a.upper != b.upper ? a.upper < b.upper : a.lower < b.lower;
        }));
    }
    for (int j = 0; j < 300; ++j) {
        for (int i = 0; i < j; ++i) {
            const auto& [p, r] = circles[static_cast<std::size_t>(i)];
            const auto& [q, s] = circles[static_cast<std::size_t>(j)];
            const double gap = abs(p - q) - r - s;
            if (gap <= -3 * pixel) CHECK(lists(found, i, j));
            if (gap > -0.4 * pixel) CHECK_FALSE(lists(found, i, j));
            const bool faint = std::count(found.faint.begin(), found.faint.end(), OverlapPair{i, j}) == 1;
            if (gap <= 0) CHECK(lists(found, i, j) != faint);
            if (gap > pixel) CHECK_FALSE(faint);
        }
    }
}

TEST_CASE("strokes reach as far as half their widths, mitres and square caps further") {
    Random random(12);
    for (int k = 0; k < 300; ++k) {
        const auto random_point = [&] { return Point{random.uniform(10, 90), random.uniform(10, 90)}; };
        const Point a = random_point(), b = random_point(), c = random_point(), d = random_point();
        const double width = random.uniform(1, 6);
        Style round = stroked(red, width);
        round.stroke.cap = LineCap::round;
        Style other = stroked(green, width);
        other.stroke.cap = LineCap::round;
        const Overlaps found = find_overlaps(scene_of({element({Path{.start = a, .segments = {line_to(b)}}}, round),
                                                       element({Path{.start = c, .segments = {line_to(d)}}}, other)}));
        const double distance = segment_crossing(a, b, c, d) ? 0
                                : std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d),
                                            distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
        if (distance < width - 0.5) CHECK(lists(found, 0, 1));
        if (distance > width + 0.2) CHECK(found.pairs.empty());
    }
    Style mitred = stroked(red, 4);
    mitred.stroke.miter_limit = 20;
    const Element corner = element({Path{.start = {10, 50}, .segments = {line_to({50, 55}), line_to({10, 60})}}}, mitred);
    CHECK(find_overlaps(scene_of({corner, circle_at({62, 55}, 1, green)})).pairs.size() == 1);
    CHECK(find_overlaps(scene_of({corner, circle_at({75, 55}, 1, green)})).pairs.empty());
    Style capped = stroked(red, 10);
    capped.stroke.cap = LineCap::square;
    const Element bar = element({Path{.start = {10, 50}, .segments = {line_to({50, 50})}}}, capped);
    CHECK(find_overlaps(scene_of({bar, circle_at({55.5, 54}, 1, green)})).pairs.size() == 1);
}

TEST_CASE("what stands in a hole touches nothing, what stands on the solid does") {
    const Element ring = placed(element(frame(4, 0.8), filled(red)), Similarity{{40, 0}, {50, 50}, false});
    CHECK(find_overlaps(scene_of({ring, circle_at({50, 50}, 5, green)})).pairs.empty());
    CHECK(find_overlaps(scene_of({ring, circle_at({50, 87}, 1, green)})).pairs.size() == 1);
    const Element solid = placed(element(frame(4, 0.8), Style{.fill = red, .fill_rule = FillRule::nonzero}), Similarity{{40, 0}, {50, 50}, false});
    Element both_same_way = solid;
    both_same_way.paths[1] = transformed(both_same_way.paths[1], to_affine(Similarity{{-1, 0}, {100, 0}, true}));
    CHECK(find_overlaps(scene_of({both_same_way, circle_at({50, 50}, 5, green)})).pairs.size() == 1);
    const Element outline = placed(element(regular_polygon(5), stroked(red, 0.1)), Similarity{{40, 0}, {50, 50}, false});
    CHECK(find_overlaps(scene_of({outline, circle_at({50, 50}, 5, green)})).pairs.empty());
}

TEST_CASE("the order of two things in one colour cannot be seen") {
    CHECK(find_overlaps(scene_of({circle_at({50, 50}, 5, red), circle_at({52, 50}, 5, red)})).pairs.empty());
    CHECK(find_overlaps(scene_of({circle_at({50, 50}, 5, red), circle_at({52, 50}, 5, green)})).pairs.size() == 1);
    Element outlined = circle_at({52, 50}, 5, red);
    outlined.style.stroke.paint = green;
    CHECK(find_overlaps(scene_of({circle_at({50, 50}, 5, red), outlined})).pairs.size() == 1);
    outlined.style.stroke.paint = red;
    CHECK(find_overlaps(scene_of({circle_at({50, 50}, 5, red), outlined})).pairs.empty());
}

TEST_CASE("a verbatim element fills its box, or everything if its box is unknown") {
    Element text{.verbatim = "<text>a</text>"};
    const std::vector<Element> dots{circle_at({20, 20}, 2, red), circle_at({80, 80}, 2, red)};
    CHECK(find_overlaps(scene_of({dots[0], text, dots[1]})).pairs == std::vector<OverlapPair>{{0, 1}, {1, 2}});
    CHECK(find_overlaps(scene_of({text, text})).pairs == std::vector<OverlapPair>{{0, 1}});
    text.verbatim_box = {{15, 15}, {30, 30}};
    CHECK(find_overlaps(scene_of({dots[0], text, dots[1]})).pairs == std::vector<OverlapPair>{{0, 1}});
}

TEST_CASE("tiles on a ground give the ground only, and their neighbours where they overlap") {
    const double overlapping = GENERATE(1.0, 1.2);
    std::vector<Element> elements{placed(element(rectangle(100, 100), filled({9, 9, 9})), translate({50, 50}))};
    constexpr int side = 40;
    constexpr double step = 100.0 / side;
    for (int i = 0; i < side * side; ++i) {
        const Point center{step * (i % side + 0.5), step * (i / side + 0.5)};
        elements.push_back(placed(element(rectangle(overlapping * step, overlapping * step), filled({0, static_cast<std::uint8_t>(40 * (i % side % 2) + 80 * (i / side % 2)), 200})), translate(center)));
    }
    const Overlaps found = find_overlaps(scene_of(elements), {.antialiasing = false});
    const std::size_t neighbours = 2 * side * (side - 1) + 2 * (side - 1) * (side - 1);
    CHECK(found.pairs.size() == (overlapping > 1 ? neighbours : 0) + side * side);
    CHECK(find_overlaps(scene_of(elements)).pairs.size() == neighbours + side * side);
    CHECK(found.faint.size() == (overlapping > 1 ? 0 : neighbours));
}

TEST_CASE("more pairs than allowed are cut to the nearest in paint order, and it is said") {
    std::vector<Element> elements;
    for (int i = 0; i < 60; ++i) elements.push_back(circle_at({50, 50}, 5, {static_cast<std::uint8_t>(60 * (i % 4)), static_cast<std::uint8_t>(60 * (i / 4 % 4)), static_cast<std::uint8_t>(60 * (i / 16))}));
    for (const std::size_t limit : {50U, 1000U}) {
        const Overlaps found = find_overlaps(scene_of(elements), {.max_pairs = limit});
        CHECK_FALSE(found.complete);
        CHECK(found.pairs.size() <= limit);
        CHECK(lists(found, 10, 11));
        CHECK_FALSE(lists(found, 0, 59));
    }
    CHECK(find_overlaps(scene_of(elements)).pairs.size() == 60 * 59 / 2);
}

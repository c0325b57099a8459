#include "editor/model/hit_test.h"

#include <catch2/catch.hpp>

#include "geometry/random.h"
#include "scene/svg_read.h"

using namespace rinceau;

namespace {

/// SVG content about the middle of a picture of 100 x 100: y down, as written.
HitIndex index_of(const std::string& content) {
    const Scene scene = read_svg("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' width='100' height='100'>" +
                                 content + "</svg>")
                            .scene;
    return HitIndex(std::make_shared<const DerivedPicture>(drawing_picture(scene)));
}

/// Which element is hit at a point of the SVG; -1 = none.
int hit(const HitIndex& index, double x, double y, double reach = 0) { return index.item_at({x, -y}, reach).value_or(-1); }

}  // namespace

TEST_CASE("the topmost of overlapping fills is hit, and holes are not") {
    const HitIndex index = index_of(
        "<rect x='10' y='10' width='80' height='80'/>"
        "<path fill-rule='evenodd' d='M20 20 H60 V60 H20 Z M30 30 H50 V50 H30 Z'/>"
        "<rect x='55' y='55' width='20' height='20' fill='none'/>");
    CHECK(hit(index, 15, 15) == 0);
    CHECK(hit(index, 25, 25) == 1);
    CHECK(hit(index, 40, 40) == 0);
    CHECK(hit(index, 58, 58) == 1);
    CHECK(hit(index, 70, 70) == 0);
    CHECK(hit(index, 5, 5) == -1);
    CHECK(hit(index, 8, 15, 3) == 0);
}

TEST_CASE("a thin line is hit within reach, though a fill lies below it") {
    const HitIndex index =
        index_of("<rect width='100' height='100'/><path d='M10 50 H90' fill='none' stroke='red' stroke-width='.1'/>");
    CHECK(hit(index, 50, 50.04) == 1);
    CHECK(hit(index, 50, 52) == 0);
    CHECK(hit(index, 50, 52, 3) == 1);
    CHECK(hit(index, 95, 50, 3) == 0);
}

TEST_CASE("inside one element the neighbour above is not hit, however near") {
    const HitIndex index =
        index_of("<rect x='10' y='10' width='40' height='40'/><rect x='51' y='10' width='40' height='40'/>");
    CHECK(hit(index, 49, 20, 5) == 0);
    CHECK(hit(index, 50.2, 20, 5) == 1);
}

TEST_CASE("a stroke is hit as wide as its pen is") {
    const HitIndex index = index_of(
        "<path transform='matrix(1 0 0 .25 0 37.5)' d='M20 50 H80 V10' fill='none' stroke='red' stroke-width='8'/>");
    CHECK(hit(index, 40, 50.9) == 0);
    CHECK(hit(index, 40, 51.5) == -1);
    CHECK(hit(index, 83.5, 45) == 0);
    CHECK(hit(index, 84.5, 45) == -1);
}

TEST_CASE("a box selects what lies in it as a whole") {
    const HitIndex index = index_of(
        "<rect x='0' y='0' width='100' height='100'/><rect x='10' y='10' width='10' height='10'/>"
        "<rect x='30' y='10' width='10' height='10' stroke='red' stroke-width='6'/><rect x='60' y='10' width='10' "
        "height='10'/>");
    CHECK(index.items_in({{5, -25}, {45, -5}}) == std::vector<std::int32_t>{1, 2});
    CHECK(index.items_in({{5, -25}, {41, -5}}) == std::vector<std::int32_t>{1});
    CHECK(index.items_in({}).empty());
}

TEST_CASE("poses and scales count, and the index finds what a look at every item finds") {
    Grammar grammar;
    grammar.styles = {{.number = 1, .style = {}}};
    const Path unit_square{{-1, -1}, {line_to({1, -1}), line_to({1, 1}), line_to({-1, 1})}, true};
    grammar.terminals = {{.symbol = "S", .style = 1, .paths = {unit_square}}};
    auto picture = std::make_shared<DerivedPicture>();
    picture->grammar = std::make_shared<const Grammar>(grammar);
    picture->looks = {{0, 1}};
    Random random(7);
    const auto number = [&](double low, double high) { return low + (high - low) * random.uniform(); };
    for (std::int32_t i = 0; i < 2000; ++i) {
        const Similarity pose{polar(number(0.1, 3), number(0, 6)), {number(0, 100), number(0, 100)}, i % 2 == 0};
        picture->items.push_back({pose, 0, 1999 - i, {}});
    }
    const HitIndex index(picture);
    for (int k = 0; k < 500; ++k) {
        const Point p{number(0, 100), number(0, 100)};
        int expected = -1;
        for (const PictureItem& item : picture->items) {
            const Point local = apply(inverse(item.pose), p);
            if (std::max(std::abs(local.x), std::abs(local.y)) <= 1) expected = item.order;
        }
        CHECK(index.item_at(p, 0).value_or(-1) == expected);
    }
}

TEST_CASE("nothing is hit in an empty picture") {
    CHECK_FALSE(HitIndex().item_at({}, 10).has_value());
    CHECK_FALSE(index_of("").item_at({}, 10).has_value());
    CHECK(HitIndex().items_in({{-1, -1}, {1, 1}}).empty());
}

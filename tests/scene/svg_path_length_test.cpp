// The worked example of docs/how_to/svg_feature.md.

#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "scene/svg_read.h"
#include "scene/svg_write.h"

using namespace rinceau;

namespace {

SvgReadResult drawn(const std::string& shape) {
    return read_svg(
        "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>"
        "<g fill='none' stroke='#000' stroke-width='4'>" +
        shape + "</g></svg>");
}

Stroke stroke_of(const std::string& shape) {
    const Scene scene = drawn(shape).scene;
    REQUIRE(scene.elements.size() == 1);
    return scene.elements.front().style.stroke;
}

bool same_dashes(const Stroke& a, const Stroke& b) {
    constexpr double rounding = 1e-9;
    if (a.dashes.size() != b.dashes.size() || std::abs(a.dash_offset - b.dash_offset) > rounding) return false;
    for (std::size_t i = 0; i < a.dashes.size(); ++i)
        if (std::abs(a.dashes[i] - b.dashes[i]) > rounding) return false;
    return true;
}

}  // namespace

TEST_CASE("dashes and their offset are parts of the length that the author states") {
    CHECK(same_dashes(stroke_of("<path d='M10 10H90' pathLength='8' stroke-dasharray='1 2' stroke-dashoffset='.5'/>"),
                      stroke_of("<path d='M10 10H90' stroke-dasharray='10 20' stroke-dashoffset='5'/>")));
    const Stroke quarter = stroke_of("<circle cx='50' cy='50' r='20' pathLength='100' stroke-dasharray='25 75'/>");
    REQUIRE(quarter.dashes.size() == 2);
    CHECK(quarter.dashes[0] == Approx(10 * pi).epsilon(3e-4));  // a circle is cubics here
    CHECK(quarter.dashes[1] == Approx(3 * quarter.dashes[0]));
}

TEST_CASE("the closing line of a closed shape counts") {
    CHECK(same_dashes(stroke_of("<path d='M10 10h30v40z' pathLength='12' stroke-dasharray='1'/>"),
                      stroke_of("<path d='M10 10h30v40z' stroke-dasharray='10'/>")));
    CHECK(same_dashes(stroke_of("<rect width='30' height='20' pathLength='10' stroke-dasharray='1'/>"),
                      stroke_of("<rect width='30' height='20' stroke-dasharray='10'/>")));
}

TEST_CASE("dashes in a stated length follow transforms as the shape does") {
    CHECK(same_dashes(stroke_of("<path transform='rotate(30) scale(3)' d='M0 0H8' pathLength='8' stroke-dasharray='1 2'/>"),
                      stroke_of("<path transform='rotate(30) scale(3)' d='M0 0H8' stroke-dasharray='1 2'/>")));
    // A stroke that does not scale is measured as it is seen: 80 px in 8 parts.
    CHECK(same_dashes(stroke_of("<path transform='scale(10)' vector-effect='non-scaling-stroke' d='M0 0H8' pathLength='8' "
                                "stroke-dasharray='1 2'/>"),
                      stroke_of("<path d='M0 0H80' stroke-dasharray='10 20'/>")));
}

TEST_CASE("a stated length of 0 makes the line whole, one that cannot be is told and passed over") {
    CHECK(stroke_of("<path d='M10 10H90' pathLength='0' stroke-dasharray='5'/>").dashes.empty());
    CHECK(stroke_of("<path d='M10 10H90' pathLength='1e-300' stroke-dasharray='5'/>").dashes.empty());
    CHECK(stroke_of("<path d='M10 10H90' pathLength='1e308' stroke-dasharray='1e-30'/>").dashes.empty());
    CHECK(stroke_of("<path d='M10 10h0' stroke-linecap='round' pathLength='0' stroke-dasharray='5'/>").dashes.empty());
    for (const std::string faulty : {"-8", "8px", "1 2", "long"}) {
        const std::string shape = "<path d='M10 10H90' pathLength='" + faulty + "' stroke-dasharray='5 5'/>";
        CHECK(stroke_of(shape).dashes == std::vector<double>{5, 5});
        const std::vector<Warning> warnings = drawn(shape).warnings;
        REQUIRE(warnings.size() == 1);
        CHECK(warnings.front().message.find("pathLength=\"" + faulty + "\"") != std::string::npos);
    }
}

TEST_CASE("what is written needs no stated length") {
    const Scene once = drawn("<path d='M10 10C40 0 60 90 90 30' pathLength='8' stroke-dasharray='1 2'/>").scene;
    const std::string text = write_svg(once);
    CHECK(text.find("pathLength") == std::string::npos);
    CHECK(same_dashes(read_svg(text).scene.elements.front().style.stroke, once.elements.front().style.stroke));
}

#include "analyzer/match_drawn.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace {

using namespace rinceau;

Element square(Point middle, double half) {
    Element element;
    element.paths = {Path{{middle.x - half, middle.y - half},
                          {line_to({middle.x + half, middle.y - half}), line_to({middle.x + half, middle.y + half}),
                           line_to({middle.x - half, middle.y + half})},
                          true}};
    return element;
}

TEST_CASE("An element is found wherever its middle stands to the cells of the search") {
    // Middles at odd multiples of the reach of 4 tolerances stand in the middle of their cells, up to rounding.
    const double tolerance = GENERATE(0.1, 0.23, 1.0 / 3, 0.7);
    Scene scene;
    for (int k = 0; k < 500; ++k) {
        const double at = (2 * k + 1) * 4 * tolerance;
        scene.elements.push_back(square({at, at}, 3));
        scene.elements.push_back(square({at, -at}, 3));
    }
    const std::vector<DrawnMatch> matches = match_drawn(scene, scene, tolerance, 1);
    CHECK(std::ranges::all_of(matches, [](const DrawnMatch& match) { return match.drawn >= 0 && match.deviation == 0; }));
}

}  // namespace

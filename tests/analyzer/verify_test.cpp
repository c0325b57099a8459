#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/verify.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "geometry/random.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr Color red{255, 0, 0};
constexpr Color blue{0, 0, 255};

/// Touching pairs of two colours, in a ring.
Grammar ring() {
    return known_grammar("axiom: P(12)\nP(m) : m > 0 -> [f(20) A f(1) B] +(30) P(m-1)",
                         {{"A", element(hook(), filled(red))}, {"B", element(leaf(), stroked(blue, 0.2))}});
}

/// Another way to write the same outline: later start, the other direction, segments split.
Element rewritten(const Element& element) {
    Element result = element;
    for (Path& path : result.paths) {
        if (!path.closed) continue;
        std::vector<Segment> segments;
        Point from = path.start;
        for (const Segment& s : path.segments) {
            const Point middle = s.straight ? 0.5 * (from + s.to) : 0.125 * (from + 3 * s.control1 + 3 * s.control2 + s.to);
            if (s.straight) {
                segments.insert(segments.begin(), line_to(from));
                segments.insert(segments.begin(), line_to(middle));
            } else {
                const Point c1 = 0.5 * (from + s.control1);
                const Point c2 = 0.25 * (from + 2 * s.control1 + s.control2);
                const Point c3 = 0.25 * (s.control1 + 2 * s.control2 + s.to);
                const Point c4 = 0.5 * (s.control2 + s.to);
                segments.insert(segments.begin(), curve_to(c2, c1, from));
                segments.insert(segments.begin(), curve_to(c4, c3, middle));
            }
            from = s.to;
        }
        if (!(from == path.start)) segments.insert(segments.begin(), line_to(from));
        // Begin at the second segment.
        const Point second = segments.front().to;
        std::rotate(segments.begin(), segments.begin() + 1, segments.end());
        path.start = second;
        path.segments = segments;
    }
    return result;
}

Point& some_node(Element& element) { return element.paths.front().segments[1].to; }

}  // namespace

TEST_CASE("a grammar passes against what it draws, however the drawing is written") {
    const Grammar grammar = ring();
    const Scene scene = drawn_scene(grammar);
    const Verification same = verify(grammar, scene);
    CHECK(same.passed);
    CHECK(same.elements == 24);
    CHECK(same.max_deviation == 0);
    CHECK(same.faulty.empty());
    Scene other = scene;
    for (Element& element : other.elements) element = rewritten(element);
    const Verification again = verify(grammar, other);
    CHECK(again.passed);
    CHECK(again.max_deviation < 1e-5);
    CHECK_FALSE(again.summary.empty());
}

TEST_CASE("a fill without stroke is the same whether its outline is closed or left open") {
    for (const bool stroke : {false, true}) {
        const Path corner{.start = {0, 0}, .segments = {line_to({10, 0}), line_to({10, 10})}, .closed = true};
        const Grammar grammar = known_grammar("axiom: A", {{"A", element({corner}, stroke ? stroked(blue, 0.5) : filled(red))}});
        Scene open = drawn_scene(grammar);
        open.elements.front().paths.front().closed = false;
        CHECK(verify(grammar, open).passed == !stroke);
    }
}

TEST_CASE("a moved node is measured to a hundred-thousandth of the diagonal") {
    const Grammar grammar = ring();
    for (const bool other_way : {false, true}) {
        Scene scene = drawn_scene(grammar);
        if (other_way) scene.elements[4] = rewritten(scene.elements[4]);
        const double diagonal = drawing_diagonal(scene);
        const double tolerance = VerifyOptions{}.tolerance;
        for (const double share : {0.4, 0.9, 1.3, 3.0}) {
            Scene moved = scene;
            Point& node = some_node(moved.elements[4]);
            // Away from the outline: along the bisector of the corner would do, so would any direction that is not along an edge.
            node += share * tolerance * diagonal * Point{std::sqrt(0.5), std::sqrt(0.5)};
            const Verification found = verify(grammar, moved);
            CHECK(found.max_deviation > 0.6 * share * tolerance);
            CHECK(found.max_deviation < share * tolerance + 1e-5);
            CHECK(found.passed == (found.max_deviation <= tolerance));
            if (share == 3.0) {
                CHECK(found.displaced == 1);
                CHECK(found.faulty == std::vector<int>{4});
            }
        }
    }
}

TEST_CASE("what is missing, too much, moved far or painted otherwise is counted and named") {
    const Grammar grammar = ring();
    const Scene scene = drawn_scene(grammar);

    Scene fewer = scene;
    fewer.elements.erase(fewer.elements.begin() + 3);
    CHECK(verify(grammar, fewer).surplus == 1);
    CHECK_FALSE(verify(grammar, fewer).passed);

    Scene more = scene;
    more.elements.push_back(placed(element(circle(), filled(red)), translate({3, 3})));
    CHECK(verify(grammar, more).unmatched == 1);
    CHECK(verify(grammar, more).faulty == std::vector<int>{24});

    Scene moved = scene;
    moved.elements[5] = placed(moved.elements[5], translate({0.5, 0}));
    CHECK(verify(grammar, moved).unmatched == 1);
    CHECK(verify(grammar, moved).surplus == 1);
    CHECK(verify(grammar, moved).faulty == std::vector<int>{5});

    Scene recolored = scene;
    recolored.elements[6].style.fill = blue;
    CHECK(verify(grammar, recolored).wrong_style == 1);
    CHECK(verify(grammar, recolored).faulty == std::vector<int>{6});

    Scene widened = scene;
    widened.elements[7].style.stroke.width *= 1.2;
    CHECK(verify(grammar, widened).wrong_style == 1);
}

TEST_CASE("the order of what overlaps counts, and of what does not, does not") {
    const Grammar grammar = ring();
    const Scene scene = drawn_scene(grammar);
    Scene swapped = scene;
    std::swap(swapped.elements[8], swapped.elements[9]);
    const Verification found = verify(grammar, swapped);
    CHECK(found.wrong_order == 1);
    CHECK(found.faulty == std::vector<int>{8, 9});
    CHECK_FALSE(found.passed);

    Scene rotated = scene;
    std::rotate(rotated.elements.begin(), rotated.elements.begin() + 10, rotated.elements.end());
    CHECK(verify(grammar, rotated).passed);
}

TEST_CASE("a hole that winds like its island is another picture under the non-zero rule") {
    const Grammar grammar = known_grammar("axiom: A", {{"A", element(frame(5), filled(red))}});
    Scene scene = drawn_scene(grammar);
    std::vector<Path>& paths = scene.elements.front().paths;
    paths[1] = transformed(paths[1], to_affine(Similarity{{-1, 0}, {}, true}));
    CHECK_FALSE(verify(grammar, scene).passed);
    scene.elements.front().style.fill_rule = FillRule::evenodd;
    const Grammar evenodd = known_grammar("axiom: A", {{"A", element(frame(5), Style{.fill = red, .fill_rule = FillRule::evenodd})}});
    CHECK(verify(evenodd, scene).passed);
}

TEST_CASE("elements that coincide are told apart by style, and equal ones are matched whatever their number") {
    std::string axiom = "axiom:";
    for (int i = 0; i < 200; ++i) axiom += i % 2 == 0 ? " A" : " B";
    const Grammar grammar = known_grammar(axiom, {{"A", element(circle(), filled(red))}, {"B", element(circle(), filled(blue))}});
    const Scene scene = drawn_scene(grammar);
    CHECK(verify(grammar, scene).passed);
    Scene other = scene;
    std::swap(other.elements[10], other.elements[11]);
    const Verification found = verify(grammar, other);
    CHECK(found.unmatched == 0);
    CHECK(found.wrong_style == 0);
    CHECK(found.wrong_order == 1);
}

TEST_CASE("verbatim elements must stand where they stood, byte for byte") {
    const Element text{.verbatim = "<text x=\"1\">a</text>", .verbatim_box = {{0, 0}, {2, 2}}};
    const Grammar grammar = known_grammar("axiom: A T", {{"A", element(circle(), filled(red))}, {"T", text}});
    Scene scene = drawn_scene(grammar);
    CHECK(verify(grammar, scene).passed);
    scene.elements[1].verbatim = "<text x=\"2\">a</text>";
    CHECK(verify(grammar, scene).unmatched == 1);
    const Grammar shifted = known_grammar("axiom: A f(1) T", {{"A", element(circle(), filled(red))}, {"T", text}});
    scene.elements[1].verbatim = text.verbatim;
    CHECK_FALSE(verify(shifted, scene).passed);
}

TEST_CASE("neighbours nearer to each other than the tolerance are matched one to one") {
    Random random(9);
    std::string axiom = "axiom:";
    for (int i = 0; i < 300; ++i) {
        axiom += " [f(" + std::to_string(random.uniform(0, 100)) + ") +(90) f(" + std::to_string(random.uniform(0, 3)) + ") A]";
    }
    const Grammar grammar = known_grammar(axiom, {{"A", element(circle(0.5), filled(red))}});
    const Verification found = verify(grammar, shuffled(drawn_scene(grammar), random), {.tolerance = 2e-3});
    CHECK(found.passed);
    CHECK(found.max_deviation < 1e-9);
}

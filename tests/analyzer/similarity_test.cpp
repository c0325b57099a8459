// The table of docs/analysis.md, 1, and what a group of similar elements promises.
#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/similarity_scenes.h"
#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// Largest distance of points of `a` from the polylines of `b`.
double distance_from(const std::vector<Path>& a, const std::vector<Path>& b) {
    constexpr double fine = 1e-4;
    double largest = 0;
    for (const Path& path : a)
        for (const Point p : flattened(path, fine)) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const Path& other : b) {
                const std::vector<Point> line = flattened(other, fine);
                for (std::size_t i = 0; i < line.size(); ++i) {
                    if (i + 1 == line.size() && !other.closed) break;
                    const Point from = line[i];
                    const Point along = line[(i + 1) % line.size()] - from;
                    const double share = norm(along) > 0 ? std::clamp(dot(p - from, along) / norm(along), 0.0, 1.0) : 0;
                    nearest = std::min(nearest, abs(p - from - share * along));
                }
            }
            largest = std::max(largest, nearest);
        }
    return largest;
}

}  // namespace

TEST_CASE("seventy shapes are told apart and their copies found, however they are turned, mirrored and written") {
    const CopiedScene truth = copied_scene(different_outlines(), 2100, 0, 1);
    const Instancing found = group_similar_elements(truth.scene);
    CHECK(found.looks.size() == 70);
    CHECK(found.shapes == 70);
    const PairScore score = pair_score(truth, found);
    CHECK(score.purity == 1);
    CHECK(score.recall == 1);
    CHECK(pose_error(truth, found) < 1e-8);
}

TEST_CASE("copies whose numbers are off by a ten-thousandth are still found") {
    const CopiedScene truth = copied_scene(different_outlines(), 2100, 1e-4, 2);
    const Instancing found = group_similar_elements(truth.scene);
    CHECK(found.looks.size() == 70);
    const PairScore score = pair_score(truth, found);
    CHECK(score.purity == 1);
    CHECK(score.recall == 1);
    CHECK(pose_error(truth, found) < 2e-3);
}

TEST_CASE("every element's outline is its look's outline under its pose, both ways") {
    const CopiedScene truth = copied_scene(different_outlines(), 210, 1e-3, 3);
    const SimilarityOptions options;
    const Instancing found = group_similar_elements(truth.scene, options);
    for (std::size_t i = 0; i < found.instances.size(); ++i) {
        const Instance& instance = found.instances[i];
        const std::vector<Path> drawn = transformed(found.looks[static_cast<std::size_t>(instance.look)].paths, instance.pose);
        const std::vector<Path>& wanted = truth.scene.elements[i].paths;
        const double allowed = std::min(options.tolerance * scale_of(instance.pose),
                                        options.tolerance_of_diagonal * diagonal(truth.scene.viewport));
        CHECK(distance_from(drawn, wanted) < allowed + 2e-4);
        CHECK(distance_from(wanted, drawn) < allowed + 2e-4);
    }
}

TEST_CASE("exact copies get exact poses") {
    Random random(5);
    for (const std::vector<Path>& outline : {hook(), blob(7, random), leaf(), star(5)}) {
        CopiedScene truth;
        truth.scene.viewport = {{-500, -500}, {500, 500}};
        for (int i = 0; i < 20; ++i) {
            truth.pose.push_back(random_similarity(random));
            truth.shape.push_back(0);
            truth.scene.elements.push_back(placed(element(outline, filled({})), truth.pose.back()));
        }
        const Instancing found = group_similar_elements(truth.scene);
        REQUIRE(found.looks.size() == 1);
        CHECK(pose_error(truth, found) < 1e-10);
    }
}

TEST_CASE("the unit frame has the outline's centroid at its origin and rms radius 1") {
    Random random(6);
    Scene scene{{{0, 0}, {100, 100}}, true, {}};
    scene.elements.push_back(placed(element(rectangle(30, 10), filled({})), translate({40, 40})));
    const Instancing found = group_similar_elements(scene);
    const Box box = bounds(found.looks[0].paths);
    CHECK(abs(center(box)) < 1e-12);
    // Perimeter 80; mean of x^2 = (2 * 30 * 30^2/12 + 20 * 15^2) / 80, of y^2 = (2 * 10 * 10^2/12 + 60 * 5^2) / 80.
    const double radius = std::sqrt((4500 + 4500 + 500.0 / 3 + 1500) / 80);
    CHECK(scale_of(found.instances[0].pose) == Approx(radius));
    CHECK(width(box) == Approx(30 / radius));
    CHECK(abs(found.instances[0].pose.translation - Point{40, 40}) < 1e-12);
    CHECK(arg(found.instances[0].pose.linear) == 0);
}

TEST_CASE("mirror images are shapes of their own when that is asked for") {
    Scene scene{{{-10, -10}, {10, 10}}, true, {}};
    scene.elements.push_back(element(hook(), filled({})));
    scene.elements.push_back(placed(element(hook(), filled({})), mirror_about_heading()));
    CHECK(group_similar_elements(scene).looks.size() == 1);
    CHECK(group_similar_elements(scene).instances[1].pose.mirrored);
    CHECK(group_similar_elements(scene, {.mirrored_copies = false}).looks.size() == 2);
}

TEST_CASE("coordinates rounded to two decimals do not split a group") {
    Random random(8);
    Scene scene{{{0, 0}, {400, 400}}, true, {}};
    for (int i = 0; i < 60; ++i) {
        Similarity pose{polar(random.uniform(8, 12), random.uniform(-pi, pi)), {random.uniform(20, 380), random.uniform(20, 380)}};
        Element copy = placed(element(star(5), filled({})), pose);
        const auto rounded = [](double x) { return std::round(100 * x) / 100; };
        for (Segment& s : copy.paths[0].segments) s = line_to({rounded(s.to.x), rounded(s.to.y)});
        copy.paths[0].start = {rounded(copy.paths[0].start.x), rounded(copy.paths[0].start.y)};
        scene.elements.push_back(copy);
    }
    CHECK(group_similar_elements(scene).looks.size() == 1);
}

TEST_CASE("far from the origin small shapes keep their size") {
    Scene scene{{{1e6, -1e6 - 100}, {1e6 + 100, -1e6}}, true, {}};
    for (int i = 0; i < 25; ++i) {
        const Point at{1e6 + 10 + 10 * (i % 5), -1e6 - 10 - 10 * (i / 5)};
        scene.elements.push_back(placed(element(rectangle(0.5, 0.5), filled({})), translate(at)));
    }
    const Instancing found = group_similar_elements(scene);
    REQUIRE(found.looks.size() == 1);
    for (const Instance& instance : found.instances) {
        CHECK(instance.pose.linear == found.instances[0].pose.linear);
        CHECK(scale_of(instance.pose) == Approx(0.5 / std::sqrt(3.0)).epsilon(1e-8));
    }
}

TEST_CASE("points, specks and zero-length lines are dots of the size of their stroke") {
    Scene scene{{{0, 0}, {100, 100}}, true, {}};
    Style round = stroked({}, 6);
    round.stroke.cap = LineCap::round;
    scene.elements.push_back(element({Path{.start = {10, 10}, .segments = {line_to({10, 10})}}}, round));
    scene.elements.push_back(element({Path{.start = {30, 10}, .segments = {line_to({30, 10})}}}, round));
    round.stroke.width = 3;
    scene.elements.push_back(element({Path{.start = {50, 10}}}, round));
    scene.elements.push_back(placed(element(regular_polygon(4), round), {{1e-9, 0}, {70, 10}, false}));
    const Instancing found = group_similar_elements(scene);
    REQUIRE(found.looks.size() == 1);
    CHECK(found.looks[0].symmetry.continuous);
    CHECK(found.looks[0].unit_style.stroke.width == Approx(1));
    CHECK(scale_of(found.instances[0].pose) == Approx(6));
    CHECK(scale_of(found.instances[2].pose) == Approx(3));
    CHECK(abs(found.instances[1].pose.translation - Point{30, 10}) < 1e-12);
}

TEST_CASE("a grid of symmetric shapes gets equal angles, and a turned copy the smallest turn") {
    Random random(9);
    Scene scene{{{0, 0}, {100, 100}}, true, {}};
    for (int i = 0; i < 9; ++i) {
        const Similarity place = translate({10.0 + 30 * (i % 3), 10.0 + 30 * (i / 3)});
        scene.elements.push_back(element(transformed(redrawn(rectangle(8, 8), random), place), filled({})));
    }
    scene.elements.push_back(placed(element(rectangle(8, 8), filled({})), translate({90, 90}) * rotate(radians(100))));
    const Instancing found = group_similar_elements(scene);
    REQUIRE(found.looks.size() == 1);
    for (int i = 0; i < 9; ++i) {
        CHECK(std::abs(arg(found.instances[static_cast<std::size_t>(i)].pose.linear)) < 1e-12);
        CHECK_FALSE(found.instances[static_cast<std::size_t>(i)].pose.mirrored);
    }
    CHECK(arg(found.instances[9].pose.linear) == Approx(radians(10)));
}

TEST_CASE("an open path that is only filled equals its closed version, a stroked one does not") {
    Path open = hook()[0];
    open.closed = false;
    const auto looks = [&](const Style& style) {
        Scene scene{{{-10, -10}, {10, 10}}, true, {element(hook(), style), element({open}, style)}};
        return group_similar_elements(scene).looks.size();
    };
    CHECK(looks(filled({})) == 1);
    CHECK(looks(stroked({}, 0.1)) == 2);
}

TEST_CASE("a ring is not a disc with a line around its middle, though their outlines are equal") {
    std::vector<Path> ring = frame(6);
    std::vector<Path> solid = regular_polygon(6);
    solid.push_back(regular_polygon(6, 0.6)[0]);  // winds the same way: nonzero fills it
    const Scene scene{{{-10, -10}, {10, 10}}, true, {element(ring, filled({})), element(solid, filled({}))}};
    const Instancing found = group_similar_elements(scene);
    CHECK(found.shapes == 1);
    CHECK(found.looks.size() == 2);
}

TEST_CASE("verbatim elements are looks of their own") {
    Scene scene{{{-10, -10}, {10, 10}}, true, {element(hook(), filled({}))}};
    scene.elements.push_back(Element{.verbatim = "<text>a</text>"});
    scene.elements.push_back(Element{.verbatim = "<text>a</text>"});
    const Instancing found = group_similar_elements(scene);
    REQUIRE(found.looks.size() == 3);
    CHECK(found.looks[1].verbatim == "<text>a</text>");
    CHECK(found.instances[2].look == 2);
    CHECK(found.instances[2].pose == Similarity{});
    CHECK(found.looks[2].symmetry.elements.size() == 1);
}

TEST_CASE("no elements, no looks") {
    const Instancing found = group_similar_elements(Scene{});
    CHECK(found.looks.empty());
    CHECK(found.instances.empty());
}

TEST_CASE("moving, turning, scaling and mirroring a drawing leaves its groups alone") {
    const CopiedScene truth = copied_scene(different_outlines(), 280, 0, 11);
    const Instancing before = group_similar_elements(truth.scene);
    const Similarity map{polar(2.5, 1), {30, -70}, true};
    Scene moved = truth.scene;
    for (Element& e : moved.elements) e = placed(e, map);
    moved.viewport = {{-1250, -1250}, {1250, 1250}};
    const Instancing after = group_similar_elements(moved);
    REQUIRE(after.looks.size() == before.looks.size());
    for (std::size_t i = 0; i < before.instances.size(); ++i) CHECK(after.instances[i].look == before.instances[i].look);
}

// Aggregates: dense, without overlap, the same however they are made.

#include <catch2/catch.hpp>

#include "tests/growth/aggregate_shapes.h"
#include "geometry/polygon.h"
#include "growth/aggregate/fill_aggregate.h"
#include "growth/aggregate/packing.h"
#include "growth/aggregate/shake.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

const std::vector<ExclusiveRegion> shapes = star_bar_and_bow();
const PackDomain square{.box = {{0, 0}, {400, 400}}};

std::vector<Region> outlines_of(const std::vector<PlacedRegion>& placed) {
    std::vector<Region> outlines;
    for (const PlacedRegion& region : placed) outlines.push_back(outline_of(shapes, region));
    return outlines;
}

Aggregate filled(const AggregateOptions& options, const PackDomain& domain = square) {
    return fill_aggregate(shapes, domain, options, "shapes.svg");
}

bool same_placements(const std::vector<PlacedRegion>& a, const std::vector<PlacedRegion>& b) {
    return std::ranges::equal(
        a, b, [](const PlacedRegion& x, const PlacedRegion& y) { return x.shape == y.shape && x.pose == y.pose; });
}

std::vector<double> counts_of(const std::vector<PlacedRegion>& placed) {
    std::vector<double> counts(shapes.size(), 0.0);
    for (const PlacedRegion& region : placed) ++counts[static_cast<std::size_t>(region.shape)];
    return counts;
}

}  // namespace

TEST_CASE("no method lets two regions overlap or leave the domain") {
    for (const PackMethod method : {PackMethod::naive, PackMethod::gaps, PackMethod::settle})
        for (const PackQuality quality : {PackQuality::fast, PackQuality::best}) {
            AggregateOptions options{
                .method = method, .quality = quality, .min_scale = 0.5, .share_tolerance = 1, .stop = 200, .shakes = 1};
            const Aggregate aggregate = filled(options);
            CHECK(aggregate.complete);
            CHECK(aggregate.placed.size() > 60);
            CHECK(area_covered_twice(outlines_of(aggregate.placed)) <= 1e-9 * covered_area(shapes, aggregate.placed));
            for (const Region& outline : outlines_of(aggregate.placed)) REQUIRE(contains(square.box, bounds(outline)));
            for (const PlacedRegion& region : aggregate.placed) {
                REQUIRE(scale_of(region.pose) >= 0.5 * (1 - 1e-12));
                REQUIRE(scale_of(region.pose) <= 1 + 1e-12);
            }
            CHECK(aggregate.counts.attempted == aggregate.counts.cancelled + aggregate.placed.size());
        }
}

TEST_CASE("settling places more than darts, and shaking covers more with every round") {
    const Aggregate darts = filled({.method = PackMethod::naive});
    const Aggregate settled = filled({});
    CHECK(settled.placed.size() >= darts.placed.size());
    double before = covered_area(shapes, settled.placed);
    for (const int rounds : {1, 2, 3}) {
        const Aggregate shaken = filled({.quality = PackQuality::best, .shakes = rounds});
        const double covered = covered_area(shapes, shaken.placed);
        CHECK(covered >= before);
        before = covered;
    }
    CHECK(before >= 1.15 * covered_area(shapes, darts.placed));
}

TEST_CASE("the same seed gives the same placements however the work is cut") {
    AggregateOptions options{.quality = PackQuality::best, .min_scale = 0.7, .stop = 150, .shakes = 1, .seed = 5};
    const Aggregate at_once = filled(options);
    AggregateFill fill(shapes, square, options, "shapes.svg");
    double before = 0;
    for (std::size_t tries = 1; fill.step(tries); tries = tries % 37 + 3) {
        REQUIRE(fill.fraction() >= before);
        before = fill.fraction();
    }
    CHECK(fill.fraction() == 1);
    CHECK(same_placements(fill.placed(), at_once.placed));
    CHECK(fill.counts().attempted == at_once.counts.attempted);
    options.seed = 6;
    CHECK_FALSE(same_placements(filled(options).placed, at_once.placed));
}

TEST_CASE("a tile laid beside itself in both directions is free of overlap") {
    const PackDomain tile{.box = {{10, 20}, {250, 240}}, .tiled = true};
    for (const PackMethod method : {PackMethod::gaps, PackMethod::settle}) {
        const Aggregate aggregate = filled({.method = method, .quality = PackQuality::best, .shakes = 1}, tile);
        std::vector<Region> outlines;
        std::size_t over_the_edge = 0;
        for (const PlacedRegion& region : aggregate.placed) {
            for (const Point shift : {Point{0, 0}, Point{240, 0}, Point{0, 220}, Point{240, 220}})
                outlines.push_back(outline_of(shapes, region, shift));
            over_the_edge += !contains(tile.box, bounds(outline_of(shapes, region)));
        }
        CHECK(over_the_edge > 3);
        CHECK(area_covered_twice(outlines) <= 1e-9 * 4 * covered_area(shapes, aggregate.placed));
    }
}

TEST_CASE("nothing stands outside of a region or in its holes") {
    std::vector<Point> round, hole;
    for (int i = 0; i < 90; ++i) {
        round.push_back(Point{200, 200} + polar(190, two_pi * i / 90));
        hole.push_back(Point{180, 220} + polar(60, two_pi * i / 90));
    }
    const PackDomain ring{.box = {{0, 0}, {400, 400}}, .region = Region{round, hole, box_ring(290, 190, 30, 30)}};
    for (const PackQuality quality : {PackQuality::fast, PackQuality::best}) {
        const Aggregate aggregate = filled({.quality = quality, .min_scale = 0.7, .stop = 150, .shakes = 1}, ring);
        CHECK(aggregate.placed.size() > 40);
        Region all;
        for (const Region& outline : outlines_of(aggregate.placed)) all = union_of(all, outline);
        CHECK(area(difference_of(all, *ring.region)) <= 1e-9 * area(all));
    }
}

TEST_CASE("angles are those that are allowed, also after shaking and along a flow") {
    const auto all_near = [](const Aggregate& aggregate, double low, double high, auto from) {
        return std::ranges::all_of(aggregate.placed, [&](const PlacedRegion& region) {
            const double angle = wrap_angle(arg(region.pose.linear) - from(region.pose.translation));
            return angle >= low - 1e-9 && angle <= high + 1e-9;
        });
    };
    const auto level = [](Point) { return 0.0; };
    AggregateOptions options{.quality = PackQuality::best, .shakes = 1};
    options.angles.only = {0.5, -1.25};
    const Aggregate two = filled(options);
    CHECK(std::ranges::all_of(two.placed, [](const PlacedRegion& region) {
        const double angle = arg(region.pose.linear);
        return std::abs(angle - 0.5) < 1e-9 || std::abs(angle + 1.25) < 1e-9;
    }));
    options.angles = {.low = -0.2, .high = 0.3};
    CHECK(all_near(filled(options), -0.2, 0.3, level));
    const std::vector<Polyline> strokes{{{0, 0}, {200, 80}, {400, 400}}};
    const auto flow = std::make_shared<const FlowField>(make_flow_field(strokes, square.box, {.step = 10}, "flow.svg"));
    options.angles = {.only = {0}, .flow = flow};
    CHECK(all_near(filled(options), 0, 0, [&](Point p) { return arg(direction_at(*flow, p)); }));
}

TEST_CASE("shares are kept within their tolerance") {
    const std::vector<double> wanted{0.5, 0.3, 0.2};
    for (const double tolerance : {0.0, 0.1, 0.4}) {
        const Aggregate aggregate = filled({.shares = {5, 3, 2}, .share_tolerance = tolerance});
        const std::vector<double> counts = counts_of(aggregate.placed);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const double expected = wanted[i] * static_cast<double>(aggregate.placed.size());
            CHECK(std::abs(counts[i] - expected) <= tolerance * expected + 1);
        }
    }
    CHECK(counts_of(filled({.shares = {1, 0, 1}}).placed)[1] == 0);
}

TEST_CASE("a density picture says how much of the plane is covered") {
    // Left half dense, right half with a third of it, a strip at the right side with nothing.
    const auto picture = std::make_shared<const DensityPicture>(
        DensityPicture{.columns = 5, .rows = 1, .values = {1, 1, 0.33, 0.33, 0}, .box = {{0, 0}, {1000, 400}}});
    const PackDomain wide{.box = {{0, 0}, {1000, 400}}};
    const auto covered_between = [&](const Aggregate& aggregate, double low, double high) {
        double sum = 0;
        for (const PlacedRegion& region : aggregate.placed)
            if (const double x = region.pose.translation.x; x >= low && x < high)
                sum += shapes[static_cast<std::size_t>(region.shape)].area * norm(region.pose.linear);
        return sum;
    };
    const Aggregate aggregate = filled({.density = picture}, wide);
    const double dense = covered_between(aggregate, 50, 300), sparse = covered_between(aggregate, 500, 700) * 250 / 200;
    CHECK(sparse / dense == Approx(0.33).margin(0.13));
    CHECK(covered_between(aggregate, 920, 1000) == 0);
    // Darts know no distances; they stay or go by chance.
    const Aggregate darts = filled({.method = PackMethod::naive, .density = picture, .stop = 300}, wide);
    CHECK(covered_between(darts, 50, 300) > covered_between(darts, 500, 750));
    CHECK(covered_between(darts, 920, 1000) == 0);
}

TEST_CASE("it ends at a count, and when it is told to, with what is placed") {
    CHECK(filled({.max_count = 7}).placed.size() == 7);
    int asked = 0;
    const Aggregate stopped =
        fill_aggregate(shapes, square, {.method = PackMethod::naive}, "shapes.svg", [&] { return ++asked == 2; });
    CHECK_FALSE(stopped.complete);
    CHECK(!stopped.placed.empty());
    struct Cancelled {};
    CHECK_THROWS_AS(
        fill_aggregate(shapes, square, {}, "shapes.svg", {}, [](std::string_view, double) { throw Cancelled{}; }),
        Cancelled);
}

TEST_CASE("what cannot be packed is refused in one sentence") {
    const auto refusal = [](const AggregateOptions& options, const PackDomain& domain) -> std::string {
        try {
            AggregateFill(shapes, domain, options, "shapes.svg");
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    using Catch::Contains;
    CHECK_THAT(refusal({}, {.box = {{0, 0}, {100, 0}}}), Contains("shapes.svg") && Contains("no area"));
    CHECK_THAT(refusal({}, {.box = {{0, 0}, {9, 9}}}), Contains("no shape fits"));
    CHECK_THAT(refusal({}, {.box = {{0, 0}, {90, 400}}, .tiled = true}), Contains("two diameters"));
    CHECK_THAT(refusal({.min_scale = 2, .max_scale = 1}, square), Contains("scale"));
    CHECK_THAT(refusal({.min_scale = 0}, square), Contains("scale"));
    CHECK_THAT(refusal({.shares = {1, 2}}, square), Contains("3 shapes and 2 shares"));
    CHECK_THAT(refusal({.shares = {0, 0, 0}}, square), Contains("shares"));
    CHECK_THAT(refusal({}, {.box = square.box, .region = Region{{{0, 0}, {5, 0}, {9, 0}}}}), Contains("no area"));
    CHECK_THAT(refusal({}, {.box = square.box, .region = Region{box_ring(0, 0, 50, 50)}, .tiled = true}), Contains("tile"));
    // A bar that fits nowhere leaves the place to the others; a region too narrow for all of them says so at the end.
    CHECK(counts_of(filled({}, {.box = {{0, 0}, {45, 60}}}).placed)[1] == 0);
    std::vector<Point> zigzag;
    for (int i = 0; i <= 40; ++i) zigzag.push_back({10.0 * i, i % 2 == 0 ? 0.0 : 30.0});
    for (int i = 40; i >= 0; --i) zigzag.push_back({10.0 * i, i % 2 == 0 ? 6.0 : 36.0});
    CHECK_THROWS_WITH(filled({}, {.box = square.box, .region = Region{zigzag}}), Contains("no shape has found"));
}

TEST_CASE("what settles and is refused by the field would be refused by the exact test") {
    Packing packing(shapes, square, {.seed = 3}, "shapes.svg");
    for (int i = 0; i < 2000; ++i) packing.try_place(packing.next_shape(), packing.draw_pose(packing.draw_point()));
    packing.make_field();
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const int shape = packing.next_shape();
        const PackPose pose = packing.draw_pose(packing.draw_point());
        const Similarity at = similarity_of(pose, packing.options().angles);
        for (const InnerDisc& disc : packing.region(shape).discs) {
            if (packing.field().at(apply(at, disc.center)) >= disc.radius * pose.scale - 0.7 * packing.field().step())
                continue;
            REQUIRE_FALSE(packing.is_free(shape, pose));
            ++refused;
            break;
        }
        packing.cancel();
    }
    CHECK(refused > 1000);
}

}  // namespace rinceau

// The bars are those of docs/growth.md, "What is measured".

#include <algorithm>
#include <optional>

#include "growth/aggregate/fill_aggregate.h"
#include "growth/measure/measure_aggregate.h"
#include "growth_bench.h"

namespace rinceau::test {
namespace {

constexpr double naive_seconds = 5;
constexpr std::size_t endless = 1'000'000'000;

struct Filled {
    std::vector<PlacedRegion> placed;
    double seconds = 0;
    double covered = 0;  ///< sum of areas over the domain's
};

struct Run {
    PackMethod method = PackMethod::settle;
    PackQuality quality = PackQuality::fast;
    std::size_t stop = 0;
    bool tiled = false;
};

double area_of(const ShapeCase& one, const PlacedRegion& placed) {
    const double scale = scale_of(placed.pose);
    return scale * scale * one.regions[static_cast<std::size_t>(placed.shape)].area;
}

PackDomain square(const ShapeCase& one, bool tiled = false) { return {{{0, 0}, {one.side, one.side}}, {}, tiled}; }

AggregateOptions options_for(const ShapeCase& one, const Run& run) {
    AggregateOptions options;
    options.method = run.method;
    options.quality = run.quality;
    options.min_scale = one.min_scale;
    options.max_scale = one.max_scale;
    options.share_tolerance = one.share_tolerance;
    options.stop = run.stop;
    return options;
}

/// To the end, or as long as `go_on(seconds, covered)` says so; the seconds are those when the last shape was placed if it
/// was ended.
template <class GoOn>
Filled filled_while(const ShapeCase& one, const Run& run, const GoOn& go_on) {
    constexpr std::size_t tries_a_step = 20;
    const std::clock_t begin = std::clock();
    AggregateFill fill(one.regions, square(one, run.tiled), options_for(one, run), one.name);
    Filled result;
    std::size_t counted = 0;
    bool more = true;
    while (more && go_on(processor_seconds(begin), result.covered)) {
        more = fill.step(tries_a_step);
        if (fill.placed().size() == counted) continue;
        result.seconds = processor_seconds(begin);
        // What was shaken has other places but the same areas.
        for (; counted < fill.placed().size(); ++counted)
            result.covered += area_of(one, fill.placed()[counted]) / (one.side * one.side);
    }
    if (!more) result.seconds = processor_seconds(begin);
    result.placed = fill.placed();
    result.covered = 0;
    for (const PlacedRegion& placed : result.placed) result.covered += area_of(one, placed) / (one.side * one.side);
    return result;
}

/// The least time of three runs, which are the same.
Filled filled(const ShapeCase& one, const Run& run) {
    Filled result;
    for (int again = 0; again < 3; ++again) {
        Filled next = filled_while(one, run, [](double, double) { return true; });
        if (again == 0 || next.seconds < result.seconds) result = std::move(next);
    }
    return result;
}

/// `chance`: the autocorrelation peak of darts, which know no period; none for darts themselves.
double result_lines(GrowthLines& lines, const ShapeCase& one, const Filled& result, bool tiled,
                    std::optional<double> chance) {
    const AggregateMeasures measures = measure_aggregate(one.regions, result.placed, square(one, tiled));
    lines.say("placed", static_cast<double>(measures.placed));
    lines.say("seconds", result.seconds);
    lines.at_most("overlaps", static_cast<double>(measures.overlaps), 0);
    lines.between("sum of areas less area of the union, share", measures.overlap_area / measures.area, -1e-9, 1e-9);
    lines.at_most("outside of the domain, share", measures.outside_area / measures.area, 1e-9);
    lines.say("coverage", measures.coverage);
    lines.say("largest empty circle, over R", measures.largest_gap_ratio);
    if (chance) {
        lines.at_most("autocorrelation peak", measures.autocorrelation, std::max(0.05, *chance));
    } else {
        lines.say("autocorrelation peak", measures.autocorrelation);
    }
    const auto [fewest, most] = std::minmax_element(measures.counts.begin(), measures.counts.end());
    lines.say("rarest shape over commonest", *most > 0 ? static_cast<double>(*fewest) / static_cast<double>(*most) : 0);
    return measures.autocorrelation;
}

void method_lines(GrowthLines& lines, const ShapeCase& one, const GrowthPictures& pictures) {
    const auto begin = [&](const std::string& what) { lines.begin("aggregate: " + one.name + ", " + what); };
    std::optional<double> chance;
    const auto shown = [&](const std::string& what, const Run& run) {
        begin(what);
        Filled result = filled(one, run);
        pictures.draw(one.name + " " + what, one, result.placed);
        const double peak = result_lines(lines, one, result, run.tiled, chance);
        if (run.method == PackMethod::naive) chance = peak;
        return result;
    };
    const Filled naive = shown("naive", {PackMethod::naive, PackQuality::fast, 10'000});
    const Filled gaps = shown("gaps", {PackMethod::gaps});
    const Filled fast = shown("default", {});
    const auto placed = [](const Filled& run) { return static_cast<double>(run.placed.size()); };
    lines.at_least("count over naive", placed(fast) / placed(naive), 1);
    lines.at_most("time over naive", fast.seconds / naive.seconds, 1);
    lines.say("count over gaps", placed(fast) / placed(gaps));
    lines.say("time over gaps", fast.seconds / gaps.seconds);
    const double of_224 = one.min_scale < one.max_scale ? 0 : 224 / placed(fast);
    if (of_224 > 0) lines.at_most("seconds for 224 shapes", fast.seconds * of_224, 0.1);
    const Filled best = shown("best", {.quality = PackQuality::best});
    if (of_224 > 0) lines.at_most("seconds for 224 shapes", best.seconds * 224 / placed(best), 0.3);
    const Filled long_naive = filled_while(one, {PackMethod::naive, PackQuality::fast, endless},
                                           [&](double seconds, double) { return seconds < 10 * best.seconds; });
    lines.at_least("coverage over naive ten times as long", best.covered / long_naive.covered, 1.2);
    shown("tile", {.tiled = true});

    begin("time to the coverage of naive in 5 s");
    const Filled slow = filled_while(one, {PackMethod::naive, PackQuality::fast, endless},
                                     [](double seconds, double) { return seconds < naive_seconds; });
    lines.say("coverage of naive", slow.covered);
    lines.say("its seconds", slow.seconds);
    const Filled soon =
        filled_while(one, {PackMethod::settle, PackQuality::fast, endless},
                     [&](double seconds, double covered) { return covered < slow.covered && seconds < naive_seconds; });
    lines.say("seconds of settle", soon.seconds);
    lines.at_least("coverage reached", soon.covered / slow.covered, 1);
    // The bar is for some 250 shapes; of many sizes there are four times as many.
    if (of_224 > 0) {
        lines.at_least("times faster", slow.seconds / soon.seconds, 20);
    } else {
        lines.say("times faster", slow.seconds / soon.seconds);
    }
}

}  // namespace

void aggregate_lines(GrowthLines& lines, const std::vector<ShapeCase>& cases, const std::string& only,
                     const GrowthPictures& pictures) {
    for (const ShapeCase& one : cases) {
        if (one.name.find(only) == std::string::npos) continue;
        try {
            method_lines(lines, one, pictures);
        } catch (const std::exception& error) {
            lines.failed(error.what());
        }
    }
}

void aggregate_speed_lines(GrowthLines& lines, const std::string& shape_folder) {
    lines.begin("aggregate, speed: wrench, saw, feather, snake");
    const auto run = [&](double shapes) { return filled(shape_cases(shape_folder, shapes, "wrench").at(0), {}); };
    const Filled few = run(1000), many = run(10'000);
    const auto each = [](const Filled& result) { return result.seconds / static_cast<double>(result.placed.size()); };
    lines.say("1,000 shapes: seconds", 1000 * each(few));
    lines.at_most("10,000 shapes: seconds", 10'000 * each(many), 4);
    lines.at_most("cost of a shape at 10,000 over 1,000", each(many) / each(few), 1.5);
}

}  // namespace rinceau::test

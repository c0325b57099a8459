// The bars are those of docs/growth.md, "What is measured".

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "growth/arrangement/boundary.h"
#include "growth/flow_field.h"
#include "growth/measure/measure_arrangement.h"
#include "growth/measure/outline_overlaps.h"
#include "growth_bench.h"

namespace rinceau::test {
namespace {

struct Grown {
    ElementArrangement arrangement;
    double seconds = 0;
};

Grown grown(const Exemplar& exemplar, std::size_t count, const ArrangeOptions& options,
            const ArrangeSurroundings& around = {}, Point start = {}) {
    const std::clock_t begin = std::clock();
    ElementArrangement arrangement = with_seed(empty_arrangement(exemplar, options), exemplar, around, start);
    const GrowOrder order{.count = count};
    arrangement = grow(std::move(arrangement), exemplar, around, order);
    arrangement = finished(std::move(arrangement), exemplar, around, order);
    return {std::move(arrangement), processor_seconds(begin)};
}

void overlap_lines(GrowthLines& lines, const Exemplar& exemplar, const ElementArrangement& arrangement,
                   const ArrangementMeasures& measures) {
    const auto overlaps = static_cast<double>(measures.overlaps), near = static_cast<double>(measures.too_near);
    if (exemplar.outlines_overlap) {
        std::vector<PlacedOutline> outlines;
        for (const ExemplarElement& element : exemplar.elements)
            outlines.push_back({&element.outline, translate(element.position)});
        // Of neighbours: elements at a rim have fewer.
        const auto of_edges = [](double count, double edges) { return edges > 0 ? count / edges : 0; };
        const auto pairs = static_cast<double>(overlapping_pairs(outlines, 1e-3).size());
        lines.at_most("overlaps a pair of neighbours",
                      of_edges(overlaps, static_cast<double>(arranged_edges(arrangement).size())),
                      1.1 * of_edges(pairs, static_cast<double>(exemplar.edges.size())));
    } else {
        lines.at_most("overlaps", overlaps, 0);
    }
    lines.at_most("pairs nearer than in the exemplar", near, 0);
    lines.say("least distance, ratio", measures.least_distance);
}

void exact_lines(GrowthLines& lines, const ArrangementMeasures& measures) {
    lines.at_least("right degrees", measures.right_degrees, 1);
    lines.at_most("degree histogram distance", measures.degree_distance, 0);
    lines.at_most("largest spacing error", measures.largest_spacing_error, 0.001);
    lines.between("largest empty circle, ratio", measures.empty_circle, 0.99, 1.01);
}

void jittered_lines(GrowthLines& lines, const Exemplar& exemplar, const ArrangementMeasures& measures) {
    lines.at_least("right degrees", measures.right_degrees, exemplar.lattice ? 1 : 0.99);
    lines.say("spacing error, rms", measures.spacing_error);
    lines.say("ring error, rms", measures.ring_error);
    lines.at_most("largest empty circle, ratio", measures.empty_circle, 1.15);
}

void irregular_lines(GrowthLines& lines, const ArrangementMeasures& measures) {
    constexpr double least_bar = 0.12;
    lines.at_most("pair correlation distance", measures.pair_distance, std::max(least_bar, measures.pair_spread));
    lines.say("the same of the exemplar's halves", measures.pair_spread);
    lines.say("degree histogram distance", measures.degree_distance);
    lines.say("spacing error, rms", measures.spacing_error);
    lines.say("ring error, rms", measures.ring_error);
    lines.say("defects an element", measures.defects);
    lines.at_most("largest empty circle, ratio", measures.empty_circle, 1.15);
    lines.between("density, ratio", measures.density, 0.9, 1.1);
    lines.at_most("error of shares of 15 % and more", measures.share_error, 0.05);
    lines.at_most("error of smaller shares", measures.small_share_error, 0.10);
    lines.at_most("same element near, times chance", measures.repeats / measures.chance, 2);
    lines.say("neighbours as in the exemplar, share", measures.verbatim);
    lines.say("symbols that cannot grow", static_cast<double>(measures.lost_symbols));
}

void case_lines(GrowthLines& lines, const ExemplarCase& one, std::size_t count, const GrowthPictures& pictures) {
    lines.begin("arrangement: " + one.name + ", " + std::to_string(count) + " elements");
    const Exemplar& exemplar = *one.exemplar;
    const Grown result = grown(exemplar, count, {});
    const ArrangementMeasures measures = measure_arrangement(exemplar, result.arrangement);
    pictures.draw(one.name + " " + std::to_string(count), exemplar, result.arrangement);
    lines.say("elements of the exemplar", static_cast<double>(exemplar.originals));
    lines.between("elements", static_cast<double>(measures.elements), 0.97 * static_cast<double>(count),
                  1.03 * static_cast<double>(count));
    lines.say("seconds", result.seconds);
    overlap_lines(lines, exemplar, result.arrangement, measures);
    if (one.demand == Demand::exact) exact_lines(lines, measures);
    if (one.demand == Demand::jittered) jittered_lines(lines, exemplar, measures);
    if (one.demand == Demand::irregular) irregular_lines(lines, measures);
}

/// A square of 24 l with a wall in its middle that does not reach its sides.
void region_lines(GrowthLines& lines, const ExemplarCase& one, const GrowthPictures& pictures) {
    const Exemplar& exemplar = *one.exemplar;
    lines.begin("arrangement: " + one.name + ", in a square of 24 l about a wall");
    const double side = 24 * exemplar.mean_edge;
    const Region region{{{0, 0}, {side, 0}, {side, side}, {0, side}}};
    const ArrangeSurroundings around{
        nullptr,
        std::make_shared<Boundary>(std::vector<Polyline>{{{0.3 * side, 0.5 * side}, {0.75 * side, 0.62 * side}}}, region)};
    const Grown result = grown(exemplar, GrowOrder{}.count, {}, around, {0.4 * side, 0.25 * side});
    const ArrangementMeasures measures = measure_arrangement(exemplar, result.arrangement, around);
    pictures.draw(one.name + " in a square", exemplar, result.arrangement);
    lines.say("elements", static_cast<double>(measures.elements));
    lines.say("seconds", result.seconds);
    lines.at_most("outlines over a line or the rim", static_cast<double>(measures.over_boundary), 0);
    overlap_lines(lines, exemplar, result.arrangement, measures);
    lines.between("density, ratio", measures.density, 0.85, 1.1);
    lines.at_most("largest empty circle, ratio", measures.empty_circle, one.demand == Demand::irregular ? 1.15 : 1.1);
}

/// Rings that turn: an irregular exemplar stays what it is, a lattice has no reason to turn.
void rotate_lines(GrowthLines& lines, const ExemplarCase& one, const GrowthPictures& pictures) {
    lines.begin("arrangement: " + one.name + ", rings turn to fit, 1,000 elements");
    const Exemplar& exemplar = *one.exemplar;
    const Grown result = grown(exemplar, 1000, {.mode = RotationMode::rotate});
    const ArrangementMeasures measures = measure_arrangement(exemplar, result.arrangement);
    pictures.draw(one.name + " rotate", exemplar, result.arrangement);
    lines.say("seconds", result.seconds);
    overlap_lines(lines, exemplar, result.arrangement, measures);
    if (one.demand == Demand::exact) {
        exact_lines(lines, measures);
    } else {
        irregular_lines(lines, measures);
    }
}

/// A flow that turns about a point outside of what grows: no singular point, but a field that bends.
void flow_lines(GrowthLines& lines, const ExemplarCase& one, const GrowthPictures& pictures) {
    lines.begin("arrangement: " + one.name + ", along a bent flow, 1,000 elements");
    const Exemplar& exemplar = *one.exemplar;
    const double l = exemplar.mean_edge;
    Polyline arc;
    for (int k = 0; k <= 40; ++k) arc.push_back(Point{0, -60 * l} + polar(60 * l, (0.75 - 0.5 * k / 40) * pi));
    const Box box{{-25 * l, -25 * l}, {25 * l, 25 * l}};
    const ArrangeSurroundings around{
        std::make_shared<FlowField>(make_flow_field(std::vector<Polyline>{arc}, box, {.step = 0.5 * l}, one.name)), nullptr};
    const Grown result = grown(exemplar, 1000, {.mode = RotationMode::flow}, around);
    const ArrangementMeasures measures = measure_arrangement(exemplar, result.arrangement, around);
    pictures.draw(one.name + " flow", exemplar, result.arrangement);
    lines.say("seconds", result.seconds);
    lines.at_most("overlaps", static_cast<double>(exemplar.outlines_overlap ? 0 : measures.overlaps), 0);
    lines.say("right degrees", measures.right_degrees);
    lines.say("spacing error, rms", measures.spacing_error);
    lines.say("defects an element", measures.defects);
    lines.between("density, ratio", measures.density, 0.9, 1.1);
    lines.at_most("largest empty circle, ratio", measures.empty_circle, 1.5);
}

/// Least of three runs.
double seconds_for(const Exemplar& exemplar, std::size_t count, const ArrangeOptions& options) {
    double least = any;
    for (int run = 0; run < 3; ++run) least = std::min(least, grown(exemplar, count, options).seconds);
    return least;
}

void speed_lines(GrowthLines& lines, const ExemplarCase& one) {
    const Exemplar& exemplar = *one.exemplar;
    lines.begin("arrangement, speed: " + one.name);
    const bool irregular = exemplar.irregular;
    lines.at_most("1,000 relaxed: seconds", seconds_for(exemplar, 1000, {.finish = false}), 0.03);
    lines.at_most("1,000 turned by their rings: seconds",
                  seconds_for(exemplar, 1000, {.mode = RotationMode::rotate, .finish = false}), 0.12);
    if (irregular) {
        lines.at_most("1,000 with the finish: seconds", seconds_for(exemplar, 1000, {}), 0.1);
        lines.at_most("1,000 turned, with the finish: seconds", seconds_for(exemplar, 1000, {.mode = RotationMode::rotate}),
                      0.2);
    }
    const double few = seconds_for(exemplar, 1000, {}) / 1000;
    lines.say("10,000: seconds", grown(exemplar, 10'000, {}).seconds);
    const double many = grown(exemplar, 100'000, {}).seconds;
    lines.say("100,000: seconds", many);
    lines.at_most("cost of an element at 100,000 over 1,000", many / 100'000 / few, 2);
}

}  // namespace

void arrangement_lines(GrowthLines& lines, const std::vector<ExemplarCase>& cases, const std::string& only,
                       const GrowthPictures& pictures) {
    for (const ExemplarCase& one : cases) {
        if (one.name.find(only) == std::string::npos) continue;
        try {
            if (!one.exemplar) {
                lines.begin("arrangement: " + one.name);
                lines.failed(one.fault);
                continue;
            }
            if (one.demand == Demand::irregular) {
                case_lines(lines, one, 3000, pictures);
            } else {
                case_lines(lines, one, 1000, pictures);
                case_lines(lines, one, 10'000, pictures);
            }
        } catch (const std::exception& error) {
            lines.failed(error.what());
        }
    }
}

void arrangement_region_lines(GrowthLines& lines, const std::vector<ExemplarCase>& cases, const std::string& only,
                              const GrowthPictures& pictures) {
    for (const ExemplarCase& one : cases) {
        if (!one.exemplar || one.name.find(only) == std::string::npos) continue;
        try {
            region_lines(lines, one, pictures);
        } catch (const std::exception& error) {
            lines.failed(error.what());
        }
    }
}

void arrangement_mode_lines(GrowthLines& lines, const std::vector<ExemplarCase>& cases, const std::string& only,
                            const GrowthPictures& pictures) {
    for (const ExemplarCase& one : cases) {
        if (!one.exemplar || one.name.find(only) == std::string::npos) continue;
        try {
            rotate_lines(lines, one, pictures);
            flow_lines(lines, one, pictures);
        } catch (const std::exception& error) {
            lines.failed(error.what());
        }
    }
}

void arrangement_speed_lines(GrowthLines& lines, const std::vector<ExemplarCase>& cases, const std::string& only) {
    for (const ExemplarCase& one : cases)
        if (one.exemplar && one.name.find(only) != std::string::npos) speed_lines(lines, one);
}

}  // namespace rinceau::test

// rinceau pack: shapes -> a dense aggregate without period (Sakurai & Miyata 2014).

#include <algorithm>
#include <chrono>

#include "cli/exit_status.h"
#include "cli/growth_input.h"
#include "cli/messages.h"
#include "cli/pack_options.h"
#include "cli/pack_output.h"
#include "cli/pack_report.h"
#include "cli/pack_shapes.h"
#include "cli/progress_bar.h"
#include "cli/verbs.h"
#include "growth/aggregate/density_picture_png.h"
#include "growth/aggregate/fill_aggregate.h"
#include "growth/flow_field.h"

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

PackDomain read_domain(const PackVerbOptions& options) {
    PackDomain domain{.tiled = options.tile};
    if (options.size) {
        const Point size = *options.size;
        // Meshes stand about the origin; a drawing's upper left corner is the origin.
        domain.box = from_meshes(options) ? Box{-0.5 * size, 0.5 * size} : Box{{0, -size.y}, {size.x, 0}};
        return domain;
    }
    const Scene scene = read_guide(options.region);
    domain.region = region_of(scene, guide_deviation(scene), input_label(options.region));
    domain.box = scene.sized && !is_empty(scene.viewport) ? scene.viewport : bounds(*domain.region);
    return domain;
}

std::vector<double> shares_of(const PackShapes& shapes, const PackVerbOptions& options) {
    if (options.shares.empty()) return {};
    std::vector<double> shares(shapes.shapes.size(), 1);
    std::string known;
    for (const Figure& figure : shapes.drawing.figures) known += (known.empty() ? "" : ", ") + figure.symbol;
    for (const auto& [symbol, share] : options.shares) {
        const auto found = std::ranges::find(shapes.drawing.figures, symbol, &Figure::symbol);
        if (found == shapes.drawing.figures.end())
            throw InputError({input_label(options.shapes.front())},
                             "--shares: no shape is called '" + symbol + "', but " + known);
        shares[static_cast<std::size_t>(found - shapes.drawing.figures.begin())] = share;
    }
    return shares;
}

std::shared_ptr<const FlowField> read_flow(const PackVerbOptions& options, const Box& box) {
    if (options.flow.empty()) return nullptr;
    const Scene scene = read_guide(options.flow);
    const std::vector<Polyline> strokes = polylines_of(scene, guide_deviation(scene));
    constexpr double steps = 200;  // along the box's diagonal
    return std::make_shared<const FlowField>(
        make_flow_field(strokes, box, {.step = diagonal(box) / steps}, input_label(options.flow)));
}

AggregateOptions fill_options(const PackShapes& shapes, const PackDomain& domain, const PackVerbOptions& options) {
    AggregateOptions fill = options.fill;
    fill.shares = shares_of(shapes, options);
    fill.angles.flow = read_flow(options, domain.box);
    if (!options.density.empty())
        fill.density = std::make_shared<const DensityPicture>(
            read_density_png(read_input(options.density), domain.box, input_label(options.density)));
    return fill;
}

Aggregate filled(const PackShapes& shapes, const PackDomain& domain, const AggregateOptions& fill,
                 const PackVerbOptions& options, const Progress& progress) {
    std::vector<ExclusiveRegion> regions;
    for (const PackShape& shape : shapes.shapes) regions.push_back(shape.region);
    const std::string label = input_label(options.region.empty() ? options.shapes.front() : options.region);
    const auto start = Clock::now();
    const auto stop = [&] { return options.seconds > 0 && seconds_since(start) >= options.seconds; };
    Aggregate aggregate = fill_aggregate(regions, domain, fill, label, stop, progress);
    if (aggregate.placed.empty())
        throw InputError({label}, aggregate.complete ? "not one shape found a place; make the area larger or --scale smaller"
                                                     : "not one shape was placed in the time of --seconds");
    return aggregate;
}

int run_pack(const PackVerbOptions& options) {
    expect_pack_options(options);
    const auto start = Clock::now();
    const PackDomain domain = read_domain(options);
    const PackShapes shapes = read_pack_shapes(options);
    PackSeconds seconds{.shapes = seconds_since(start)};

    ProgressBar bar;
    const AggregateOptions fill = fill_options(shapes, domain, options);
    const auto fill_start = Clock::now();
    const Aggregate aggregate = filled(shapes, domain, fill, options, bar.callback());
    seconds.fill = seconds_since(fill_start);
    seconds.total = seconds_since(start);

    write_pack(shapes, aggregate.placed, domain, options, bar.callback());
    if (!options.report.empty()) write_output(options.report, pack_report(shapes, aggregate, domain, options, seconds));
    say(std::to_string(aggregate.placed.size()) + " shapes placed");
    if (aggregate.complete || aggregate.placed.size() >= options.fill.max_count) return exit_status::done;
    say("stopped by --seconds; what stood by then is written");
    return exit_status::limit_reached;
}

}  // namespace

void add_pack(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<PackVerbOptions>(program, job, "pack", "Fill an area with shapes, densely and without a period",
                                  "rinceau pack samples/growth/toy_plane.svg samples/growth/toy_dinosaur.svg --size 600,400 "
                                  "-o aggregate.svg --report aggregate.json",
                                  run_pack);
    add_pack_options(*verb, *options);
}

}  // namespace rinceau

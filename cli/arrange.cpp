// rinceau arrange: more of the same arrangement.

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cli/arrange_ground.h"
#include "cli/arrange_report.h"
#include "cli/arrange_settings.h"
#include "cli/edges_picture.h"
#include "cli/exit_status.h"
#include "cli/growth_input.h"
#include "cli/growth_output.h"
#include "cli/messages.h"
#include "cli/progress_bar.h"
#include "cli/verbs.h"
#include "files/files.h"
#include "growth/arrangement/connectivity_picture.h"
#include "growth/arrangement/grow_ground.h"
#include "growth/arrangement/paint_order.h"
#include "growth/arrangement/place_figures.h"
#include "growth/arrangement/spray.h"
#include "growth/arrangement/tile_of_drawing.h"
#include "scene/svg_write.h"

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// By symbol. Throws CLI::ValidationError for a symbol that the exemplar does not have.
std::vector<int> priorities_of(const ArrangeSettings& settings, const Exemplar& exemplar) {
    if (settings.priorities.empty()) return {};
    std::vector<int> priorities(exemplar.symbols.size(), 0);
    for (const auto& [name, value] : settings.priorities) {
        const auto found = std::ranges::find(exemplar.symbols, name, &ExemplarSymbol::name);
        if (found == exemplar.symbols.end()) {
            std::string known;
            for (const ExemplarSymbol& symbol : exemplar.symbols) known += (known.empty() ? "" : ", ") + symbol.name;
            throw CLI::ValidationError("--priority",
                                       "expected a symbol of the exemplar (" + known + "), found '" + name + "'");
        }
        if (value != std::round(value))
            throw CLI::ValidationError("--priority", "expected a whole number after '" + name + "='");
        priorities[static_cast<std::size_t>(found - exemplar.symbols.begin())] = static_cast<int>(value);
    }
    return priorities;
}

struct Grown {
    ElementArrangement arrangement;
    bool complete = true;
    double seconds = 0;
};

Grown grow_all(const ArrangeSettings& settings, const Exemplar& exemplar, const ArrangeGround& ground) {
    const auto start = Clock::now();
    ArrangeOptions options = settings.growth;
    options.priorities = priorities_of(settings, exemplar);
    bool late = false;
    GrowOrder order;
    if (settings.count) order.count = *settings.count;
    order.brush = ground.limit;
    if (settings.seconds > 0)
        order.stop = [&late, start, limit = settings.seconds] { return late = late || seconds_since(start) > limit; };
    ProgressBar bar;
    Grown grown{empty_arrangement(exemplar, options)};
    grown.arrangement =
        ground.stops.empty()
            ? grown_over(std::move(grown.arrangement), exemplar, ground.around, ground.ground, order, bar.callback())
            : sprayed(std::move(grown.arrangement), exemplar, ground.around, ground.stops, order, bar.callback());
    grown.arrangement = finished(std::move(grown.arrangement), exemplar, ground.around, order, bar.callback());
    grown.complete = !late;
    grown.seconds = seconds_since(start);
    return grown;
}

void expect_any(const Grown& grown, const ArrangeGround& ground, const std::string& exemplar_label) {
    if (grown.arrangement.elements > 0 || !grown.complete) return;
    const std::string cure = "; make it larger, or the elements smaller";
    if (!ground.confined_by.empty())
        throw InputError({ground.confined_by}, "no element of " + exemplar_label + " fits into what it leaves free" + cure);
    throw InputError({exemplar_label}, "no element could be placed");
}

Box box_of(const std::vector<Region>& outlines) {
    Box box;
    for (const Region& outline : outlines) box = including(box, bounds(outline));
    return box;
}

/// What comes into the canvas, in paint order.
std::vector<PlacedFigure> visible(const std::vector<PlacedFigure>& placed, const std::vector<Region>& outlines,
                                  const std::vector<std::size_t>& order, const Box& canvas) {
    std::vector<PlacedFigure> kept;
    for (const std::size_t i : order) {
        if (overlap(bounds(outlines[i]), canvas)) kept.push_back(placed[i]);
    }
    return kept;
}

std::vector<Region> outlines_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed) {
    std::vector<Region> outlines;
    for (const PlacedFigure& one : placed) outlines.push_back(placed_outline(drawing, one));
    return outlines;
}

void say_summary(const Grown& grown, const ArrangeSettings& settings) {
    const std::size_t elements = grown.arrangement.elements;
    if (!grown.complete)
        say("rinceau: --seconds reached after " + std::to_string(elements) + " elements, which are written");
    else if (settings.count && elements < *settings.count)
        say("warning: no room for more than " + std::to_string(elements) + " elements");
}

/// The tile that the command line asks for, or that the drawing evidently is.
std::optional<Box> tile_of(const ArrangeSettings& settings, const GrowthInput& input) {
    if (settings.tile) return *settings.tile ? std::optional(input.drawing.grammar.canvas) : std::nullopt;
    const std::optional<Box> tile = sensible_tile(input.drawing);
    if (tile) say(input.label + " looks like a tile that repeats, and is taken for one; --no-tile takes it as it is");
    return tile;
}

int run_arrange(const ArrangeSettings& settings) {
    expect_consistent(settings);
    const auto start = Clock::now();
    GrowthInput input = read_growth_input(settings.input, {.raised = settings.raised}, settings.growth.threads);
    const Box exemplar_canvas = input.drawing.grammar.canvas;
    ExemplarOptions exemplar_options{.flips = settings.flips};
    exemplar_options.tile = tile_of(settings, input);
    if (exemplar_options.tile) input.drawing = as_tile(input.drawing, *exemplar_options.tile);
    const Exemplar exemplar = make_exemplar(input.drawing, exemplar_options, input.label);
    for (const std::string& warning : exemplar.warnings) {
        say("warning: " + input.label + ": " + warning);
        input.warnings.push_back(warning);
    }
    if (!settings.numbering.empty()) write_output(settings.numbering, write_svg(connectivity_picture(exemplar)));
    const ArrangeGround ground = read_arrange_ground(settings, exemplar, exemplar_canvas);
    ArrangeSeconds seconds{.input = seconds_since(start)};

    const Grown grown = grow_all(settings, exemplar, ground);
    expect_any(grown, ground, input.label);
    seconds.growth = grown.seconds;

    const FiguredDrawing& drawing = input.drawing;
    JitterOptions jitter = settings.jitter;
    jitter.seed = settings.growth.seed;
    const std::vector<ArrangedElement> elements = arranged_elements(grown.arrangement);
    const std::vector<PlacedFigure> placed =
        jittered(drawing, placed_figures(drawing, elements), jitter, ground.around.boundary.get());
    const std::vector<Region> outlines = outlines_of(drawing, placed);
    constexpr double margin = 0.25;  // of a mean edge: half of the usual distance to a neighbour's outline
    const Box canvas = ground.canvas.value_or(rinceau::grown(box_of(outlines), margin * exemplar.mean_edge));
    const std::vector<PlacedFigure> drawn = visible(placed, outlines, paint_order(exemplar, elements), canvas);

    write_growth(drawing, drawn, canvas, settings.output);
    if (!settings.connectivity.empty())
        write_output(settings.connectivity, edges_svg(drawing, placed, arranged_edges(grown.arrangement), canvas));
    seconds.total = seconds_since(start);
    if (!settings.report.empty())
        write_output(settings.report,
                     arrange_report_json({.input = settings.input,
                                          .measures = measure_arrangement(exemplar, grown.arrangement, ground.around),
                                          .exemplar = &exemplar,
                                          .drawn = drawn.size(),
                                          .warnings = input.warnings,
                                          .seconds = seconds,
                                          .complete = grown.complete}));
    say_summary(grown, settings);
    return grown.complete ? exit_status::done : exit_status::limit_reached;
}

}  // namespace

void add_arrange(CLI::App& program, Job& job) {
    const auto [verb, settings] =
        add_verb<ArrangeSettings>(program, job, "arrange", "Grow more of the same arrangement from an example",
                                  "rinceau arrange samples/bricks.svg -o wall.svg --count 300", run_arrange);
    add_arrange_options(*verb, *settings);
}

}  // namespace rinceau

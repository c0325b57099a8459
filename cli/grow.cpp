// rinceau grow: a shape grammar or the rules of a drawing, grown on a surface or in the plane (Li et al. 2010).

#include <chrono>

#include "cli/exit_status.h"
#include "cli/grow_ground.h"
#include "cli/grow_options.h"
#include "cli/grow_output.h"
#include "cli/grow_report.h"
#include "cli/messages.h"
#include "cli/progress_bar.h"
#include "cli/verbs.h"
#include "files/files.h"
#include "growth/surface/field_elements.h"
#include "growth/surface/shape_expressions.h"

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// What has grown, and what it has grown on.
struct Grown {
    SurfaceWorld world;
    SurfacePattern pattern;
    std::optional<GrownDrawing> drawing;
    const FieldOnSurface* field = nullptr;  ///< that guides
    double ground_seconds = 0, growth_seconds = 0;
};

/// The field that `follow` names; the first one without it.
const FieldOnSurface* guiding_field(const SurfaceWorld& world, const std::string& follow) {
    for (const WorldField& field : world.fields)
        if (follow.empty() || field.name == follow) return field.field.get();
    return nullptr;
}

Grown grow_shapes(const ShapeGrammar& grammar, std::shared_ptr<const SurfaceMesh> surface, const GrowVerbOptions& options,
                  const Progress& progress) {
    const auto start = Clock::now();
    Grown grown;
    grown.world = make_world(grammar, std::move(surface), grammar_files(options), options.seed, progress);
    grown.ground_seconds = seconds_since(start);
    ShapeDerivationOptions derivation = options_of(grammar);
    derivation.seed = options.seed;
    derivation.max_shapes = options.max_shapes.value_or(derivation.max_shapes);
    if (options.seconds > 0) derivation.max_seconds = options.seconds;
    grown.field = guiding_field(grown.world, derivation.follow);
    const auto growth_start = Clock::now();
    grown.pattern = derive_shapes(grammar, grown.world, derivation, progress);
    grown.growth_seconds = seconds_since(growth_start);
    return grown;
}

SurfacePoint start_of_drawing(const SurfaceMesh& surface, const GrowVerbOptions& options) {
    const int vertex = options.at ? nearest_vertex(surface, *options.at) : *options.vertex;
    if (vertex >= surface.vertices())
        throw InputError({input_label(options.surface)}, "--vertex: expected a vertex from 0 to " +
                                                             std::to_string(surface.vertices() - 1) + ", found " +
                                                             std::to_string(vertex));
    return at_vertex(surface, vertex);
}

/// Ends work that takes longer than --seconds.
Progress within(double seconds, const std::string& label, Progress progress) {
    if (seconds <= 0) return progress;
    return [=, start = Clock::now()](std::string_view stage, double share) {
        if (seconds_since(start) > seconds)
            throw LimitError({label}, "stopped by --seconds; nothing is written: allow more, or draw less with --depth");
        report(progress, stage, share);
    };
}

Grown grow_rules(const Grammar& grammar, std::shared_ptr<const SurfaceMesh> surface, const GrowVerbOptions& options,
                 const Progress& progress) {
    const auto start = Clock::now();
    ShapeGrammar ground;  // no rules: the plane's piece and the field
    if (options.size) {
        ground.options["plane"].numbers = {{"value", number_expression(options.size->x)},
                                           {"height", number_expression(options.size->y)}};
    }
    if (!options.field.empty()) ground.fields.push_back(field_of_option(options.field));
    Grown grown;
    grown.world = make_world(ground, std::move(surface), grammar_files(options), options.seed, progress);
    grown.field = guiding_field(grown.world, {});
    grown.ground_seconds = seconds_since(start);
    GrowDrawingOptions drawing = options.drawing;
    drawing.seed = options.seed;
    drawing.max_shapes = options.max_shapes.value_or(drawing.max_shapes);
    if (options.at || options.vertex) drawing.start = start_of_drawing(*grown.world.surface, options);
    const auto growth_start = Clock::now();
    grown.drawing = grow_drawing(grammar, *grown.world.surface, grown.field, drawing,
                                 within(options.seconds, input_label(options.input), progress));
    grown.pattern = std::move(grown.drawing->pattern);
    grown.growth_seconds = seconds_since(growth_start);
    return grown;
}

std::string counted(long number, const std::string& one, const std::string& many) {
    return std::to_string(number) + ' ' + (number == 1 ? one : many);
}

void say_summary(const Grown& grown) {
    const SurfacePattern& pattern = grown.pattern;
    if (grown.drawing) {
        const GrownDrawing& drawing = *grown.drawing;
        std::string line = counted(drawing.laid, "element", "elements") + " laid";
        if (drawing.dropped > 0)
            line += ", " + std::to_string(drawing.dropped) + " dropped where the surface bends too much";
        if (drawing.stopped > 0) line += ", " + std::to_string(drawing.stopped) + " stopped at borders or where they met";
        return say(line);
    }
    long segments = 0;
    for (const PatternLine& line : pattern.lines) segments += line.segments;
    std::string line = counted(static_cast<long>(pattern.placed.size()), "shape", "shapes") + " placed";
    if (segments > 0)
        line += ", " + counted(static_cast<long>(pattern.lines.size()), "line", "lines") + " of " +
                counted(segments, "piece", "pieces");
    say(line);
}

int run_grow(const GrowVerbOptions& options) {
    expect_grow_options(options);
    const auto start = Clock::now();
    GrowInput input = read_grow_input(options);
    for (const Warning& mistake : input.mistakes) say(located(mistake.place, mistake.message));
    if (!input.mistakes.empty()) return exit_status::input_at_fault;
    GrowSeconds seconds{.input = seconds_since(start)};
    const std::shared_ptr<const SurfaceMesh> surface = read_ground(options, input.warnings);
    const double surface_seconds = seconds_since(start) - seconds.input;

    ProgressBar bar;
    const auto* shapes = std::get_if<ShapeGrammar>(&input.grammar);
    const Grown grown = shapes != nullptr ? grow_shapes(*shapes, surface, options, bar.callback())
                                          : grow_rules(std::get<Grammar>(input.grammar), surface, options, bar.callback());
    seconds.ground = surface_seconds + grown.ground_seconds;
    seconds.growth = grown.growth_seconds;
    for (const std::string& warning : grown.pattern.warnings) {
        say("warning: " + warning);
        input.warnings.push_back(warning);
    }
    if (!grown.pattern.complete) say(input.label + ": " + grown.pattern.limit);
    if (!grown.pattern.complete && !options.keep_partial) {
        say("nothing is written: --keep-partial writes what has grown so far, --max-shapes and --seconds set other limits");
        return exit_status::limit_reached;
    }

    const auto output_start = Clock::now();
    const long faces = write_grown(grown.pattern, *grown.world.surface, options);
    seconds.output = seconds_since(output_start);
    seconds.total = seconds_since(start);
    if (!options.report.empty()) {
        write_output(options.report, grow_report_json({.input = options.input,
                                                       .surface = options.surface,
                                                       .pattern = &grown.pattern,
                                                       .ground = grown.world.surface.get(),
                                                       .field = grown.field,
                                                       .drawing = grown.drawing ? &*grown.drawing : nullptr,
                                                       .seed = options.seed,
                                                       .faces = faces,
                                                       .warnings = input.warnings,
                                                       .seconds = seconds}));
    }
    say_summary(grown);
    return grown.pattern.complete ? exit_status::done : exit_status::limit_reached;
}

}  // namespace

void add_grow(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<GrowVerbOptions>(
        program, job, "grow", "Grow a shape grammar or a drawing's rules on a surface or in the plane",
        "rinceau grow samples/surface/vine.fgsg --on samples/surface/torus.obj -o vine.glb --report vine.json", run_grow);
    add_grow_options(*verb, *options);
}

}  // namespace rinceau

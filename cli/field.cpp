// rinceau field: designs, smooths, converts and pictures fields on surfaces (Li et al. 2010, section 4.2).

#include <chrono>

#include "cli/exit_status.h"
#include "cli/field_options.h"
#include "cli/field_output.h"
#include "cli/messages.h"
#include "cli/progress_bar.h"
#include "cli/verbs.h"
#include "files/files.h"
#include "geometry/angle.h"
#include "growth/surface/field_elements.h"
#include "growth/surface/field_smooth.h"
#include "growth/surface/surface_world.h"

namespace rinceau {
namespace {

SurfaceMesh read_surface_of(const FieldVerbOptions& options, std::vector<std::string>& warnings) {
    if (options.size) return surface_mesh(plane_mesh({.width = options.size->x, .height = options.size->y}));
    return read_surface_file(options.surface, options.repair, warnings);
}

/// Before any smoothing that the command line asks for.
SurfaceField source_field(const SurfaceMesh& surface, const FieldVerbOptions& options, const Progress& progress) {
    if (!options.elements.empty()) {
        std::vector<FieldElement> elements;
        for (const ElementWord& word : options.elements) {
            FieldElement element{.kind = word.kind, .vertex = word.vertex, .weight = word.weight, .decay = word.decay};
            if (word.vertex < surface.vertices())  // others are refused with all else that is wrong
                element.direction = reference_direction(surface, word.vertex) + radians(word.angle);
            elements.push_back(element);
        }
        return field_of_elements(surface, options.n, elements, "--element", progress);
    }
    FieldSource source = options.sources.front();
    if (options.n_given) source.numbers["n"] = options.n;
    return make_field(source, surface, read_input, progress);
}

SurfaceField smoothed_field(const SurfaceMesh& surface, SurfaceField field, const FieldVerbOptions& options,
                            const Progress& progress) {
    field = smoothed(surface, std::move(field), options.smooth, progress);
    field = smoothed_by_rounds(surface, std::move(field), options.rounds, {}, progress);
    for (const SmoothingRegion& region : options.regions) {
        if (region.vertex >= surface.vertices())
            throw InputError({"--smooth-at"}, "the surface has no vertex " + std::to_string(region.vertex) +
                                                  "; expected 0 to " + std::to_string(surface.vertices() - 1));
        const std::vector<int> only = vertices_around(surface, region.vertex, region.radius * surface.diagonal);
        field = smoothed_by_rounds(surface, std::move(field), region.rounds, only, progress);
    }
    return field;
}

void say_singularities(const FieldOnSurface& field, int before) {
    const int euler = euler_characteristic(field.surface());
    std::string sum = std::to_string(field.index_sum());
    if (field.n() > 1) sum += "/" + std::to_string(field.n());
    const std::string whole = field.surface().border_edges > 0 ? ", of a surface with a border" : "";
    say(std::to_string(before) + " singular points, " + std::to_string(field.singular_faces().size()) +
        " after smoothing; their indices sum to " + sum + ", Euler characteristic " + std::to_string(euler) + whole);
}

int run_field(const FieldVerbOptions& options) {
    expect_field_options(options);
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    FieldSummary summary;
    const SurfaceMesh surface = read_surface_of(options, summary.warnings);
    ProgressBar bar;
    const Progress progress = bar.callback();
    SurfaceField source = source_field(surface, options, progress);
    summary.singular_before = static_cast<int>(FieldOnSurface(surface, source).singular_faces().size());
    const FieldOnSurface field(surface, smoothed_field(surface, std::move(source), options, progress));
    summary.total_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    write_field(field, options, progress);
    if (!options.report.empty()) write_output(options.report, field_report(field, summary, options));
    say_singularities(field, summary.singular_before);
    return exit_status::done;
}

}  // namespace

void add_field(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<FieldVerbOptions>(
        program, job, "field", "Design, smooth, convert and picture a vector, tensor or cross field on a surface",
        "rinceau field samples/surface/vase.obj --curvature --smooth 0.03 -o field.json -o field.png", run_field);
    add_field_options(*verb, *options);
}

}  // namespace rinceau

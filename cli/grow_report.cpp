#include "cli/grow_report.h"

#include <nlohmann/json.hpp>

#include "geometry/angle.h"
#include "growth/surface/measure_pattern.h"

namespace rinceau {
namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;

Json singularities(const GrowReport& report) {
    Json json;
    json["field"] = report.field != nullptr;
    if (report.field != nullptr) {
        json["points"] = report.field->singular_faces().size();
        json["sum"] = static_cast<double>(report.field->index_sum()) / report.field->n();
    }
    json["euler"] = euler_characteristic(*report.ground);
    return json;
}

Json laid(const GrownDrawing& drawing) {
    return {{"elements", drawing.elements}, {"laid", drawing.laid},     {"shrunk", drawing.shrunk},
            {"split", drawing.split},       {"spines", drawing.spines}, {"dropped", drawing.dropped},
            {"stopped", drawing.stopped},   {"folded", drawing.folded}};
}

}  // namespace

std::string grow_report_json(const GrowReport& report) {
    const SurfacePattern& pattern = *report.pattern;
    const PatternCounts& counts = pattern.counts;
    const PatternMeasures measures = measure_pattern(pattern, *report.ground);
    Json json{{"schema", schema_version}, {"input", report.input}};
    json["surface"] = {{"name", report.surface},
                       {"faces", report.ground->faces()},
                       {"diagonal", report.ground->diagonal},
                       {"border_edges", report.ground->border_edges}};
    json["seed"] = report.seed;
    json["complete"] = pattern.complete;
    json["shapes"] = pattern.placed.size();
    json["lines"] = pattern.lines.size();
    json["faces"] = report.faces;
    json["translations"] = counts.translations;
    json["rules"] = counts.rules_applied;
    json["collisions_avoided"] = counts.collisions_avoided;
    json["merged"] = {{"points", counts.merged_points}, {"lines", counts.merged_lines}};
    json["locks_given_up"] = counts.locks_given_up;
    json["borders_met"] = counts.borders_met;
    const double samples = counts.angle_samples > 0 ? static_cast<double>(counts.angle_samples) : 1;
    json["angle_error"] = {{"mean", degrees(counts.angle_error_sum / samples)},
                           {"max", degrees(counts.angle_error_max)},
                           {"jumps", counts.jumps}};
    json["surface_distance_max"] = measures.surface_distance_max;
    json["overlaps"] = measures.overlaps;
    json["singularities"] = singularities(report);
    if (report.drawing != nullptr) json["drawing"] = laid(*report.drawing);
    json["warnings"] = report.warnings;
    json["seconds"] = {{"input", report.seconds.input},
                       {"ground", report.seconds.ground},
                       {"growth", report.seconds.growth},
                       {"output", report.seconds.output},
                       {"total", report.seconds.total}};
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rinceau

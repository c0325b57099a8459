#include "cli/arrange_report.h"

#include <nlohmann/json.hpp>

namespace rinceau {
namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;

Json symbols_json(const Exemplar& exemplar, const ArrangementMeasures& measures) {
    Json list = Json::array();
    for (std::size_t i = 0; i < exemplar.symbols.size(); ++i)
        list.push_back({{"symbol", exemplar.symbols[i].name},
                        {"share", i < measures.shares.size() ? measures.shares[i] : 0},
                        {"exemplar_share", exemplar.symbols[i].share}});
    return list;
}

Json exemplar_json(const Exemplar& exemplar) {
    std::size_t usable = 0;
    for (const ExemplarElement& element : exemplar.elements) usable += element.usable ? 1 : 0;
    return {{"elements", exemplar.originals},          {"usable", usable},
            {"mean_edge", exemplar.mean_edge},         {"regular", !exemplar.irregular},
            {"lattice", exemplar.lattice.has_value()}, {"outlines_overlap", exemplar.outlines_overlap}};
}

}  // namespace

std::string arrange_report_json(const ArrangeReport& report) {
    const ArrangementMeasures& measures = report.measures;
    Json json;
    json["schema"] = schema_version;
    json["input"] = report.input;
    json["exemplar"] = exemplar_json(*report.exemplar);
    json["elements"] = measures.elements;
    json["drawn"] = report.drawn;
    json["complete"] = report.complete;
    json["overlaps"] = measures.overlaps;
    json["over_boundary"] = measures.over_boundary;
    json["pcf_distance"] = measures.pair_distance;
    json["pcf_spread"] = measures.pair_spread;
    json["degree_distance"] = measures.degree_distance;
    json["spacing_error"] = measures.spacing_error;
    json["ring_error"] = measures.ring_error;
    json["density"] = measures.density;
    json["empty_circle"] = measures.empty_circle;
    json["repeats"] = measures.repeats;
    json["repeats_by_chance"] = measures.chance;
    json["symbols"] = symbols_json(*report.exemplar, measures);
    json["warnings"] = report.warnings;
    json["seconds"] = {{"input", report.seconds.input}, {"growth", report.seconds.growth}, {"total", report.seconds.total}};
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rinceau

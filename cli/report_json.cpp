#include "cli/report_json.h"

#include <nlohmann/json.hpp>

namespace rinceau {
namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;

Json terminals_json(const std::vector<TerminalReport>& terminals) {
    Json list = Json::array();
    for (const TerminalReport& terminal : terminals)
        list.push_back({{"symbol", terminal.symbol},
                        {"instances", terminal.instances},
                        {"symmetry", terminal.symmetry},
                        {"mirrored", terminal.mirrored}});
    return list;
}

Json productions_json(const std::vector<ProductionReport>& productions) {
    Json list = Json::array();
    for (const ProductionReport& production : productions)
        list.push_back({{"symbol", production.symbol},
                        {"kind", production.kind},
                        {"lengths", production.lengths},
                        {"instances", production.instances},
                        {"body", production.body}});
    return list;
}

Json warnings_json(const std::vector<Warning>& reading, const std::vector<std::string>& analysis) {
    Json list = Json::array();
    for (const Warning& warning : reading) list.push_back(located(warning.place, warning.message));
    for (const std::string& warning : analysis) list.push_back(warning);
    return list;
}

Json seconds_json(const AnalysisSeconds& seconds, const ReportContext& context) {
    return {{"import", context.import_seconds}, {"similarity", seconds.similarity}, {"clusters", seconds.clusters},
            {"rules", seconds.rules},           {"verify", seconds.verify},         {"total", context.total_seconds}};
}

}  // namespace

std::string report_json(const AnalysisReport& report, const ReportContext& context) {
    Json json;
    json["schema"] = schema_version;
    json["input"] = context.input;
    json["elements"] = report.elements;
    json["verbatim"] = report.verbatim;
    json["terminals"] = terminals_json(report.terminals);
    json["productions"] = productions_json(report.productions);
    json["axiom"] = report.axiom;
    json["error"] = {{"max", report.check.max_deviation}, {"rms", report.check.rms_deviation}};
    json["size"] = {{"drawing_bits", report.drawing_bits}, {"grammar_bits", report.grammar_bits}};
    json["tolerance"] = report.tolerance;
    json["objective"] = report.objective == Objective::bits ? "bits" : "paper";
    json["warnings"] = warnings_json(context.warnings, report.warnings);
    json["seconds"] = seconds_json(report.seconds, context);
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rinceau

#include "cli/pack_report.h"

#include <nlohmann/json.hpp>

#include "growth/measure/measure_aggregate.h"

namespace rinceau {
namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;

const char* name_of(PackMethod method) {
    switch (method) {
        case PackMethod::naive:
            return "naive";
        case PackMethod::gaps:
            return "gaps";
        case PackMethod::settle:
            return "settle";
    }
    return "";
}

}  // namespace

std::string pack_report(const PackShapes& shapes, const Aggregate& aggregate, const PackDomain& domain,
                        const PackVerbOptions& options, const PackSeconds& seconds) {
    std::vector<ExclusiveRegion> regions;
    for (const PackShape& shape : shapes.shapes) regions.push_back(shape.region);
    const AggregateMeasures measures = measure_aggregate(regions, aggregate.placed, domain);

    Json json{{"schema", schema_version}, {"input", options.shapes}};
    json["method"] = name_of(options.fill.method);
    json["quality"] = options.fill.quality == PackQuality::best ? "best" : "fast";
    json["seed"] = options.fill.seed;
    json["complete"] = aggregate.complete;
    json["placed"] = measures.placed;
    json["attempted"] = aggregate.counts.attempted;
    json["tested"] = aggregate.counts.tested;
    json["cancelled"] = aggregate.counts.cancelled;
    json["overlaps"] = measures.overlaps;
    json["coverage"] = measures.coverage;
    json["largest_gap"] = measures.largest_gap;
    json["largest_gap_ratio"] = measures.largest_gap_ratio;
    json["autocorrelation"] = measures.autocorrelation;
    json["shapes"] = Json::array();
    for (std::size_t i = 0; i < regions.size(); ++i)
        json["shapes"].push_back(
            {{"symbol", shapes.drawing.figures[i].symbol},
             {"placed", measures.counts[i]},
             {"share",
              measures.placed == 0 ? 0.0 : static_cast<double>(measures.counts[i]) / static_cast<double>(measures.placed)}});
    json["warnings"] = shapes.warnings;
    json["seconds"] = {{"shapes", seconds.shapes}, {"fill", seconds.fill}, {"total", seconds.total}};
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rinceau

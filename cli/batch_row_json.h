#pragma once
// What a row of a batch says of its drawing, as JSON: the same in the log and in the report.

#include <string>

#include <nlohmann/json.hpp>

#include "cli/batch_row.h"

namespace rinceau {

/// Puts "status", "message", the counts, the measures and the warnings behind what `json` has.
void add_findings(nlohmann::ordered_json& json, const BatchRow& row);

/// One line without its end; what is no UTF-8 is replaced.
std::string line_of(const nlohmann::ordered_json& json);

}  // namespace rinceau

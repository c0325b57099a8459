#pragma once
// What was found, for programs to read (docs/report.schema.json).

#include <string>
#include <vector>

#include "analyzer/analyze.h"
#include "scene/input_error.h"

namespace rinceau {

/// What only the program knows of an analysis.
struct ReportContext {
    std::string input;              ///< name as given
    std::vector<Warning> warnings;  ///< of reading
    double import_seconds = 0;
    double total_seconds = 0;
};

/// The report as JSON text, two blanks a level, a line end at its end. Bytes of names that are not UTF-8 are replaced.
std::string report_json(const AnalysisReport& report, const ReportContext& context);

}  // namespace rinceau

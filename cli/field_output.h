#pragma once
// A field as files: values, pictures, lines.

#include <string>
#include <vector>

#include "cli/field_options.h"
#include "geometry/progress.h"
#include "growth/surface/surface_field.h"

namespace rinceau {

/// Every output by its name's ending; without one the values on standard output. Throws OutputError, and
/// CLI::ValidationError for .svg of a surface that is not flat.
void write_field(const FieldOnSurface& field, const FieldVerbOptions& options, const Progress& progress);

/// What the report says of a field before and after smoothing.
struct FieldSummary {
    int singular_before = 0;
    std::vector<std::string> warnings;  ///< of reading; they were said
    double total_seconds = 0;           ///< without writing
};

/// docs/field_report.schema.json
std::string field_report(const FieldOnSurface& field, const FieldSummary& summary, const FieldVerbOptions& options);

}  // namespace rinceau

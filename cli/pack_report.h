#pragma once
// What packing reached, for programs to read (docs/pack_report.schema.json).

#include <string>
#include <vector>

#include "cli/pack_options.h"
#include "cli/pack_shapes.h"
#include "growth/aggregate/pack_domain.h"

namespace rinceau {

struct PackSeconds {
    double shapes = 0;  ///< reading and analysing them
    double fill = 0;
    double total = 0;  ///< without measuring and writing
};

/// The report as JSON text. Overlaps, coverage, gap and autocorrelation are measured afresh from what is placed.
std::string pack_report(const PackShapes& shapes, const Aggregate& aggregate, const PackDomain& domain,
                        const PackVerbOptions& options, const PackSeconds& seconds);

}  // namespace rinceau

#pragma once
// How like its exemplar an arrangement has become, for programs to read (docs/arrange_report.schema.json).

#include <string>
#include <vector>

#include "growth/arrangement/exemplar.h"
#include "growth/measure/measure_arrangement.h"

namespace rinceau {

/// Wall time.
struct ArrangeSeconds {
    double input = 0;   ///< reading and analysis
    double growth = 0;  ///< growth, relaxation and finish
    double total = 0;
};

struct ArrangeReport {
    std::string input;  ///< name as given
    ArrangementMeasures measures;
    const Exemplar* exemplar = nullptr;
    std::size_t drawn = 0;  ///< elements that come into the canvas
    std::vector<std::string> warnings;
    ArrangeSeconds seconds;
    bool complete = true;  ///< false: --seconds has ended it
};

/// As JSON text, two blanks a level, a line end at its end. Bytes of names that are not UTF-8 are replaced.
std::string arrange_report_json(const ArrangeReport& report);

}  // namespace rinceau

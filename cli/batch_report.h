#pragma once
// The report of a batch as a table, for programs to read (docs/batch_report.schema.json).

#include <functional>
#include <string>

#include "cli/batch_row.h"

namespace rinceau {

/// A drawing and what is known of it.
struct BatchEntry {
    std::string input;  ///< the drawing's file
    BatchRow row;
};

/// Calls the sink for every drawing of the batch, in the order of the report; may be called again.
using BatchEntries = std::function<void(const std::function<void(const BatchEntry&)>&)>;

/// One record a drawing, with a header (RFC 4180, but for line ends of one character).
void write_batch_csv(const std::string& name, const BatchEntries& entries);

/// One object a drawing, a line each, and their number.
void write_batch_json(const std::string& name, const BatchEntries& entries);

}  // namespace rinceau

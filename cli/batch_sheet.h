#pragma once
// The report of a batch for a person to look through: drawings before and after, on pages.

#include <string>

#include "cli/batch_report.h"

namespace rinceau {

/// How a page says where the outputs lie: the way from the folder of `name` to `folder`, "" or "../" or "../../" ...; throws
/// CLI::ValidationError if `name` is not inside of `folder`, since then the sheet would break when the folder moves.
std::string way_to_outputs(const std::string& name, const std::string& folder);

/// Writes `name`, the first page, and as many more beside it as it takes ("sheet-2.html"). The pages use nothing but each
/// other and the grammars and pictures at `way`.
void write_batch_sheet(const std::string& name, const std::string& way, const BatchEntries& entries);

}  // namespace rinceau

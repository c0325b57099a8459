#pragma once
// The picture or the grammar for another program.

#include <string>
#include <vector>

#include "editor/model/document.h"

namespace rinceau {

/// Writes the document's picture (format svg, png, pdf) or its grammar (lsys, or a name of exports/export_formats.h);
/// returns notes on what the format cannot hold. Throws InputError, LimitError and OutputError; an existing file is whole
/// afterwards.
std::vector<std::string> write_export(const Document& document, const std::string& path, const std::string& format);

}  // namespace rinceau

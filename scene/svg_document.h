#pragma once
// XML text to a tinyxml2 document of any depth. (tinyxml2 itself ends at 98 levels; deeper parts are parsed apart and put
// back into their places.)

#include <tinyxml2.h>

#include <memory>
#include <string>

#include "scene/svg_source.h"

namespace rinceau {

/// The document of an XML text as svg_source_text gives it. White space between the children of <text> is kept (tinyxml2
/// would drop it). Elements more than 64 levels deep have no line number (GetLineNum() is 0).
/// Throws InputError for XML that is not well formed, with line and column, LimitError beyond options.max_depth levels.
std::unique_ptr<tinyxml2::XMLDocument> parse_svg_document(const std::string& text, const SvgSourceOptions& options = {});

}  // namespace rinceau

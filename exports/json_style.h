#pragma once
// Styles in JSON: SVG's property names, y down. Internal to the folder.

#include "exports/json_text.h"
#include "scene/style.h"

namespace rinceau {

/// {"fill": "#ffcc00", "stroke": {"gradient": "linear", "matrix": [..], "stops": [..]}, "stroke-width": 2, ..}; fill always,
/// everything else where it differs from a default Style.
Json style_json(const Style& style);

/// Of an object that may have other keys, too. Throws InputError with the place.
Style parse_json_style(const JsonValue& value);

/// The keys that parse_json_style looks at.
bool is_style_key(std::string_view key);

}  // namespace rinceau

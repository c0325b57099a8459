#pragma once
// A drawing made fit to stand inside another document: ids that are free there, styles that its style sheets do not touch.

#include <tinyxml2.h>

#include <functional>
#include <set>
#include <string>

#include "scene/svg_css.h"

namespace rinceau {

/// Renames the ids of the drawing that `is_taken`, with all references to them.
void rename_ids(tinyxml2::XMLDocument& svg, const std::function<bool(const std::string&)>& is_taken);

/// References of <use> as xlink:href, which every program knows. The prefix must be declared around.
void use_xlink(tinyxml2::XMLDocument& svg);

/// The properties that rules of a sheet set.
std::set<std::string> properties_of(const StyleSheet& sheet);

/// Writes the drawing's styles so that rules which set `properties` change nothing: in style attributes, with each of those
/// properties given on each element.
void shield_styles(tinyxml2::XMLDocument& svg, const std::set<std::string>& properties);

/// Declarations that give these properties the values that they have where nothing sets them.
std::string initial_declarations(const std::set<std::string>& properties);

/// All children of the root as text.
std::string content_text(const tinyxml2::XMLDocument& svg);

}  // namespace rinceau

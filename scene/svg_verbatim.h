#pragma once
// Parts of a drawing kept as they are: self-contained pieces of SVG.

#include <string>
#include <string_view>

#include "scene/svg_reader.h"

namespace rinceau {

/// Adds the element of `context` with all below it as one verbatim element: a group that holds its place and inherited
/// style, after the definitions that it needs. Ids are renamed so that no two pieces collide; style sheets become style
/// attributes. `box` is where it may draw, in scene space (empty = unknown); `warning` names the kind.
void keep_verbatim(SvgReader& reader, const SvgContext& context, const Box& box, std::string_view warning);

/// The element, outline or verbatim, inside a group with these attributes, after these definitions: a verbatim element that
/// may draw in `box`.
Element wrapped(SvgReader& reader, const Element& element, const std::string& attributes, const std::string& definitions,
                const Box& box, const SvgNode& owner);

/// A prefix for ids that no other kept part has.
std::string next_id_prefix(SvgReader& reader);

}  // namespace rinceau

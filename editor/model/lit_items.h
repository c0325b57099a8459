#pragma once
// Which elements of a picture stand out.

#include <memory>
#include <vector>

#include "editor/model/derived_picture.h"

namespace rinceau {

/// A flag by PictureItem::order. Null = there is nothing that stands out from the rest.
using LitItems = std::shared_ptr<const std::vector<char>>;

/// Where a production is meant: that none is.
constexpr int no_production = -2;

/// How the drawing as it was opened is shown beside what it is now.
enum class OnionMode : unsigned char { off, before_and_after, difference };

/// The elements [first, last) of so many.
LitItems lit_range(std::size_t elements, int first, int last);

/// The elements of a terminal.
LitItems lit_by_terminal(const DerivedPicture& picture, int terminal);

/// The elements that a production (-1 = the axiom) of the document has placed, itself or by what it led to. Throws as
/// interpret().
LitItems lit_by_rule(const Document& document, int production, const Progress& progress = {});

}  // namespace rinceau

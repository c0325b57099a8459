#pragma once
// Exchanging parts of a document's text: removed elements that something else still refers to, and the edits themselves.

#include <cstddef>
#include <string>
#include <unordered_set>
#include <vector>

#include "scene/svg_markup.h"
#include "scene/svg_tree.h"

namespace rinceau {

/// Put `text` in the place of [begin, end).
struct TextEdit {
    std::size_t begin = 0, end = 0;
    std::string text;
};

/// Edits must not overlap; of those at one offset the earlier in the list comes first.
std::string with_edits(const std::string& text, std::vector<TextEdit> edits);

/// The outermost elements inside `removed` ones that the rest of the document, or one of themselves, refers to, and style
/// sheets; in document order.
std::vector<const SvgNode*> referred_to(const SvgTree& tree, const std::unordered_set<const SvgNode*>& removed);

/// Puts elements into the definitions of the root.
TextEdit addition_to_definitions(const std::string& text, const SvgTree& tree, const SvgMarkupIndex& markup,
                                 const std::string& elements);

/// The range of an element with the white space before it, if it stands on a line of its own.
TextEdit removal(const std::string& text, const SvgMarkup& element);

}  // namespace rinceau

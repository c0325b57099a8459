#pragma once
// Where the elements of a document stand in its text, so that a part of it can be exchanged and the rest stays byte for byte.

#include <cstddef>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/svg_tree.h"

namespace rinceau {

/// Offsets in the text. An empty-element tag <a/> has tag_end == content_end == end.
struct SvgMarkup {
    std::size_t begin = 0;        ///< of the start tag
    std::size_t tag_end = 0;      ///< behind the start tag
    std::size_t content_end = 0;  ///< of the end tag
    std::size_t end = 0;          ///< behind the element
};

/// The places of a tree's elements in the text that it was parsed from.
class SvgMarkupIndex {
  public:
    SvgMarkupIndex(std::string_view text, const SvgTree& tree);
    const SvgMarkup& of(const SvgNode& element) const { return places_.at(&element); }

  private:
    std::unordered_map<const SvgNode*, SvgMarkup> places_;
};

}  // namespace rinceau

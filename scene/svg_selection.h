#pragma once
// Which elements of a document a person means by the ids that are selected.

#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "scene/svg_reader.h"

namespace rinceau {

/// A group with this attribute was put into a document by Rinceau; its <desc> holds the rules.
constexpr std::string_view rules_group_attribute = "data-rinceau";

struct SvgSelection {
    std::vector<const SvgNode*> chosen;  ///< in paint order, none inside another
    const SvgNode* parent = nullptr;     ///< of the uppermost chosen one: what is put in their place is drawn in its space
    const SvgNode* rules = nullptr;      ///< the group with rules, if that alone is meant: all that it draws is chosen
};

/// No ids = everything on the page. A group with rules is meant by any id inside it. What is locked, hidden, draws nothing or
/// is not understood is never chosen, nor is a group that holds such a thing (its other children are), a layer, or a group that
/// would be chosen alone.
/// `reader` must be as enter_root() leaves it; nothing of it changes. Nothing is chosen if nothing is left.
SvgSelection select_elements(SvgReader& reader, const SvgContext& root, std::span<const std::string> ids);

}  // namespace rinceau

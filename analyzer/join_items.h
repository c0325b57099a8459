#pragma once
// Makes items the members of a new item, outside the search's own substitution (docs/analysis.md, 4.6).

#include <vector>

#include "analyzer/search_state.h"

namespace rinceau {

/// A new item of rule `rule` whose k-th member is items[k], seen in frames[k] (its pose times one of its symmetries); its part
/// is the rule's part of that many repetitions, made if there is none. For every kind of rule that repeats one part. The
/// members die; the caller refreshes the parts that lost items. Returns the item.
int join_items(SearchState& state, int rule, const std::vector<int>& items, const std::vector<Similarity>& frames);

/// The same for a family: the parts of the items are its children. An equal family, if there is one, gets one more item.
int join_family(SearchState& state, const Rule& family, const std::vector<int>& items, const std::vector<Similarity>& frames);

}  // namespace rinceau

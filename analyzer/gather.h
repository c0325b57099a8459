#pragma once
// What stands where a part is expected: an item of it, one with a few members missing, or one with another count
// (docs/analysis.md, 4.7).

#include <optional>
#include <set>
#include <vector>

#include "analyzer/evaluate.h"

namespace rinceau {

/// A plan for one place; nothing changes until make_item carries it out.
struct Gathered {
    int item = -1;                  ///< stands there as it is; of another part: it stands in for the part. Else
    std::vector<Gathered> members;  ///< the part's children, in their order; a member with neither is missing
    std::vector<int> runs;          ///< items that give up their members to it and are no more
    int exceptions = 0;             ///< that it will need

    bool missing() const { return item < 0 && members.empty(); }
};

/// What stands at `pose`, predicted over `distance` (scene length), as an item of `part`; a part is gathered if half of
/// a sequence or more than half of a group is there; of a sequence, one with another count may stand in for it. Only living items are seen.
/// Where something belongs for other reasons (`witnessed`), just half of a group is enough.
std::optional<Gathered> gather(const SearchState& state, GridCache& grids, int part, const Similarity& pose, double distance,
                               bool witnessed = false);

/// Three or more gaps (0) of one width at even distances are a rhythm: what stands between them are blocks.
bool has_even_gaps(const std::vector<char>& taken);

/// Members of an item of a sequence, from the end whose place is nearer to `first`.
std::vector<int> members_from(const SearchState& state, int item, const Similarity& first);

/// The part that the sequence rule makes with this count; made if there is none.
int part_of_count(SearchState& state, int rule, int count);

/// Carries out a plan: the new item of `part`, near `pose`, or -1 if its members do not fit (then nothing has changed but
/// perhaps members of members). Adds the parts that lost or gained items to `touched`.
int make_item(SearchState& state, int part, const Gathered& plan, const Similarity& pose, std::set<int>& touched);

}  // namespace rinceau

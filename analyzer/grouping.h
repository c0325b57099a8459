#pragma once
// What a person decides about which elements are copies of each other (docs/analysis.md, 2).

#include <cstdint>
#include <span>
#include <vector>

#include "analyzer/instancing.h"

namespace rinceau {

enum class GroupingKind : std::uint8_t {
    together,  ///< all are drawn as the first of them is, each in its own place, angle and size
    apart      ///< they are another look than the rest, though they may be like it
};

struct GroupingWish {
    GroupingKind kind = GroupingKind::together;
    std::vector<int> elements;  ///< by index in the scene; others than there are, and verbatim ones, are passed over
    friend bool operator==(const GroupingWish&, const GroupingWish&) = default;
};

/// Of two wishes of different kinds about one element the later one holds: the element is taken out of the earlier. Wishes
/// that nothing is left of are left out.
std::vector<GroupingWish> effective_wishes(std::span<const GroupingWish> wishes);

/// The drawing that is meant: elements that shall be together are drawn as the first of them. Instances of unlike looks
/// stand upright to each other as they were first drawn. `instancing` is of the scene.
Scene with_merged_elements(Scene scene, Instancing instancing, std::span<const GroupingWish> wishes);

/// Elements that shall be apart have looks, and shapes, of their own.
Instancing with_split_looks(Instancing instancing, std::span<const GroupingWish> wishes);

/// Each of these elements, by index in the scene, is a look of its own and drawn exactly as it is: no copy of another.
Instancing with_lone_elements(Instancing instancing, const Scene& scene, std::span<const int> elements);

}  // namespace rinceau

#pragma once
// What is drawn besides the picture's own colours.

#include <memory>
#include <vector>

#include "editor/model/derived_picture.h"

namespace rinceau {

/// A flag by PictureItem::order; what lies beyond the end is 0. Null = no flags at all.
using ItemFlags = std::shared_ptr<const std::vector<char>>;

inline bool same_flags(const ItemFlags& a, const ItemFlags& b) { return a == b || (a && b && *a == *b); }

/// How another picture is laid over.
enum class PictureComparison : unsigned char {
    none,
    onion,      ///< the other one as a tinted trace, the picture itself half faded
    difference  ///< what looks different in the accent colour over a faded picture
};

struct PictureEmphasis {
    ItemFlags lit;                                 ///< 0 fades to about 15 %: null = nothing fades
    ItemFlags outlined;                            ///< 1 gets a line around, seen also where something covers it
    std::shared_ptr<const DerivedPicture> before;  ///< what the picture is compared with; null = nothing
    PictureComparison comparison = PictureComparison::none;
};

}  // namespace rinceau

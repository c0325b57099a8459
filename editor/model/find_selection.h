#pragma once
// Finding what is selected, with its handles: the part of a click that takes time.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "editor/model/handles.h"

namespace rinceau {

/// What a selection refers to, and what it shall be.
struct SelectionSearch {
    std::uint64_t revision = 0;  ///< of the document and its picture
    Document document;
    std::shared_ptr<const DerivedPicture> picture;
    std::optional<Selection> before;
    int clicked = -1;      ///< order of the element; -1 = none was: the selection follows an edit
    std::size_t level = deepest_level;  ///< wanted of an element that was not selected
    bool handles = true;                ///< are wanted
};

struct SelectionFound {
    std::uint64_t revision = 0;
    std::optional<Selection> selection;
    std::vector<CanvasHandle> handles;
};

/// Nothing is selected if the element is gone or the document cannot be derived. Throws what `progress` throws.
SelectionFound find_selection(const SelectionSearch& search, const Progress& progress = {});

}  // namespace rinceau

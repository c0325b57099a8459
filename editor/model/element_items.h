#pragma once
// Which item of a picture stands for which element of the drawing.

#include <cstdint>
#include <memory>
#include <vector>

#include "editor/model/derived_picture.h"

namespace rinceau {

struct ElementItems {
    std::shared_ptr<const DerivedPicture> picture;
    std::vector<std::int32_t> order_of_element;  ///< PictureItem::order; -1 = the picture has nothing in its place
};

/// One to one: what stands where the element has its middle, about as large. Elements whose rules were edited away have
/// nothing. `picture` is not null.
ElementItems items_of_elements(std::shared_ptr<const DerivedPicture> picture, const Scene& drawing,
                               const Progress& progress = {});

/// A flag for each item, by order: set for those of these elements.
std::vector<char> flags_of_elements(const ElementItems& items, const std::vector<int>& elements);

/// The elements that the items with orders in [first, last) stand for, rising.
std::vector<int> elements_of_items(const ElementItems& items, int first, int last);

/// The elements that items of this terminal stand for, rising.
std::vector<int> elements_of_terminal(const ElementItems& items, int terminal);

}  // namespace rinceau

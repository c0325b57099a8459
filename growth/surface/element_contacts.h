#pragma once
// How the elements of a drawing lie to each other: which of them touch, and whether they fill their outline.

#include <span>
#include <vector>

#include "growth/surface/lay_elements.h"

namespace rinceau {

struct ElementContact {
    int other = 0;
    Point at;               ///< of the drawing, about where they touch, or between them
    bool touching = false;  ///< they overlap, but for a gap that is none; else they are only near
};

/// By element: those that it touches or that are near, at half the smaller one's size at most, by rising number. What would
/// touch nothing touches the nearest of these. Elements without art touch nothing. What has very many triangles is taken as
/// its hull.
std::vector<std::vector<ElementContact>> element_contacts(std::span<const DrawnElement> elements);

/// By element: what it hangs on or stands on, the smallest that it touches of those that are clearly larger; -1: nothing.
std::vector<int> element_supports(std::span<const DrawnElement> elements,
                                  const std::vector<std::vector<ElementContact>>& contacts);

/// Do the elements' hulls cover most of the hull of them all, as lattices, facades and scales do? Plants and garlands do
/// not.
bool is_compact(std::span<const DrawnElement> elements);

/// How a drawing holds together.
struct ElementTies {
    bool compact = false;
    std::vector<std::vector<ElementContact>> contacts;
    std::vector<int> support;
};
ElementTies element_ties(std::span<const DrawnElement> elements);

/// What stays if only some elements are laid: nothing without its support, and of elements that hang together in the drawing
/// but no longer as laid, the part with the largest area. `area` by element; 0 = not laid.
std::vector<bool> elements_held(const ElementTies& ties, std::vector<double> area);

}  // namespace rinceau

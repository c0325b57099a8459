#pragma once
// How the elements of a drawing lie to each other: which of them touch, and whether they fill their outline.

#include <span>
#include <vector>

#include "growth/surface/lay_elements.h"

namespace rinceau {

struct ElementContact {
    int other = 0;
    Point at;  ///< of the drawing, about where they touch
};

/// By element: those that it overlaps, or that are no farther away than a small share of the smaller one's size; by rising
/// number. Elements without art touch nothing. What has very many triangles is taken as its hull.
std::vector<std::vector<ElementContact>> element_contacts(std::span<const DrawnElement> elements);

/// Do the elements' hulls cover most of the hull of them all, as lattices, facades and scales do? Plants and garlands do
/// not.
bool is_compact(std::span<const DrawnElement> elements);

/// What stays if only some elements are laid: of elements that hang together in the drawing but no longer as laid, the part
/// with the largest area. `area` by element; 0 = not laid.
std::vector<bool> elements_held(const std::vector<std::vector<ElementContact>>& contacts, const std::vector<double>& area);

}  // namespace rinceau

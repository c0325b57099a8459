#include "editor/model/lit_items.h"

#include <algorithm>

namespace rinceau {

LitItems lit_range(std::size_t elements, int first, int last) {
    std::vector<char> lit(elements, 0);
    const auto bounded = [&](int order) { return std::clamp<std::ptrdiff_t>(order, 0, std::ssize(lit)); };
    std::fill(lit.begin() + bounded(first), lit.begin() + bounded(last), char{1});
    return std::make_shared<const std::vector<char>>(std::move(lit));
}

LitItems lit_by_terminal(const DerivedPicture& picture, int terminal) {
    std::vector<char> lit(picture.items.size(), 0);
    for (const PictureItem& item : picture.items)
        if (picture.looks[static_cast<std::size_t>(item.look)].terminal == terminal)
            lit[static_cast<std::size_t>(item.order)] = 1;
    return std::make_shared<const std::vector<char>>(std::move(lit));
}

LitItems lit_by_rule(const Document& document, int production, const Progress& progress) {
    std::vector<char> lit;
    visit_placements(
        *document.resolved, {.derive = document.derive, .trails = true},
        [&](const Placement& placement) {
            const bool placed = std::ranges::any_of(
                placement.trail, [&](const Occurrence& occurrence) { return occurrence.production == production; });
            lit.push_back(placed ? 1 : 0);
        },
        progress);
    return std::make_shared<const std::vector<char>>(std::move(lit));
}

}  // namespace rinceau

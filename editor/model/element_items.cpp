#include "editor/model/element_items.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analyzer/moments.h"
#include "geometry/kd_tree.h"

namespace rinceau {
namespace {

/// Where something stands and how large it is.
struct Spot {
    Point middle;
    double size = 0;  ///< rms radius
};

Spot spot_of(const std::vector<Path>& paths, const Style& style, const std::string& verbatim, const Box& verbatim_box) {
    if (!verbatim.empty()) {
        if (is_empty(verbatim_box)) return {};
        return {0.5 * (verbatim_box.low + verbatim_box.high), abs(verbatim_box.high - verbatim_box.low) / 2};
    }
    const Descriptor found = describe(outline_of(paths, style));
    return {found.centroid, found.rms_radius};
}

std::vector<Spot> spots_of_items(const DerivedPicture& picture) {
    std::vector<Spot> of_look;
    for (const PictureLook& look : picture.looks) {
        const Terminal& terminal = picture.grammar->terminals[static_cast<std::size_t>(look.terminal)];
        of_look.push_back(spot_of(terminal.paths, picture_style(picture, look), terminal.verbatim, terminal.verbatim_box));
    }
    std::vector<Spot> spots;
    for (const PictureItem& item : picture.items) {
        const Spot& spot = of_look[static_cast<std::size_t>(item.look)];
        spots.push_back({apply(item.pose, spot.middle), scale_of(item.pose) * spot.size});
    }
    return spots;
}

/// How far two spots are from being one, in their sizes; nothing if they are not.
std::optional<double> difference(const Spot& a, const Spot& b, double speck) {
    constexpr double most = 0.3;  // of the size: what a regular layout may move elements by
    const double size = std::max({a.size, b.size, speck});
    const double apart = abs(a.middle - b.middle) / size + std::abs(a.size - b.size) / size;
    return apart <= most ? std::optional(apart) : std::nullopt;
}

}  // namespace

ElementItems items_of_elements(std::shared_ptr<const DerivedPicture> picture, const Scene& drawing,
                               const Progress& progress) {
    constexpr std::size_t candidates = 8;  // items in one place that may stand for an element
    constexpr double speck_in_diagonals = 1e-6;
    const std::vector<Spot> items = spots_of_items(*picture);
    std::vector<Point> middles;
    for (const Spot& spot : items) middles.push_back(spot.middle);
    const KdTree tree(middles);
    const double speck = speck_in_diagonals * drawing_diagonal(drawing);
    std::vector<char> taken(items.size(), 0);
    ElementItems result{std::move(picture), {}};
    for (const Element& element : drawing.elements) {
        report(progress, "places", 0);
        const Spot spot = spot_of(element.paths, element.style, element.verbatim, element.verbatim_box);
        std::int32_t order = -1;
        std::size_t best = items.size();
        double least = 0;
        for (const Neighbor& near : tree.nearest(spot.middle, candidates)) {
            if (taken[near.index]) continue;
            const std::optional<double> apart = difference(spot, items[near.index], speck);
            if (!apart || (best < items.size() && *apart >= least)) continue;
            best = near.index;
            least = *apart;
        }
        if (best < items.size()) {
            taken[best] = 1;
            order = result.picture->items[best].order;
        }
        result.order_of_element.push_back(order);
    }
    return result;
}

std::vector<char> flags_of_elements(const ElementItems& items, const std::vector<int>& elements) {
    std::vector<char> flags(items.picture->items.size(), 0);
    for (const int element : elements) {
        const auto e = static_cast<std::size_t>(element);
        if (e < items.order_of_element.size() && items.order_of_element[e] >= 0)
            flags[static_cast<std::size_t>(items.order_of_element[e])] = 1;
    }
    return flags;
}

std::vector<int> elements_of_items(const ElementItems& items, int first, int last) {
    std::vector<int> elements;
    for (std::size_t e = 0; e < items.order_of_element.size(); ++e)
        if (items.order_of_element[e] >= first && items.order_of_element[e] < last) elements.push_back(static_cast<int>(e));
    return elements;
}

std::vector<int> elements_of_terminal(const ElementItems& items, int terminal) {
    std::vector<char> drawn(items.picture->items.size(), 0);
    for (const PictureItem& item : items.picture->items)
        drawn[static_cast<std::size_t>(item.order)] =
            items.picture->looks[static_cast<std::size_t>(item.look)].terminal == terminal;
    std::vector<int> elements;
    for (std::size_t e = 0; e < items.order_of_element.size(); ++e) {
        const auto order = items.order_of_element[e];
        if (order >= 0 && drawn[static_cast<std::size_t>(order)]) elements.push_back(static_cast<int>(e));
    }
    return elements;
}

}  // namespace rinceau

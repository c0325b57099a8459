#include "growth/surface/lay_whole.h"

#include <algorithm>
#include <array>

namespace rinceau {
namespace {

constexpr double group_share = 0.5;                        // of an element's stretch above 1 that a whole drawing may have
constexpr std::array<double, 3> follows = {1, 0.5, 0.25};  // tries, of the wanted follow

Box box_of(std::span<const DrawnElement> elements, std::span<const int> chosen) {
    Box box;
    for (const int i : chosen) box = including(box, elements[static_cast<std::size_t>(i)].box);
    return box;
}

}  // namespace

std::optional<std::vector<LaidShape>> lay_whole(ElementLayer& layer, const DrawingStand& middle, const DrawnDisc& disc,
                                                std::span<const DrawnElement> elements, std::span<const int> chosen,
                                                const LayWholeOptions& options) {
    const double group_stretch = 1 + group_share * (options.stretch - 1);
    const bool is_guided = options.field != nullptr && options.follow > 0;
    LayFault fault = LayFault::none;
    const auto lay = [&](const ElementChart& chart, double stretch) -> std::optional<std::vector<LaidShape>> {
        ElementLayer::Result result = layer.lay(chart, elements, chosen, stretch);
        fault = result.fault;
        if (fault != LayFault::none) return std::nullopt;
        return std::move(result.shapes);
    };
    if (!is_guided) {
        if (auto shapes = lay(layer.polar_chart(middle, disc.radius), group_stretch)) return shapes;
        if (fault == LayFault::outside) return std::nullopt;  // a border: no chart reaches beyond
    }
    const ElementChart sheet = layer.sheet_chart(middle, disc.radius, box_of(elements, chosen));
    if (is_guided) {
        for (const double share : follows)
            if (auto shapes = lay(layer.bent(sheet, *options.field, share * options.follow), options.stretch)) return shapes;
    } else {
        if (auto shapes = lay(sheet, group_stretch)) return shapes;
        if (!options.may_be_smaller)
            if (auto shapes = lay(sheet, options.stretch)) return shapes;
    }
    if (!options.compact) return std::nullopt;
    return lay(sheet, std::max(options.stretch, most_compact_stretch));
}

std::vector<LaidShape> lay_part(ElementLayer& layer, const DrawingStand& middle, double radius,
                                std::span<const DrawnElement> elements, std::span<const int> chosen) {
    const ElementChart sheet = layer.sheet_chart(middle, radius, box_of(elements, chosen));
    std::vector<LaidShape> shapes;
    for (const int element : chosen) {
        ElementLayer::Result result = layer.lay(sheet, elements, std::array{element}, most_compact_stretch);
        if (result.fault == LayFault::none) shapes.push_back(std::move(result.shapes.front()));
    }
    return shapes;
}

}  // namespace rinceau

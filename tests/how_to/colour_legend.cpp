#include "how_to/colour_legend.h"

#include <algorithm>
#include <array>
#include <map>

namespace rinceau {

namespace {

using Channels = std::array<std::uint8_t, 3>;

Channels channels(Color color) { return {color.red, color.green, color.blue}; }

/// The colours of an element, each once.
std::vector<Color> colors_of(Style style, const Repaint& repaint) {
    std::vector<Color> colors;
    if (repaint.fill && paints_fill(style)) style.fill = *repaint.fill;
    if (repaint.stroke && paints_stroke(style)) style.stroke.paint = *repaint.stroke;
    const auto add = [&](const Paint& paint) {
        const Color* color = std::get_if<Color>(&paint);
        if (color != nullptr && std::ranges::find(colors, *color) == colors.end()) colors.push_back(*color);
    };
    if (paints_fill(style)) add(style.fill);
    if (paints_stroke(style)) add(style.stroke.paint);
    return colors;
}

/// Calls `visit` with each element and its colours. Elements of one look share them, but for those that are repainted.
template <class Visit>
void visit_colors(const DerivedPicture& picture, Visit&& visit) {
    std::vector<std::vector<Color>> of_look;
    std::vector<Style> styles;
    for (const PictureLook& look : picture.looks) {
        const bool drawn = picture.grammar->terminals[static_cast<std::size_t>(look.terminal)].verbatim.empty();
        styles.push_back(drawn ? picture_style(picture, look) : Style{.fill = NoPaint{}});
        of_look.push_back(colors_of(styles.back(), {}));
    }
    for (const PictureItem& item : picture.items) {
        const auto look = static_cast<std::size_t>(item.look);
        const bool plain = item.repaint == Repaint{};
        visit(item, plain ? of_look[look] : colors_of(styles[look], item.repaint));
    }
}

}  // namespace

std::vector<LegendColour> colour_legend(const DerivedPicture& picture) {
    std::map<Channels, LegendColour> found;
    visit_colors(picture, [&](const PictureItem&, const std::vector<Color>& colors) {
        for (const Color color : colors) {
            LegendColour& entry = found[channels(color)];
            entry.color = color;
            ++entry.elements;
        }
    });
    std::vector<LegendColour> legend;
    for (const auto& [key, entry] : found) legend.push_back(entry);
    std::ranges::stable_sort(legend, std::ranges::greater{}, &LegendColour::elements);
    return legend;
}

LitItems lit_by_colour(const DerivedPicture& picture, Color color) {
    auto lit = std::make_shared<std::vector<char>>(picture.items.size(), char{0});
    visit_colors(picture, [&](const PictureItem& item, const std::vector<Color>& colors) {
        if (std::ranges::find(colors, color) != colors.end()) (*lit)[static_cast<std::size_t>(item.order)] = 1;
    });
    return lit;
}

}  // namespace rinceau

#include "editor/model/derived_picture.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

namespace rinceau {
namespace {

/// Indices of looks by terminal and style: few styles a terminal, so that a short list beats a map.
class LookIndex {
  public:
    explicit LookIndex(const Grammar& grammar) : grammar_(grammar), of_terminal_(grammar.terminals.size()) {}

    std::int32_t of(const Placement& placement, std::vector<PictureLook>& looks) {
        const auto terminal = static_cast<std::size_t>(placement.terminal);
        const int style = placement.style != 0 ? placement.style : grammar_.terminals[terminal].style;
        for (const auto& [known, index] : of_terminal_[terminal])
            if (known == style) return index;
        const auto index = static_cast<std::int32_t>(looks.size());
        looks.push_back({placement.terminal, style});
        of_terminal_[terminal].push_back({style, index});
        return index;
    }

  private:
    const Grammar& grammar_;
    std::vector<std::vector<std::pair<int, std::int32_t>>> of_terminal_;
};

}  // namespace

DerivedPicture derive_picture(const Document& document, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    DerivedPicture picture;
    picture.grammar = document.resolved;
    LookIndex index(*picture.grammar);
    std::vector<int> layers;
    bool layered = false;
    visit_placements(
        *picture.grammar, {.derive = document.derive},
        [&](const Placement& placement) {
            const auto look = index.of(placement, picture.looks);
            picture.items.push_back(
                {placement.pose, look, static_cast<std::int32_t>(picture.items.size()), placement.repaint});
            layers.push_back(placement.layer);
            layered = layered || placement.layer != layers.front();
        },
        progress);
    if (layered) {
        std::ranges::stable_sort(picture.items, {},
                                 [&](const PictureItem& item) { return layers[static_cast<std::size_t>(item.order)]; });
    }
    picture.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return picture;
}

DerivedPicture placed_picture(const std::shared_ptr<const Grammar>& grammar, const std::vector<Placement>& placements) {
    DerivedPicture picture;
    picture.grammar = grammar;
    LookIndex index(*grammar);
    picture.items.reserve(placements.size());
    for (const Placement& placement : placements) {
        const auto look = index.of(placement, picture.looks);
        picture.items.push_back({placement.pose, look, static_cast<std::int32_t>(picture.items.size()), placement.repaint});
    }
    return picture;
}

DerivedPicture drawing_picture(const Scene& drawing) {
    Grammar grammar;
    grammar.canvas = drawing.viewport;
    DerivedPicture picture;
    for (const Element& element : drawing.elements) {
        const int number = static_cast<int>(picture.items.size());
        grammar.styles.push_back({.number = number + 1, .style = element.style});
        grammar.terminals.push_back({.symbol = "E" + std::to_string(number),
                                     .style = number + 1,
                                     .paths = element.paths,
                                     .verbatim = element.verbatim,
                                     .verbatim_box = element.verbatim_box});
        picture.looks.push_back({number, number + 1});
        picture.items.push_back({{}, number, number, {}});
    }
    picture.grammar = std::make_shared<const Grammar>(std::move(grammar));
    return picture;
}

Style picture_style(const DerivedPicture& picture, const PictureLook& look) {
    const std::vector<NumberedStyle>& styles = picture.grammar->styles;
    // Styles are mostly numbered in order.
    const auto place = static_cast<std::size_t>(look.style) - 1;
    if (place < styles.size() && styles[place].number == look.style) return styles[place].style;
    const auto found = std::ranges::find(styles, look.style, &NumberedStyle::number);
    return found != styles.end() ? found->style : Style{};
}

}  // namespace rinceau

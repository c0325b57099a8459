#include "editor/gl/look_table.h"

#include <cmath>
#include <unordered_map>

namespace rinceau {
namespace {

/// A map that cannot be undone paints the last colour everywhere: all points are put beyond the end.
Affine to_unit_gradient(const Gradient& gradient, Point origin) {
    constexpr double beyond = 1e6;
    const double det = determinant(gradient.map);
    if (!(std::isfinite(det) && det != 0)) return {0, 0, 0, 0, beyond, 0};
    return inverse(gradient.map) * Affine{1, 0, 0, 1, origin.x, origin.y};
}

void add_gradients(LookEntry& entry, GradientTable& gradients) {
    for (const LookPart part : {LookPart::fill, LookPart::stroke}) {
        const PartPaint& paint = entry.paint.part(part);
        if (!paint.painted || !paint.gradient) continue;
        entry.gradients[index_of(part)] = gradients.number(*paint.gradient);
        entry.to_unit[index_of(part)] = to_unit_gradient(*paint.gradient, entry.shape->origin);
    }
}

}  // namespace

LookTable look_table(const std::shared_ptr<const DerivedPicture>& picture, ShapeStore& store) {
    const Grammar& grammar = *picture->grammar;
    const Style plain;
    std::unordered_map<int, const Style*> styles;
    for (const NumberedStyle& style : grammar.styles) styles.try_emplace(style.number, &style.style);
    store.forget_unused();
    LookTable table;
    table.picture = picture;
    table.looks.reserve(picture->looks.size());
    for (const PictureLook& look : picture->looks) {
        const Terminal& terminal = grammar.terminals[static_cast<std::size_t>(look.terminal)];
        LookEntry entry;
        if (!terminal.verbatim.empty()) entry.verbatim = store.text(terminal.verbatim);
        table.has_verbatim = table.has_verbatim || entry.verbatim != nullptr;
        const auto numbered = styles.find(look.style);
        const Style& style = numbered == styles.end() ? plain : *numbered->second;
        if (!entry.verbatim && !terminal.paths.empty() && (paints_fill(style) || paints_stroke(style))) {
            entry.paint = look_paint(style);
            entry.shape = store.shape(terminal.paths, style, entry.paint);
            add_gradients(entry, table.gradients);
        }
        table.looks.push_back(std::move(entry));
    }
    return table;
}

}  // namespace rinceau

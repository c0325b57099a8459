#include "editor/model/grown_pattern.h"

#include <utility>

namespace rinceau {
namespace {

/// What pictures of the figures need of their grammar.
std::shared_ptr<const Grammar> stage(const FiguredDrawing& drawing, const Box& canvas) {
    Grammar grammar;
    grammar.canvas = canvas;
    grammar.terminals = drawing.grammar.terminals;
    grammar.styles = drawing.grammar.styles;
    return std::make_shared<const Grammar>(std::move(grammar));
}

}  // namespace

GrownPattern blank_pattern(const Box& canvas) {
    Grammar grammar;
    grammar.canvas = canvas;
    DerivedPicture picture;
    picture.grammar = std::make_shared<const Grammar>(std::move(grammar));
    return {.picture = std::make_shared<const DerivedPicture>(std::move(picture))};
}

Box widened(const Box& box, double factor) {
    const Point half = 0.5 * factor * (box.high - box.low);
    return {center(box) - half, center(box) + half};
}

std::shared_ptr<const DerivedPicture> picture_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed,
                                                 const Box& canvas, const std::shared_ptr<const DerivedPicture>& before) {
    const bool same_canvas = before && before->grammar->canvas == canvas;
    const auto grammar = same_canvas ? before->grammar : stage(drawing, canvas);
    return std::make_shared<const DerivedPicture>(placed_picture(grammar, placements_of(drawing, placed)));
}

Box roomy_canvas(const Box& canvas, const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed) {
    constexpr double step = 0.1;  // of the diagonal
    Box taken;
    for (const PlacedFigure& one : placed) {
        const Figure& figure = drawing.figures[static_cast<std::size_t>(one.figure)];
        const Box at{one.pose.translation, one.pose.translation};
        taken = including(taken, grown(at, figure.radius * scale_of(one.pose)));
    }
    if (is_empty(taken) || contains(canvas, taken)) return canvas;
    return including(canvas, grown(taken, step * diagonal(canvas)));
}

Document grown_document(const Document& document, const GrownPattern& pattern) {
    Grammar grammar = grammar_of(*pattern.source->drawing, pattern.placed, pattern.picture->grammar->canvas);
    grammar.title = document.grammar->title;
    Document after = with_grammar(document, std::move(grammar));
    after.derive = {};
    after.locked.clear();
    return after;
}

}  // namespace rinceau

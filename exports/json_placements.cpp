#include "exports/json_placements.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "exports/plain_color.h"
#include "lsystem/drawn_style.h"
#include "lsystem/interpret.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

using Json = nlohmann::ordered_json;

Json canvas_json(const Box& canvas) {
    if (is_empty(canvas)) return nullptr;
    return {canvas.low.x, -canvas.high.y, canvas.high.x - canvas.low.x, canvas.high.y - canvas.low.y};
}

std::string paint_text(const Paint& paint) {
    if (is_gradient(paint)) return "gradient";
    const std::optional<PlainColor> plain = plain_color(paint);
    return plain ? hex_text(plain->color) : "none";
}

Json style_json(int number, const Style& style) {
    return {{"number", number},
            {"fill", paint_text(style.fill)},
            {"stroke", paint_text(style.stroke.paint)},
            {"stroke_width", style.stroke.width},
            {"fixed", style.stroke.fixed},
            {"stroke_first", style.stroke_first},
            {"fill_rule", style.fill_rule == FillRule::evenodd ? "evenodd" : "nonzero"}};
}

Json terminal_json(const Terminal& terminal) {
    return {{"symbol", terminal.symbol}, {"path", svg_path_data(terminal.paths)}, {"verbatim", !terminal.verbatim.empty()}};
}

/// A map of y-up spaces as one of y-down spaces.
Json matrix_json(const Affine& map) { return {map.a, -map.b, -map.c, map.d, map.e, -map.f}; }

Json placement_json(const Grammar& grammar, const Placement& placement) {
    const int own = grammar.terminals[static_cast<std::size_t>(placement.terminal)].style;
    Json json{{"terminal", placement.terminal},
              {"style", placement.style != 0 ? placement.style : own},
              {"layer", placement.layer},
              {"order", placement.order},
              {"matrix", matrix_json(to_affine(placement.pose))}};
    const auto style = std::ranges::find(grammar.styles, drawn_style_number(grammar, placement), &NumberedStyle::number);
    const Style painted = repainted(style == grammar.styles.end() ? Style{} : style->style, placement.repaint);
    if (placement.repaint.fill) json["fill"] = paint_text(painted.fill);
    if (placement.repaint.stroke) json["stroke"] = paint_text(painted.stroke.paint);
    return json;
}

/// One item a line.
template <class Items, class ToJson>
std::string lines(const Items& items, ToJson to_json) {
    std::string text;
    for (const auto& item : items) {
        text += text.empty() ? "\n  " : ",\n  ";
        text += to_json(item).dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    return '[' + text + ']';
}

}  // namespace

Export to_placements(const Grammar& grammar, const ExportOptions& options) {
    const std::vector<Placement> placements = interpret(grammar, {.derive = options.derive});
    std::string text = "{\"format\": \"rinceau-placements\", \"version\": 1,\n \"canvas\": ";
    text += canvas_json(grammar.canvas).dump();
    text += ",\n \"styles\": ";
    text += lines(grammar.styles, [](const NumberedStyle& style) { return style_json(style.number, style.style); });
    text += ",\n \"terminals\": ";
    text += lines(grammar.terminals, terminal_json);
    text += ",\n \"placements\": ";
    text += lines(placements, [&](const Placement& placement) { return placement_json(grammar, placement); });
    return {.bytes = text + "}\n"};
}

}  // namespace rinceau

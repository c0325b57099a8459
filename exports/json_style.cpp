#include "exports/json_style.h"

#include <algorithm>
#include <array>

#include "exports/number.h"
#include "exports/plain_color.h"
#include "lsystem/grammar_text.h"

namespace rinceau {

namespace {

Json gradient_json(const Gradient& gradient) {
    Json json{{"gradient", gradient.kind == GradientKind::linear ? "linear" : "radial"}};
    const Affine& map = gradient.map;
    // the way from the unit gradient is followed by the flip to y down
    json["matrix"] = {map.a, -map.b, map.c, -map.d, map.e, -map.f};
    if (gradient.spread != GradientSpread::pad)
        json["spread"] = gradient.spread == GradientSpread::reflect ? "reflect" : "repeat";
    if (!(gradient.focus == Point{})) json["focus"] = {gradient.focus.x, gradient.focus.y};
    if (gradient.focal_radius != 0) json["focal-radius"] = gradient.focal_radius;
    json["stops"] = Json::array();
    for (const GradientStop& stop : gradient.stops) {
        Json part{{"offset", stop.offset}, {"color", hex_text(stop.color)}};
        if (stop.opacity != 1) part["opacity"] = stop.opacity;
        json["stops"].push_back(std::move(part));
    }
    return json;
}

Json paint_json(const Paint& paint) {
    if (is_gradient(paint)) return gradient_json(*std::get<std::shared_ptr<const Gradient>>(paint));
    const auto* color = std::get_if<Color>(&paint);
    return color == nullptr ? Json("none") : Json(hex_text(*color));
}

void stroke_json(Json& json, const Stroke& stroke) {
    const Stroke usual;
    if (!std::holds_alternative<NoPaint>(stroke.paint)) json["stroke"] = paint_json(stroke.paint);
    if (stroke.opacity != usual.opacity) json["stroke-opacity"] = stroke.opacity;
    if (stroke.width != usual.width || stroke.fixed) json["stroke-width"] = stroke.width;
    if (stroke.fixed) json["stroke-fixed"] = true;
    if (stroke.cap != usual.cap) json["stroke-linecap"] = stroke.cap == LineCap::round ? "round" : "square";
    if (stroke.join != usual.join) json["stroke-linejoin"] = stroke.join == LineJoin::round ? "round" : "bevel";
    if (stroke.miter_limit != usual.miter_limit) json["stroke-miterlimit"] = stroke.miter_limit;
    if (!stroke.dashes.empty()) json["stroke-dasharray"] = stroke.dashes;
    if (stroke.dash_offset != usual.dash_offset) json["stroke-dashoffset"] = stroke.dash_offset;
    if (const Linear2& pen = stroke.pen; !(pen == Linear2{})) json["pen"] = {pen.a, -pen.b, -pen.c, pen.d};
}

// ---- reading: a style's text, which the language reads and judges

constexpr std::array<std::string_view, 14> plain_keys{
    "fill-opacity",    "fill-rule",         "stroke-opacity",   "stroke-width",      "stroke-linecap",
    "stroke-linejoin", "stroke-miterlimit", "stroke-dasharray", "stroke-dashoffset", "pen",
    "opacity",         "paint-order",       "shape-rendering",  "stroke-fixed"};

/// A word or a number, or several numbers: nothing that could end the property.
std::string value_text(const JsonValue& value) {
    const Json& json = value.json();
    if (json.is_number()) return number_of(value.number());
    if (json.is_array()) {
        std::string text;
        value.each([&](const JsonValue& part) { text += (text.empty() ? "" : " ") + number_of(part.number()); });
        return text.empty() ? "none" : text;
    }
    std::string word = value.text();
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '#' || c == '-';
    };
    if (word.empty() || !std::ranges::all_of(word, is_plain)) value.fail("a word, a colour or a number");
    return word;
}

std::string gradient_text(const JsonValue& value) {
    value.expect_keys({"gradient", "matrix", "spread", "focus", "focal-radius", "stops"});
    const std::string kind = value.member("gradient").text();
    if (kind != "linear" && kind != "radial") value.member("gradient").fail("linear or radial");
    std::string text = kind + "-gradient(matrix(" + value_text(value.member("matrix")) + ')';
    for (const char* key : {"spread", "focus", "focal-radius"}) {
        if (value.has(key)) text += std::string(", ") + key + ' ' + value_text(value.member(key));
    }
    value.member("stops").each([&](const JsonValue& stop) {
        stop.expect_keys({"offset", "color", "opacity"});
        text += ", " + number_of(stop.member("offset").number()) + ' ' + value_text(stop.member("color"));
        if (stop.has("opacity")) text += " opacity " + number_of(stop.member("opacity").number());
    });
    return text + ')';
}

/// One property, read as the language does, which knows what is allowed.
void expect_property(const JsonValue& value, const std::string& text) {
    try {
        (void)parse_grammar("lsystem 1\nstyle 1: " + text);
    } catch (const InputError& error) {
        value.fail(error);
    }
}

}  // namespace

Json style_json(const Style& style) {
    Json json{{"fill", paint_json(style.fill)}};
    if (style.fill_opacity != 1) json["fill-opacity"] = style.fill_opacity;
    if (style.fill_rule != FillRule::nonzero) json["fill-rule"] = "evenodd";
    stroke_json(json, style.stroke);
    if (style.opacity != 1) json["opacity"] = style.opacity;
    if (style.stroke_first) json["paint-order"] = "stroke";
    if (style.crisp_edges) json["shape-rendering"] = "crispEdges";
    return json;
}

bool is_style_key(std::string_view key) {
    return key == "fill" || key == "stroke" || std::ranges::find(plain_keys, key) != plain_keys.end();
}

Style parse_json_style(const JsonValue& value) {
    std::string text;
    const auto append = [&](const JsonValue& of, const std::string& property) {
        expect_property(of, property);
        text += (text.empty() ? "" : "; ") + property;
    };
    for (const char* paint : {"fill", "stroke"}) {
        if (!value.has(paint)) continue;
        const JsonValue member = value.member(paint);
        append(member, std::string(paint) + ' ' + (member.json().is_object() ? gradient_text(member) : value_text(member)));
    }
    const bool fixed = value.has("stroke-fixed") && value.member("stroke-fixed").truth();
    for (const std::string_view key : plain_keys) {
        const std::string name(key);
        if (key == "stroke-fixed" || !value.has(name)) continue;
        const JsonValue member = value.member(name);
        append(member, name + ' ' + value_text(member) + (fixed && key == "stroke-width" ? " fixed" : ""));
    }
    if (fixed && !value.has("stroke-width")) text += std::string(text.empty() ? "" : "; ") + "stroke-width 1 fixed";
    if (text.empty()) return {};
    try {
        return parse_grammar("lsystem 1\nstyle 1: " + text).styles.front().style;
    } catch (const InputError& error) {
        value.fail(error);
    }
}

}  // namespace rinceau

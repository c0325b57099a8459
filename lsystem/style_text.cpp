#include "lsystem/style_text.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "lsystem/number_text.h"
#include "lsystem/similar_name.h"
#include "scene/svg_color.h"

namespace rinceau {

namespace {

template <class Value>
using Words = std::span<const std::pair<std::string_view, Value>>;

constexpr std::array<std::pair<std::string_view, FillRule>, 2> fill_rules{
    {{"nonzero", FillRule::nonzero}, {"evenodd", FillRule::evenodd}}};
constexpr std::array<std::pair<std::string_view, LineCap>, 3> caps{
    {{"butt", LineCap::butt}, {"round", LineCap::round}, {"square", LineCap::square}}};
constexpr std::array<std::pair<std::string_view, LineJoin>, 3> joins{
    {{"miter", LineJoin::miter}, {"round", LineJoin::round}, {"bevel", LineJoin::bevel}}};
constexpr std::array<std::pair<std::string_view, GradientSpread>, 3> spreads{
    {{"pad", GradientSpread::pad}, {"reflect", GradientSpread::reflect}, {"repeat", GradientSpread::repeat}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> paint_orders{{{"fill", false}, {"stroke", true}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> renderings{{{"auto", false}, {"crispEdges", true}}};

template <class Value>
std::string_view word_of(Words<Value> words, Value value) {
    for (const auto& [word, meaning] : words) {
        if (meaning == value) return word;
    }
    return words.front().first;
}

// ---- reading

template <class Value>
Value read_word(Scanner& scanner, Words<Value> words) {
    std::string expected;
    for (const auto& [word, meaning] : words) expected += (expected.empty() ? "" : " or ") + std::string(word);
    const SourcePlace place = scanner.place();
    const std::string found = scanner.word();
    for (const auto& [word, meaning] : words) {
        if (found == word) return meaning;
    }
    throw InputError(place, "expected " + expected + ", found '" + found + "'");
}

double read_between(Scanner& scanner, double low, double high, const std::string& what) {
    const SourcePlace place = scanner.place();
    const double value = scanner.number();
    if (value >= low && value <= high) return value;
    throw InputError(place, "expected " + what + ", found " + number_text(value));
}

double read_share(Scanner& scanner) { return read_between(scanner, 0, 1, "a number from 0 to 1"); }
double read_length(Scanner& scanner) {
    return read_between(scanner, 0, std::numeric_limits<double>::max(), "a length that is not below 0");
}

Color read_color(Scanner& scanner) {
    const SourcePlace place = scanner.place();
    const std::string word = scanner.word();
    const std::optional<ParsedColor> parsed = parse_color(word);
    if (!parsed || parsed->current || parsed->opacity != 1) {
        throw InputError(place,
                         "expected a colour such as #ffcc00 or gold (its opacity stands apart), found '" + word + "'");
    }
    return parsed->color;
}

/// y down <-> y up: the way from the unit gradient is followed by the flip.
Affine flipped(const Affine& map) { return {map.a, -map.b, map.c, -map.d, map.e, -map.f}; }
/// y down <-> y up on both sides of the pen.
Linear2 flipped(const Linear2& pen) { return {pen.a, -pen.b, -pen.c, pen.d}; }

void read_stop(Scanner& scanner, Gradient& gradient) {
    const SourcePlace place = scanner.place();
    GradientStop stop;
    stop.offset = read_share(scanner);
    if (!gradient.stops.empty() && stop.offset < gradient.stops.back().offset) {
        throw InputError(place, "expected stops in rising order, found " + number_text(stop.offset) + " after " +
                                    number_text(gradient.stops.back().offset));
    }
    stop.color = read_color(scanner);
    if (scanner.take("opacity")) stop.opacity = read_share(scanner);
    gradient.stops.push_back(stop);
}

void read_gradient_part(Scanner& scanner, Gradient& gradient) {
    if (scanner.take("matrix")) {
        scanner.expect("(");
        Affine map;
        for (double* number : {&map.a, &map.b, &map.c, &map.d, &map.e, &map.f}) *number = scanner.number();
        gradient.map = flipped(map);
        scanner.expect(")");
    } else if (scanner.take("spread")) {
        gradient.spread = read_word<GradientSpread>(scanner, spreads);
    } else if (scanner.take("focus")) {
        gradient.focus.x = scanner.number();
        gradient.focus.y = scanner.number();
    } else if (scanner.take("focal-radius")) {
        gradient.focal_radius = read_share(scanner);
    } else {
        read_stop(scanner, gradient);
    }
}

Paint read_paint(Scanner& scanner) {
    if (scanner.take("none")) return NoPaint{};
    const bool linear = scanner.take("linear-gradient");
    if (!linear && !scanner.take("radial-gradient")) return read_color(scanner);
    Gradient gradient;
    gradient.kind = linear ? GradientKind::linear : GradientKind::radial;
    scanner.expect("(");
    do {
        read_gradient_part(scanner, gradient);
    } while (scanner.take(","));
    if (gradient.stops.size() < 2) scanner.fail("at least two stops such as 0 #ff0000, 1 #0000ff");
    scanner.expect(")");
    return std::make_shared<const Gradient>(std::move(gradient));
}

std::vector<double> read_dashes(Scanner& scanner) {
    std::vector<double> dashes;
    if (scanner.take("none")) return dashes;
    do {
        dashes.push_back(read_length(scanner));
        scanner.take(",");
    } while (!scanner.at_end() && !scanner.peek(";"));
    // an odd list is gone through twice, as in SVG
    if (dashes.size() % 2 == 1) {
        const std::vector<double> once = dashes;
        dashes.insert(dashes.end(), once.begin(), once.end());
    }
    return dashes;
}

Linear2 read_pen(Scanner& scanner) {
    Linear2 pen;
    for (double* number : {&pen.a, &pen.b, &pen.c, &pen.d}) *number = scanner.number();
    return flipped(pen);
}

void read_stroke_width(Scanner& scanner, Stroke& stroke) {
    stroke.width = read_length(scanner);
    stroke.fixed = scanner.take("fixed");
}

struct Property {
    std::string_view name;
    void (*read)(Scanner&, Style&);
};

constexpr std::array properties{
    Property{"fill", [](Scanner& s, Style& style) { style.fill = read_paint(s); }},
    Property{"fill-opacity", [](Scanner& s, Style& style) { style.fill_opacity = read_share(s); }},
    Property{"fill-rule", [](Scanner& s, Style& style) { style.fill_rule = read_word<FillRule>(s, fill_rules); }},
    Property{"stroke", [](Scanner& s, Style& style) { style.stroke.paint = read_paint(s); }},
    Property{"stroke-opacity", [](Scanner& s, Style& style) { style.stroke.opacity = read_share(s); }},
    Property{"stroke-width", [](Scanner& s, Style& style) { read_stroke_width(s, style.stroke); }},
    Property{"stroke-linecap", [](Scanner& s, Style& style) { style.stroke.cap = read_word<LineCap>(s, caps); }},
    Property{"stroke-linejoin", [](Scanner& s, Style& style) { style.stroke.join = read_word<LineJoin>(s, joins); }},
    Property{"stroke-miterlimit", [](Scanner& s, Style& style) { style.stroke.miter_limit = read_length(s); }},
    Property{"stroke-dasharray", [](Scanner& s, Style& style) { style.stroke.dashes = read_dashes(s); }},
    Property{"stroke-dashoffset", [](Scanner& s, Style& style) { style.stroke.dash_offset = s.number(); }},
    Property{"pen", [](Scanner& s, Style& style) { style.stroke.pen = read_pen(s); }},
    Property{"opacity", [](Scanner& s, Style& style) { style.opacity = read_share(s); }},
    Property{"paint-order", [](Scanner& s, Style& style) { style.stroke_first = read_word<bool>(s, paint_orders); }},
    Property{"shape-rendering", [](Scanner& s, Style& style) { style.crisp_edges = read_word<bool>(s, renderings); }},
};

// ---- writing

std::string color_text(Color color) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : {color.red, color.green, color.blue}) {
        text += digits[channel / 16];
        text += digits[channel % 16];
    }
    return text;
}

std::string gradient_text(const Gradient& gradient) {
    std::string text = gradient.kind == GradientKind::linear ? "linear-gradient(" : "radial-gradient(";
    const Affine map = flipped(gradient.map);
    text += "matrix(" + number_text(map.a);
    for (const double number : {map.b, map.c, map.d, map.e, map.f}) text += ' ' + number_text(number);
    text += ')';
    if (gradient.spread != GradientSpread::pad)
        text += ", spread " + std::string(word_of<GradientSpread>(spreads, gradient.spread));
    if (!(gradient.focus == Point{}))
        text += ", focus " + number_text(gradient.focus.x) + ' ' + number_text(gradient.focus.y);
    if (gradient.focal_radius != 0) text += ", focal-radius " + number_text(gradient.focal_radius);
    for (const GradientStop& stop : gradient.stops) {
        text += ", " + number_text(stop.offset) + ' ' + color_text(stop.color);
        if (stop.opacity != 1) text += " opacity " + number_text(stop.opacity);
    }
    return text + ')';
}

std::string paint_text(const Paint& paint) {
    if (const auto* color = std::get_if<Color>(&paint)) return color_text(*color);
    const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint);
    return gradient != nullptr && *gradient != nullptr ? gradient_text(**gradient) : "none";
}

class StyleWriter {
  public:
    std::string text;

    void add(std::string_view property, const std::string& value) {
        if (!text.empty()) text += "; ";
        text += std::string(property) + ' ' + value;
    }
    void number(std::string_view property, double value, double usual) {
        if (value != usual) add(property, number_text(value));
    }
    template <class Value>
    void word(std::string_view property, Words<Value> words, Value value) {
        if (value != words.front().second) add(property, std::string(word_of(words, value)));
    }
};

void write_stroke(StyleWriter& writer, const Stroke& stroke) {
    const Stroke usual;
    if (!std::holds_alternative<NoPaint>(stroke.paint)) writer.add("stroke", paint_text(stroke.paint));
    writer.number("stroke-opacity", stroke.opacity, usual.opacity);
    if (stroke.fixed)
        writer.add("stroke-width", number_text(stroke.width) + " fixed");
    else
        writer.number("stroke-width", stroke.width, usual.width);
    writer.word<LineCap>("stroke-linecap", caps, stroke.cap);
    writer.word<LineJoin>("stroke-linejoin", joins, stroke.join);
    writer.number("stroke-miterlimit", stroke.miter_limit, usual.miter_limit);
    if (!stroke.dashes.empty()) {
        std::string dashes;
        for (const double dash : stroke.dashes) {
            if (!dashes.empty()) dashes += ' ';
            dashes += number_text(dash);
        }
        writer.add("stroke-dasharray", dashes);
    }
    writer.number("stroke-dashoffset", stroke.dash_offset, usual.dash_offset);
    if (!(stroke.pen == Linear2{})) {
        const Linear2 pen = flipped(stroke.pen);
        writer.add("pen",
                   number_text(pen.a) + ' ' + number_text(pen.b) + ' ' + number_text(pen.c) + ' ' + number_text(pen.d));
    }
}

}  // namespace

namespace {

void read_property(Scanner& scanner, Style& style, std::vector<std::string>& seen) {
    const SourcePlace place = scanner.place();
    const std::string name = scanner.property();
    const auto property = std::ranges::find(properties, name, &Property::name);
    if (property == properties.end()) {
        std::vector<std::string_view> names;
        for (const Property& known : properties) names.push_back(known.name);
        throw InputError(place, "expected a property such as fill, stroke, stroke-width or opacity, found '" + name + "'" +
                                    did_you_mean(name, names));
    }
    if (std::ranges::find(seen, name) != seen.end())
        throw InputError(place, "expected '" + name + "' once, found it again: take one of them away");
    seen.push_back(name);
    property->read(scanner, style);
    if (style.stroke.fixed && style.stroke.pen != Linear2{})
        throw InputError(place, "expected a stroke-width without 'fixed' where there is a pen, found both");
}

}  // namespace

Style parse_style(Scanner& scanner) {
    Style style;
    std::vector<std::string> seen;
    while (!scanner.at_end()) {
        scanner.piece([&] {
            read_property(scanner, style, seen);
            if (!scanner.peek(";")) scanner.expect_end("';' before the next property");
        });
        scanner.take(";");
    }
    return style;
}

std::string style_text(const Style& style) {
    const Style usual;
    StyleWriter writer;
    writer.add("fill", paint_text(style.fill));
    writer.number("fill-opacity", style.fill_opacity, usual.fill_opacity);
    writer.word<FillRule>("fill-rule", fill_rules, style.fill_rule);
    write_stroke(writer, style.stroke);
    writer.number("opacity", style.opacity, usual.opacity);
    writer.word<bool>("paint-order", paint_orders, style.stroke_first);
    writer.word<bool>("shape-rendering", renderings, style.crisp_edges);
    return writer.text;
}

}  // namespace rinceau

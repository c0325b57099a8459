#include "scene/svg_transform.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/angle.h"
#include "scene/svg_number.h"

namespace rinceau {

namespace {

constexpr double degrees_per_gradian = 0.9;

struct CssFrame {
    const UnitContext& context;
    const Box& reference;
};

// How one function's arguments are read: plain numbers, or CSS values with units when `css` is given.
struct Arguments {
    std::vector<std::string_view> words;
    const CssFrame* css = nullptr;

    std::size_t size() const { return words.size(); }
    std::optional<double> number(std::size_t i) const { return css ? parse_share(words[i]) : parse_number(words[i]); }
    std::optional<double> plain_number(std::size_t i) const { return parse_number(words[i]); }
    std::optional<double> length(std::size_t i, LengthAxis axis) const;
    std::optional<double> angle(std::size_t i) const;
};

std::optional<double> css_length(std::string_view word, const CssFrame& frame, LengthAxis axis) {
    UnitContext of_box = frame.context;
    of_box.width = width(frame.reference);
    of_box.height = height(frame.reference);
    return parse_length(word, of_box, axis);
}

std::optional<double> Arguments::length(std::size_t i, LengthAxis axis) const {
    return css ? css_length(words[i], *css, axis) : parse_number(words[i]);
}

// Radians.
std::optional<double> Arguments::angle(std::size_t i) const {
    constexpr double largest = 1e300;  // beyond, what is computed of it is no number
    TextCursor cursor{words[i]};
    const std::optional<double> value = read_number(cursor);
    if (!value || std::abs(*value) > largest) return std::nullopt;
    const std::string unit = lower_case(cursor.text.substr(cursor.at));
    if (unit.empty()) return radians(*value);
    if (!css) return std::nullopt;
    if (unit == "deg") return radians(*value);
    if (unit == "rad") return *value;
    if (unit == "grad") return radians(*value * degrees_per_gradian);
    if (unit == "turn") return *value * two_pi;
    return std::nullopt;
}

Affine translation(double x, double y) { return {1, 0, 0, 1, x, y}; }
Affine scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }

// Exact for multiples of a quarter turn, so that right angles stay right.
Affine rotation(double angle) {
    const double quarters = angle / (pi / 2);
    if (quarters == std::round(quarters)) {
        constexpr std::array<Point, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const double turn = std::fmod(quarters, 4);
        const Point c = directions[static_cast<std::size_t>(turn < 0 ? turn + 4 : turn)];
        return {c.x, c.y, -c.y, c.x, 0, 0};
    }
    const Complex c = polar(1, angle);
    return {c.x, c.y, -c.y, c.x, 0, 0};
}

std::optional<Affine> matrix_function(const Arguments& arguments) {
    if (arguments.size() != 6) return std::nullopt;
    std::array<double, 6> entries{};
    for (std::size_t i = 0; i < 6; ++i) {
        const std::optional<double> entry = arguments.plain_number(i);
        if (!entry) return std::nullopt;
        entries[i] = *entry;
    }
    return Affine{entries[0], entries[1], entries[2], entries[3], entries[4], entries[5]};
}

std::optional<Affine> translate_function(const Arguments& arguments) {
    if (arguments.size() < 1 || arguments.size() > 2) return std::nullopt;
    const std::optional<double> x = arguments.length(0, LengthAxis::x);
    const std::optional<double> y = arguments.size() > 1 ? arguments.length(1, LengthAxis::y) : 0.0;
    return x && y ? std::optional(translation(*x, *y)) : std::nullopt;
}

std::optional<Affine> scale_function(const Arguments& arguments) {
    if (arguments.size() < 1 || arguments.size() > 2) return std::nullopt;
    const std::optional<double> x = arguments.number(0);
    const std::optional<double> y = arguments.size() > 1 ? arguments.number(1) : x;
    return x && y ? std::optional(scaling(*x, *y)) : std::nullopt;
}

std::optional<Affine> rotate_function(const Arguments& arguments) {
    if (arguments.size() != 1 && (arguments.size() != 3 || arguments.css)) return std::nullopt;
    const std::optional<double> angle = arguments.angle(0);
    if (!angle) return std::nullopt;
    if (arguments.size() == 1) return rotation(*angle);
    const std::optional<double> x = arguments.number(1);
    const std::optional<double> y = arguments.number(2);
    return x && y ? std::optional(about(rotation(*angle), {*x, *y})) : std::nullopt;
}

std::optional<Affine> skew(std::optional<double> x, std::optional<double> y) {
    return x && y ? std::optional(Affine{1, std::tan(*y), std::tan(*x), 1, 0, 0}) : std::nullopt;
}

// Functions of one argument, in CSS only but for the two skews of the attribute.
std::optional<Affine> single_function(std::string_view name, const Arguments& arguments) {
    if (arguments.size() != 1) return std::nullopt;
    if (name == "skewx") return skew(arguments.angle(0), 0.0);
    if (name == "skewy") return skew(0.0, arguments.angle(0));
    if (!arguments.css) return std::nullopt;
    const bool x_axis = name.back() == 'x';
    if (name == "translatex" || name == "translatey") {
        const std::optional<double> by = arguments.length(0, x_axis ? LengthAxis::x : LengthAxis::y);
        return by ? std::optional(x_axis ? translation(*by, 0) : translation(0, *by)) : std::nullopt;
    }
    if (name == "scalex" || name == "scaley") {
        const std::optional<double> by = arguments.number(0);
        return by ? std::optional(x_axis ? scaling(*by, 1) : scaling(1, *by)) : std::nullopt;
    }
    return std::nullopt;
}

std::optional<Affine> transform_function(std::string_view name, const Arguments& arguments) {
    if (name == "matrix") return matrix_function(arguments);
    if (name == "translate") return translate_function(arguments);
    if (name == "scale") return scale_function(arguments);
    if (name == "rotate") return rotate_function(arguments);
    if (name == "skew" && arguments.css && arguments.size() == 2) return skew(arguments.angle(0), arguments.angle(1));
    return single_function(name, arguments);
}

// The words between the brackets, separated by white space and commas; a sign may follow a number directly ("1-2").
std::vector<std::string_view> argument_words(std::string_view text) {
    TextCursor cursor{trimmed(text)};
    std::vector<std::string_view> words;
    while (!cursor.at_end()) {
        const std::size_t start = cursor.at;
        read_number(cursor);
        const auto ends_word = [](char c) { return c == ',' || c == '-' || c == '+' || c == '.' || is_svg_space(c); };
        while (!cursor.at_end() && !ends_word(cursor.peek())) ++cursor.at;
        if (cursor.at == start) ++cursor.at;  // not a number: the word is faulty and will be found so
        words.push_back(cursor.text.substr(start, cursor.at - start));
        if (skip_comma_space(cursor) && cursor.at_end()) words.push_back({});
    }
    return words;
}

bool is_finite(const Affine& m) {
    return std::isfinite(m.a) && std::isfinite(m.b) && std::isfinite(m.c) && std::isfinite(m.d) && std::isfinite(m.e) &&
           std::isfinite(m.f);
}

ParsedTransform parse_functions(std::string_view text, const CssFrame* css) {
    TextCursor cursor{trimmed(text)};
    Affine map;
    while (!cursor.at_end()) {
        const std::size_t open = cursor.text.find('(', cursor.at);
        const std::size_t close = cursor.text.find(')', cursor.at);
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
            return {std::nullopt,
                    "expected a transform function, found \"" + std::string(cursor.text.substr(cursor.at)) + "\""};
        }
        const std::string name = lower_case(trimmed(cursor.text.substr(cursor.at, open - cursor.at)));
        const Arguments arguments{argument_words(cursor.text.substr(open + 1, close - open - 1)), css};
        const std::optional<Affine> next = name.empty() ? std::nullopt : transform_function(name, arguments);
        cursor.at = close + 1;
        if (!next || !is_finite(map * *next)) {
            return {std::nullopt, "transform function \"" + name + "\" is unknown or has faulty arguments"};
        }
        map = map * *next;
        if (skip_comma_space(cursor) && cursor.at_end())
            return {std::nullopt, "expected a transform function after the comma"};
    }
    return {map, {}};
}

// What one word of transform-origin says about either axis: "left" nothing about y, a length something about both.
struct OriginWord {
    std::optional<double> x, y;
};

OriginWord origin_word(std::string_view word, const CssFrame& frame) {
    const Box& box = frame.reference;
    const std::string keyword = lower_case(word);
    if (keyword == "left") return {box.low.x, std::nullopt};
    if (keyword == "right") return {box.high.x, std::nullopt};
    if (keyword == "top") return {std::nullopt, box.low.y};
    if (keyword == "bottom") return {std::nullopt, box.high.y};
    if (keyword == "center") return {center(box).x, center(box).y};
    OriginWord result;
    if (const auto x = css_length(word, frame, LengthAxis::x)) result.x = box.low.x + *x;
    if (const auto y = css_length(word, frame, LengthAxis::y)) result.y = box.low.y + *y;
    return result;
}

}  // namespace

Affine about(const Affine& map, Point origin) {
    return translation(origin.x, origin.y) * map * translation(-origin.x, -origin.y);
}

ParsedTransform parse_transform_attribute(std::string_view text) { return parse_functions(text, nullptr); }

ParsedTransform parse_css_transform(std::string_view text, const UnitContext& context, const Box& reference) {
    if (lower_case(trimmed(text)) == "none") return {Affine{}, {}};
    const CssFrame frame{context, reference};
    return parse_functions(text, &frame);
}

std::optional<Point> parse_transform_origin(std::string_view text, const UnitContext& context, const Box& reference) {
    const CssFrame frame{context, reference};
    TextCursor cursor{trimmed(text)};
    std::vector<OriginWord> words;
    while (!cursor.at_end() && words.size() < 3) {
        const std::size_t start = cursor.at;
        while (!cursor.at_end() && cursor.peek() != ',' && !is_svg_space(cursor.peek())) ++cursor.at;
        words.push_back(origin_word(cursor.text.substr(start, cursor.at - start), frame));
        skip_comma_space(cursor);
    }
    if (words.empty() || !cursor.at_end()) return std::nullopt;
    const Point middle = center(reference);
    // A single word stands for its own axis, the other one is in the middle; two vertical-first words are exchanged.
    if (words.size() == 1) {
        if (words[0].x) return Point{*words[0].x, middle.y};
        return words[0].y ? std::optional(Point{middle.x, *words[0].y}) : std::nullopt;
    }
    if (words[0].x && words[1].y) return Point{*words[0].x, *words[1].y};
    if (words[0].y && words[1].x) return Point{*words[1].x, *words[0].y};
    return std::nullopt;
}

}  // namespace rinceau

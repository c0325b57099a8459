#include "exports/cfdg_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "exports/number.h"
#include "exports/plain_color.h"

namespace rinceau {

std::set<std::string> cfdg_words() {
    return {
        "a",       "b",          "f",         "h",          "r",          "s",       "t",         "x",        "y",
        "z",       "sat",        "hue",       "size",       "rotate",     "flip",    "skew",      "trans",    "transform",
        "time",    "timescale",  "shape",     "path",       "rule",       "loop",    "finally",   "if",       "else",
        "switch",  "case",       "let",       "clone",      "startshape", "include", "import",    "tile",     "background",
        "sin",     "cos",        "tan",       "cot",        "asin",       "acos",    "atan",      "acot",     "sinh",
        "cosh",    "tanh",       "asinh",     "acosh",      "atanh",      "atan2",   "min",       "max",      "mod",
        "rand",    "infinity",   "sg",        "div",        "divides",    "log",     "log10",     "exp",      "frame",
        "ftime",   "brightness", "alpha",     "saturation", "isNatural",  "floor",   "ceiling",   "abs",      "rand_static",
        "randint", "sqrt",       "bitand",    "bitor",      "bitxor",     "bitnot",  "bitleft",   "bitright", "cross",
        "dot",     "vec",        "hsb2rgb",   "rgb2hsb",    "dist",       "hypot",   "factorial", "number",   "natural",
        "vector",  "vector2",    "vector3",   "vector4",    "adjustment", "value",   "param",     "target",   "width",
        "select",  "width",      "CF",        "MOVETO",     "LINETO",     "ARCTO",   "CURVETO",   "MOVEREL",  "LINEREL",
        "ARCREL",  "CURVEREL",   "CLOSEPOLY", "FILL",       "STROKE",     "CIRCLE",  "SQUARE",    "TRIANGLE"};
}

std::string cfdg_head(const Grammar& grammar, const std::string& start, double most) {
    std::string text;
    const auto comment = [&](const std::string& lines) {
        std::istringstream stream(lines);
        stream.exceptions(std::ios::badbit);  // a lack of memory passes
        for (std::string line; std::getline(stream, line);) text += "// " + line + '\n';
    };
    comment(grammar.title);
    for (const std::string& line : grammar.comments) comment(line);
    text += "startshape " + start + "\n\n";
    if (const Box& box = grammar.canvas; !is_empty(box)) {
        const double across = box.high.x - box.low.x;
        const double down = box.high.y - box.low.y;
        text += "// cfdg -s " + number_of(std::ceil(across)) + 'x' + number_of(std::ceil(down)) + " draws the canvas\n";
        if (across > 0 && down > 0) {
            text += "CF::Size = [s " + number_of(across) + ' ' + number_of(down) + " x " +
                    number_of(-(box.low.x + box.high.x) / 2) + " y " + number_of(-(box.low.y + box.high.y) / 2) + "]\n";
        }
    }
    text += "CF::MinimumSize = 0.000001\n";  // pixels; less is taken for the usual limit, which leaves small things out
    constexpr double usual_limit = 1000;     // of natural numbers
    if (most >= usual_limit) text += "CF::MaxNatural = " + number_of(most + 1) + '\n';
    return text + '\n';
}

void NoteList::add(const std::string& note) {
    if (std::ranges::find(notes_, note) == notes_.end()) notes_.push_back(note);
}

namespace {

/// "[h 120 sat 1 b 0.5 a -0.2]": from black to the colour.
std::string color_text(const PlainColor& plain, double opacity) {
    const double red = plain.color.red / 255.0;
    const double green = plain.color.green / 255.0;
    const double blue = plain.color.blue / 255.0;
    const double high = std::max({red, green, blue});
    const double range = high - std::min({red, green, blue});
    constexpr double sextant = 60;  // degrees of the circle of hues
    double hue = 0;
    if (range > 0) {
        if (high == red) {
            hue = sextant * (green - blue) / range;
        } else if (high == green) {
            hue = sextant * (2 + (blue - red) / range);
        } else {
            hue = sextant * (4 + (red - green) / range);
        }
    }
    std::string text;
    const auto append = [&](const char* name, double value) {
        if (value == 0) return;
        text += text.empty() ? "" : " ";
        text += name;
        text += ' ' + number_of(value);
    };
    append("h", hue < 0 ? hue + 6 * sextant : hue);
    append("sat", high > 0 ? range / high : 0);
    append("b", high);
    append("a", plain.opacity * opacity - 1);
    return '[' + text + ']';
}

std::string stroke_text(const Style& style) {
    const Stroke& stroke = style.stroke;
    const std::optional<PlainColor> color = plain_color(stroke.paint);
    std::string text = " STROKE(" + number_of(stroke.width);
    const char* join = stroke.join == LineJoin::round   ? "CF::RoundJoin"
                       : stroke.join == LineJoin::bevel ? "CF::BevelJoin"
                                                        : "";
    const char* cap = stroke.cap == LineCap::round ? "CF::RoundCap" : stroke.cap == LineCap::square ? "CF::SquareCap" : "";
    std::string flags;
    for (const std::string flag : {join, cap, stroke.fixed ? "CF::IsoWidth" : ""}) {
        if (!flag.empty()) flags += (flags.empty() ? "" : " + ") + flag;
    }
    if (!flags.empty()) text += ", " + flags;
    return text + ')' + color_text(*color, stroke.opacity * style.opacity);
}

std::string fill_text(const Style& style) {
    const std::optional<PlainColor> color = plain_color(style.fill);
    const char* rule = style.fill_rule == FillRule::evenodd ? "(CF::EvenOdd)" : "";
    return std::string(" FILL") + rule + color_text(*color, style.fill_opacity * style.opacity);
}

std::string pair_text(Point point) { return number_of(point.x) + ',' + number_of(point.y); }

std::string outline_text(const Path& path) {
    std::string text = " MOVETO(" + pair_text(path.start) + ')';
    for (const Segment& segment : path.segments) {
        if (segment.straight) {
            text += " LINETO(" + pair_text(segment.to) + ')';
        } else {
            text += " CURVETO(" + pair_text(segment.to) + ", " + pair_text(segment.control1) + ", " +
                    pair_text(segment.control2) + ')';
        }
    }
    return text + (path.closed ? " CLOSEPOLY()\n" : "\n");
}

}  // namespace

bool cfdg_draws(const Terminal& terminal, const Style& style) {
    return terminal.verbatim.empty() && !terminal.paths.empty() && (paints_fill(style) || paints_stroke(style));
}

std::string cfdg_path(const std::string& name, const Terminal& terminal, const Style& style) {
    std::string text = "path " + name + " {\n";
    for (const Path& path : terminal.paths) text += outline_text(path);
    std::string paints;
    if (paints_fill(style)) paints = fill_text(style);
    if (paints_stroke(style)) paints = style.stroke_first ? stroke_text(style) + paints : paints + stroke_text(style);
    return text + paints + "\n}\n";
}

void note_losses(const Terminal& terminal, const Style& style, NoteList& notes) {
    const Stroke& stroke = style.stroke;
    if (!terminal.verbatim.empty()) return notes.add("fragments of SVG (" + terminal.symbol + ") are left out");
    const bool filled = paints_fill(style);
    const bool stroked = paints_stroke(style);
    if ((filled && is_gradient(style.fill)) || (stroked && is_gradient(stroke.paint)))
        notes.add("Context Free has no gradients: their mean colours are written");
    if (!stroked) return;
    if (!stroke.dashes.empty()) notes.add("Context Free has no dashes: dashed lines are whole");
    if (stroke.pen != Linear2{})
        notes.add("Context Free has no stretched pens: their lines are as wide as before the stretching");
    constexpr double context_free_limit = 4;
    if (stroke.join == LineJoin::miter && stroke.miter_limit != context_free_limit)
        notes.add("Context Free cuts mitres at 4 times the width: other limits are lost");
}

}  // namespace rinceau

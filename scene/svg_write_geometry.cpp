// Outlines and maps as SVG text. Scene space has y up, SVG has y down: every y changes its sign here.

#include "scene/svg_number.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

// A number behind a command letter or another number; a sign separates as well as a space does.
void append_number(std::string& text, double value, int digits) {
    const std::string number = svg_number(value, digits);
    const char before = text.back();
    const bool after_number = (before >= '0' && before <= '9') || before == '.';
    if (after_number && number.front() != '-') text += ' ';
    text += number;
}

void append_point(std::string& text, Point p, int digits) {
    append_number(text, p.x, digits);
    append_number(text, -p.y, digits);
}

void append_path(std::string& text, const Path& path, int digits) {
    text += 'M';
    append_point(text, path.start, digits);
    for (const Segment& segment : path.segments) {
        text += segment.straight ? 'L' : 'C';
        if (!segment.straight) {
            append_point(text, segment.control1, digits);
            append_point(text, segment.control2, digits);
        }
        append_point(text, segment.to, digits);
    }
    if (path.closed) text += 'Z';
}

std::string function_text(const std::string& name, std::initializer_list<double> arguments) {
    std::string text = name + "(";
    for (const double argument : arguments) {
        if (text.back() != '(') text += ' ';
        text += svg_number(argument);
    }
    return text + ")";
}

}  // namespace

std::string svg_path_data(const std::vector<Path>& paths, int digits) {
    std::string text;
    for (const Path& path : paths) append_path(text, path, digits);
    return text;
}

std::string svg_transform_text(const Affine& map) {
    if (map == Affine{}) return {};
    const bool even = map.b == 0 && map.c == 0;
    if (even && map.a == 1 && map.d == 1) return function_text("translate", {map.e, -map.f});
    if (even && map.e == 0 && map.f == 0) {
        return map.a == map.d ? function_text("scale", {map.a}) : function_text("scale", {map.a, map.d});
    }
    return function_text("matrix", {map.a, -map.b, -map.c, map.d, map.e, -map.f});
}

}  // namespace rinceau

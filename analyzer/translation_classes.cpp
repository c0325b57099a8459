#include "analyzer/translation_classes.h"

#include <cmath>
#include <map>

namespace rinceau {
namespace {

using Key = std::vector<double>;

void append_paint(Key& key, const Paint& paint) {
    const Color* color = std::get_if<Color>(&paint);
    key.push_back(color == nullptr ? -1 : color->red * 65536 + color->green * 256 + color->blue);
}

void append_style(Key& key, const Style& style) {
    const Stroke& stroke = style.stroke;
    append_paint(key, style.fill);
    append_paint(key, stroke.paint);
    key.insert(key.end(), {style.fill_opacity, double(style.fill_rule), style.opacity, double(style.stroke_first),
                           stroke.opacity, stroke.width, double(stroke.cap), double(stroke.join), stroke.miter_limit,
                           double(stroke.dashes.size()), stroke.pen.a, stroke.pen.b, stroke.pen.c, stroke.pen.d});
}

void append_paths(Key& key, const std::vector<Path>& paths, double quantum) {
    const Point origin = paths.front().start;
    const auto append = [&](Point p) {
        key.push_back(std::round((p.x - origin.x) / quantum));
        key.push_back(std::round((p.y - origin.y) / quantum));
    };
    for (const Path& path : paths) {
        key.push_back(static_cast<double>(path.segments.size()));
        key.push_back(path.closed);
        append(path.start);
        for (const Segment& segment : path.segments) {
            key.push_back(segment.straight);
            append(segment.control1);
            append(segment.control2);
            append(segment.to);
        }
    }
}

bool has_gradient(const Paint& paint) { return std::holds_alternative<std::shared_ptr<const Gradient>>(paint); }

}  // namespace

std::vector<int> translation_classes(const Scene& scene, double quantum) {
    std::vector<int> classes;
    std::map<Key, int> known;
    int count = 0;
    for (const Element& element : scene.elements) {
        const bool alone =
            element.paths.empty() || has_gradient(element.style.fill) || has_gradient(element.style.stroke.paint);
        Key key;
        if (!alone) {
            append_style(key, element.style);
            append_paths(key, element.paths, quantum);
        }
        const int number = alone ? count : known.try_emplace(std::move(key), count).first->second;
        classes.push_back(number);
        count += number == count;
    }
    return classes;
}

}  // namespace rinceau

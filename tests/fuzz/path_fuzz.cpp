// Values of SVG attributes: path data, transforms, paints.

#include <cmath>

#include "scene/svg_color.h"
#include "scene/svg_path_data.h"
#include "scene/svg_transform.h"
#include "scene/svg_write.h"
#include "tests/fuzz/fuzz_target.h"

namespace rinceau {
namespace {

constexpr Affine flip{1, 0, 0, -1, 0, 0};

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

void take_path_data(std::string_view text) {
    const ParsedPath parsed = parse_path_data(text);
    if (parsed.faulty) require(parsed.fault_at <= text.size() && !parsed.fault.empty(), "a fault has a place and words");
    for (const auto& [path, segment] : parsed.arc_joints)
        require(path < parsed.paths.size() && segment < parsed.paths[path].segments.size(),
                "joints of arcs are on the paths");
    for (const Path& path : parsed.paths) {
        require(is_finite(path.start), "coordinates are finite");
        for (const Segment& segment : path.segments)
            require(is_finite(segment.control1) && is_finite(segment.control2) && is_finite(segment.to),
                    "coordinates are finite");
    }
    const std::vector<Path> paths = transformed(parsed.paths, flip);
    const ParsedPath again = parse_path_data(svg_path_data(paths));
    require(!again.faulty && transformed(again.paths, flip) == paths, "path data that are written read back as the same");
}

void take_transform(std::string_view text) {
    const ParsedTransform parsed = parse_transform_attribute(text);
    require(parsed.map.has_value() == parsed.fault.empty(), "a transform is read or has a fault");
    parse_css_transform(text, {}, {{0, 0}, {10, 20}});
    parse_transform_origin(text, {}, {{0, 0}, {10, 20}});
    if (!parsed.map) return;
    const Affine map = flip * *parsed.map * flip;
    const ParsedTransform again = parse_transform_attribute(svg_transform_text(map));
    require(again.map && flip * *again.map * flip == map, "a transform that is written reads back as the same");
}

}  // namespace

void take_input(std::string_view bytes) {
    take_path_data(bytes);
    take_transform(bytes);
    parse_paint(bytes);
    const auto color = parse_color(bytes);
    if (color && !color->current) {
        const auto again = parse_color(svg_color_text(color->color));
        require(again && again->color == color->color, "a colour that is written reads back as the same");
    }
}

}  // namespace rinceau

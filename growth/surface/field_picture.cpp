#include "growth/surface/field_picture.h"

#include <cmath>
#include <numbers>

#include "geometry/index.h"
#include "growth/surface/shape_sources.h"
#include "growth/surface/streamlines.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

// Shares of the spacing: lines stay apart, balls stand out between them.
constexpr double line_width = 0.3, ball_size = 1.5, arrow_length = 1.6, arrow_width = 1.1, arrow_height = 0.35;
constexpr Color major_color{52, 66, 82}, minor_color{176, 110, 92};

constexpr int arrow_shape = 0, ball_shape = 1;

std::vector<GrammarShape> shapes() {
    std::vector<GrammarShape> made;
    for (const char* kind : {"arrow", "sphere"}) {
        ShapeSource source;
        source.name = source.kind = kind;
        made.push_back(make_shape(source, {}, {}));
    }
    return made;
}

PatternLine pattern_line(const SurfaceMesh& surface, const Streamline& line, double width) {
    PatternLine drawn;
    drawn.at = line.path;
    drawn.color = line.minor ? minor_color : major_color;
    for (const SurfacePoint p : line.path) {
        drawn.points.push_back(position_in_space(surface, p));
        drawn.normals.push_back(normal_at(surface, p));
        drawn.widths.push_back(width);
    }
    return drawn;
}

/// An arrow along the field at the middle of a line.
PatternShape arrow_on(const FieldOnSurface& field, const Streamline& line, double spacing) {
    const SurfacePoint middle = line.path[line.path.size() / 2];
    const SpacePoint z = field.surface().frame[at(middle.face)][2];
    const SpacePoint x = unit(direction_in_space(field.surface(), middle.face, field.at(middle)));
    PatternShape arrow{.shape = arrow_shape, .at = middle, .color = major_color};
    arrow.position = position_in_space(field.surface(), middle);
    arrow.axes = {x, cross(z, x), z};
    arrow.size = {arrow_length * spacing, arrow_width * spacing, arrow_height * spacing};
    return arrow;
}

PatternShape ball_on(const FieldOnSurface& field, int face, double spacing) {
    PatternShape ball{.shape = ball_shape, .at = {face, field.zero(face)}};
    ball.color = singular_color(field.n(), field.index(face));
    ball.position = position_in_space(field.surface(), ball.at);
    ball.axes = field.surface().frame[at(face)];
    ball.size = {ball_size * spacing, ball_size * spacing, ball_size * spacing};
    return ball;
}

Path circle(Point middle, double radius) {
    constexpr double bow = 4.0 / 3 * (std::numbers::sqrt2 - 1);  // of the cubic nearest to a quarter circle
    Path path{.start = middle + Point{radius, 0}, .closed = true};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const Complex from = polar(radius, quarter * pi / 2), to = Complex{0, 1} * from;
        path.segments.push_back(curve_to(middle + from + bow * to, middle + to + bow * from, middle + to));
    }
    return path;
}

Element painted(std::vector<Path> paths, Color color) {
    Element element{.paths = std::move(paths)};
    element.style.fill = color;
    return element;
}

}  // namespace

SurfacePattern field_pattern(const FieldOnSurface& field, const FieldPictureOptions& options, const Progress& progress) {
    if (!(options.spacing > 0)) throw InputError({field.field().label}, "expected a spacing of lines above 0");
    const SurfaceMesh& surface = field.surface();
    const double spacing = options.spacing * surface.diagonal;
    const Streamlines lines = streamlines(field, {.spacing = spacing, .minor = options.minor}, progress);
    SurfacePattern pattern{.shapes = shapes()};
    for (const Streamline& line : lines.lines) {
        pattern.lines.push_back(pattern_line(surface, line, line_width * spacing));
        if (field.n() == 1 && !line.minor && field.at(line.path[line.path.size() / 2]) != Complex{})
            pattern.placed.push_back(arrow_on(field, line, spacing));
    }
    if (options.points)
        for (const int face : field.singular_faces()) pattern.placed.push_back(ball_on(field, face, spacing));
    return pattern;
}

Scene field_scene(const SurfacePattern& pattern, const SurfaceMesh& surface) {
    Scene scene;
    for (const SpacePoint p : surface.mesh.positions) scene.viewport = including(scene.viewport, Point{p.x, p.y});
    for (const PatternLine& line : pattern.lines) {
        Path path{.start = {line.points.front().x, line.points.front().y}};
        for (const SpacePoint p : line.points) path.segments.push_back(line_to({p.x, p.y}));
        Element element{.paths = {std::move(path)}};
        element.style.fill = NoPaint{};
        element.style.stroke.paint = line.color;
        element.style.stroke.width = line.widths.front();
        element.style.stroke.join = LineJoin::round;
        element.style.stroke.cap = LineCap::round;
        scene.elements.push_back(std::move(element));
    }
    for (const PatternShape& shape : pattern.placed) {
        const Point middle{shape.position.x, shape.position.y};
        if (shape.shape == ball_shape) {
            scene.elements.push_back(painted({circle(middle, shape.size.x / 2)}, shape.color));
            continue;
        }
        const Point along = shape.size.x / 2 * Point{shape.axes[0].x, shape.axes[0].y};
        const Point aside = shape.size.y / 2 * Point{shape.axes[1].x, shape.axes[1].y};
        const Path tip{.start = middle + along,
                       .segments = {line_to(middle - along + aside), line_to(middle - along - aside)},
                       .closed = true};
        scene.elements.push_back(painted({tip}, shape.color));
    }
    return scene;
}

Color singular_color(int n, int index) {
    if (index == 1 && n > 1) return {244, 197, 36};
    if (index == -1 && n > 1) return {42, 106, 214};
    if (index > 0 && index <= n) return {208, 52, 44};
    if (index < 0 && index >= -n) return {126, 62, 160};
    return {30, 30, 30};
}

}  // namespace rinceau

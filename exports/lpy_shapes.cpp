#include "exports/lpy_shapes.h"

#include <algorithm>
#include <cmath>

#include "exports/drawn_terminal.h"
#include "exports/turtle_walk.h"
#include "lsystem/number_text.h"

namespace rinceau {

const std::string_view lpy_shapes_prelude =
    "from openalea.plantgl.all import BezierCurve, Group, Polyline\n"
    "\n"
    "def rinceau_lines(width, *curves):\n"
    "    for curve in curves: curve.width = width\n"
    "    return curves[0] if len(curves) == 1 else Group(list(curves))\n"
    "\n"
    "# The curves of the shapes: points (0, right, ahead); Bezier points have the weight 1.\n";

const std::string_view lpy_nothing = "f(0)";

namespace {

std::string point_text(Point point, bool weighted) {
    return "(0, " + number_text(point.x) + ", " + number_text(point.y) + (weighted ? ", 1)" : ")");
}

std::string polyline_text(const std::vector<Point>& corners) {
    std::string text;
    for (const Point corner : corners) text += (text.empty() ? "" : ", ") + point_text(corner, false);
    return ",\n    Polyline([" + text + "])";
}

/// Runs of straight segments are polylines, every curve is a Bezier curve.
std::string curves_text(const Path& path) {
    std::string text;
    std::vector<Point> corners{path.start};
    const auto end_run = [&] {
        if (corners.size() > 1) text += polyline_text(corners);
    };
    for (const Segment& segment : path.segments) {
        if (segment.straight) {
            if (segment.to != corners.back()) corners.push_back(segment.to);
            continue;
        }
        end_run();
        text += ",\n    BezierCurve([" + point_text(corners.back(), true) + ", " + point_text(segment.control1, true) +
                ", " + point_text(segment.control2, true) + ", " + point_text(segment.to, true) + "])";
        corners = {segment.to};
    }
    if (path.closed && corners.back() != path.start) corners.push_back(path.start);
    end_run();
    return text;
}

std::string turn_text(double turn) { return turn == 0 ? "" : (turn < 0 ? "-(" : "+(") + number_text(std::abs(turn)) + ") "; }

std::string polygon_text(const Polygon& polygon) {
    std::string text = "[ ";
    const std::vector<WalkStep> steps = walk_along(polygon);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        text += turn_text(steps[i].turn);
        if (steps[i].length > 0) text += "f(" + number_text(steps[i].length) + ") ";
        text += i == 0 ? "{ . " : ". ";
    }
    return text + "}(True) ] ";
}

std::string color_text(Color color) {
    return "SetColor(" + std::to_string(color.red) + ", " + std::to_string(color.green) + ", " + std::to_string(color.blue) +
           ") ";
}

}  // namespace

LpyShape lpy_shape(const Terminal& terminal, const Style& style, const std::string& name) {
    const DrawnTerminal drawn = drawn_terminal(terminal, style);
    LpyShape shape;
    std::string fill;
    std::string line;
    if (drawn.fill) {
        fill = color_text(*drawn.fill);
        for (const Polygon& polygon : drawn.polygons) fill += polygon_text(polygon);
    }
    if (drawn.line) {
        std::string curves;
        for (const Path& path : drawn.outlines) curves += curves_text(path);
        constexpr double widest = 255;  // PlantGL keeps a byte
        const int width = static_cast<int>(std::clamp(std::round(drawn.width), 1.0, widest));
        if (!curves.empty()) {
            shape.definition = name + " = rinceau_lines(" + std::to_string(width) + curves + ")\n";
            line = color_text(*drawn.line) + "@g(" + name + ") ";
        }
    }
    shape.drawing = drawn.line_first ? line + fill : fill + line;
    if (shape.drawing.empty()) shape.drawing = lpy_nothing;
    while (shape.drawing.back() == ' ') shape.drawing.pop_back();
    return shape;
}

}  // namespace rinceau

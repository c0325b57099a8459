#include "mesh_picture.h"

#include <algorithm>
#include <bitset>
#include <cmath>

namespace rinceau {
namespace {

constexpr int samples_across = 4;
constexpr int samples = samples_across * samples_across;
using Covered = std::vector<std::bitset<samples>>;

struct Canvas {
    int width = 0;
    int height = 0;
    Box box;
    double unit = 1;
    std::vector<double> rgb;

    Point sample(int x, int y, int index) const {
        const double u = (index % samples_across + 0.5) / samples_across;
        const double v = (index / samples_across + 0.5) / samples_across;
        return {box.low.x + unit * (x + u), box.high.y - unit * (y + v)};
    }
};

double signed_area_of(Point a, Point b, Point c) { return 0.5 * cross(b - a, c - a); }

Point corner(const DrawMesh& mesh, std::uint32_t index) {
    return {static_cast<double>(mesh.points[index].x), static_cast<double>(mesh.points[index].y)};
}

void cover(Covered& covered, const Canvas& canvas, Point a, Point b, Point c) {
    const Box box = including(including(including(Box{}, a), b), c);
    const int left = std::max(0, static_cast<int>(std::floor((box.low.x - canvas.box.low.x) / canvas.unit)));
    const int right = std::min(canvas.width - 1, static_cast<int>((box.high.x - canvas.box.low.x) / canvas.unit));
    const int top = std::max(0, static_cast<int>(std::floor((canvas.box.high.y - box.high.y) / canvas.unit)));
    const int bottom = std::min(canvas.height - 1, static_cast<int>((canvas.box.high.y - box.low.y) / canvas.unit));
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            for (int i = 0; i < samples; ++i) {
                const Point p = canvas.sample(x, y, i);
                const bool inside =
                    signed_area_of(a, b, p) >= 0 && signed_area_of(b, c, p) >= 0 && signed_area_of(c, a, p) >= 0;
                if (inside) covered[static_cast<std::size_t>(y * canvas.width + x)].set(static_cast<std::size_t>(i));
            }
        }
    }
}

void paint(Canvas& canvas, const DrawMesh& mesh, const std::vector<std::uint32_t>& triangles, const Paint& paint,
           double opacity) {
    const auto* color = std::get_if<Color>(&paint);
    if (color == nullptr) return;
    const double channels[] = {double(color->red), double(color->green), double(color->blue)};
    Covered covered(static_cast<std::size_t>(canvas.width * canvas.height));
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        cover(covered, canvas, corner(mesh, triangles[i]), corner(mesh, triangles[i + 1]), corner(mesh, triangles[i + 2]));
    for (std::size_t pixel = 0; pixel < covered.size(); ++pixel) {
        const double share = opacity * static_cast<double>(covered[pixel].count()) / samples;
        for (std::size_t c = 0; c < 3; ++c) {
            double& level = canvas.rgb[3 * pixel + c];
            level += share * (channels[c] - level);
        }
    }
}

}  // namespace

Picture mesh_picture(const Scene& scene, double unit, double deviation) {
    constexpr double white = 255;
    Canvas canvas;
    canvas.box = scene.viewport;
    canvas.unit = unit;
    canvas.width = static_cast<int>(std::ceil(width(canvas.box) / unit));
    canvas.height = static_cast<int>(std::ceil(height(canvas.box) / unit));
    canvas.rgb.assign(static_cast<std::size_t>(3 * canvas.width * canvas.height), white);
    for (const Element& element : scene.elements) {
        const DrawMesh mesh = tessellated(element.paths, element.style, {.deviation = deviation});
        paint(canvas, mesh, mesh.fill, element.style.fill, element.style.fill_opacity * element.style.opacity);
        paint(canvas, mesh, mesh.stroke, element.style.stroke.paint, element.style.stroke.opacity * element.style.opacity);
    }
    Picture picture{canvas.width, canvas.height, {}};
    for (const double level : canvas.rgb) picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(level)));
    return picture;
}

double mesh_area(const DrawMesh& mesh, const std::vector<std::uint32_t>& triangles) {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        sum += std::abs(
            signed_area_of(corner(mesh, triangles[i]), corner(mesh, triangles[i + 1]), corner(mesh, triangles[i + 2])));
    return sum;
}

double smallest_triangle(const DrawMesh& mesh, const std::vector<std::uint32_t>& triangles) {
    double smallest = 0;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        smallest = std::min(smallest, signed_area_of(corner(mesh, triangles[i]), corner(mesh, triangles[i + 1]),
                                                     corner(mesh, triangles[i + 2])));
    return smallest;
}

}  // namespace rinceau

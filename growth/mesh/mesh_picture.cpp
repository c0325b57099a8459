// A depth buffer with 2 x 2 samples a pixel; triangles are walked by their edge functions.

#include "growth/mesh/mesh_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/angle.h"
#include "geometry/box.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr int samples = 2;  // a pixel, each way
constexpr double crease = 40 * pi / 180;
constexpr double border = 0.03;  // white around, a share of the width

/// Right, up and towards the eye.
struct EyeFrame {
    SpacePoint right, up, towards;

    SpacePoint seen(SpacePoint p) const { return {dot(right, p), dot(up, p), dot(towards, p)}; }
};

EyeFrame eye_frame(UpAxis up_axis, double elevation) {
    const double s = std::sin(elevation), c = std::cos(elevation);
    if (up_axis == UpAxis::y) return {{1, 0, 0}, {0, c, -s}, {0, s, c}};
    return {{1, 0, 0}, {0, s, c}, {0, -c, s}};
}

/// A triangle as it is seen, in samples; z towards the eye.
struct SeenTriangle {
    std::array<SpacePoint, 3> corners;
    std::array<SpacePoint, 3> normals;
    Color color;
};

struct Canvas {
    int width = 0, height = 0;  ///< samples
    std::vector<double> depth;
    std::vector<std::array<float, 3>> light;  ///< colour, 0 to 255
};

double edge(SpacePoint a, SpacePoint b, double x, double y) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); }

std::array<float, 3> shaded(Color color, SpacePoint normal) {
    const SpacePoint lamp = unit({-0.5, 0.65, 0.8}), fill = unit({0.8, -0.2, 0.5});
    const SpacePoint n = unit(normal.z < 0 ? -1.0 * normal : normal);  // sheets are seen from both sides
    const double lit = 0.35 + 0.6 * std::max(0.0, dot(n, lamp)) + 0.15 * std::max(0.0, dot(n, fill));
    const auto channel = [lit](std::uint8_t value) { return static_cast<float>(std::min(255.0, lit * value)); };
    return {channel(color.red), channel(color.green), channel(color.blue)};
}

void draw(const SeenTriangle& triangle, Canvas& canvas) {
    const auto& [a, b, c] = triangle.corners;
    const double doubled = edge(a, b, c.x, c.y);
    if (doubled == 0) return;
    const auto clamped = [](double value, int most) { return static_cast<int>(std::clamp(value, 0.0, double(most))); };
    const int left = clamped(std::floor(std::min({a.x, b.x, c.x})), canvas.width);
    const int right = clamped(std::ceil(std::max({a.x, b.x, c.x})), canvas.width);
    const int top = clamped(std::floor(std::min({a.y, b.y, c.y})), canvas.height);
    const int bottom = clamped(std::ceil(std::max({a.y, b.y, c.y})), canvas.height);
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) {
            const double x = column + 0.5, y = row + 0.5;
            const double u = edge(b, c, x, y) / doubled, v = edge(c, a, x, y) / doubled, w = 1 - u - v;
            if (u < 0 || v < 0 || w < 0) continue;
            const double z = u * a.z + v * b.z + w * c.z;
            const std::size_t i =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(canvas.width) + static_cast<std::size_t>(column);
            if (z <= canvas.depth[i]) continue;
            canvas.depth[i] = z;
            canvas.light[i] =
                shaded(triangle.color, u * triangle.normals[0] + v * triangle.normals[1] + w * triangle.normals[2]);
        }
}

/// Calls `visit` with every triangle of the assembly in the eye's frame.
template <class Visit>
void for_each_seen(const MeshAssembly& assembly, const EyeFrame& eye, const Visit& visit) {
    std::vector<std::vector<std::array<SpacePoint, 3>>> normals;
    for (const NamedMesh& named : assembly.meshes) normals.push_back(corner_normals(named.mesh, crease));
    for (const MeshInstance& instance : assembly.instances) {
        const auto which = static_cast<std::size_t>(instance.mesh);
        const NamedMesh& named = assembly.meshes[which];
        const MeshPose turn{.rotation = instance.pose.rotation};
        for (std::size_t t = 0; t < named.mesh.triangles.size(); ++t) {
            SeenTriangle seen{.color = named.color};
            for (std::size_t k = 0; k < 3; ++k) {
                const SpacePoint p = named.mesh.positions[static_cast<std::size_t>(named.mesh.triangles[t][k])];
                seen.corners[k] = eye.seen(apply(instance.pose, p));
                seen.normals[k] = eye.seen(apply(turn, normals[which][t][k]));
            }
            visit(seen);
        }
    }
}

/// Samples to pixels, over white.
Picture averaged(const Canvas& canvas) {
    Picture picture{canvas.width / samples, canvas.height / samples, {}};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                double sum = 0;
                for (int i = 0; i < samples * samples; ++i) {
                    const int y = samples * row + i / samples, x = samples * column + i % samples;
                    sum += static_cast<double>(
                        canvas.light[static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width) +
                                     static_cast<std::size_t>(x)][channel]);
                }
                picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(sum / (samples * samples))));
            }
    return picture;
}

}  // namespace

Picture mesh_picture(const MeshAssembly& assembly, UpAxis up, const MeshView& view) {
    const EyeFrame eye = eye_frame(up, view.elevation);
    Box box;
    for_each_seen(assembly, eye, [&](const SeenTriangle& seen) {
        for (const SpacePoint p : seen.corners) box = including(box, Point{p.x, p.y});
    });
    box = grown(box, border * std::max(width(box), height(box)));
    const double scale = samples * view.width / width(box);
    const double rows = std::max(1.0, std::round(view.width * height(box) / width(box)));
    constexpr double most_pixels = 64e6;
    if (rows * view.width > most_pixels)
        throw LimitError({}, "the picture has more than 64 million pixels; make it smaller");

    Canvas canvas{samples * view.width, samples * static_cast<int>(rows), {}, {}};
    const std::size_t count = static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height);
    canvas.depth.assign(count, -std::numeric_limits<double>::infinity());
    canvas.light.assign(count, {255, 255, 255});
    for_each_seen(assembly, eye, [&](SeenTriangle seen) {
        for (SpacePoint& p : seen.corners) p = {scale * (p.x - box.low.x), scale * (box.high.y - p.y), p.z};
        draw(seen, canvas);
    });
    return averaged(canvas);
}

}  // namespace rinceau

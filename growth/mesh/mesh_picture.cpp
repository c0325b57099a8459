// A depth buffer with 2 x 2 samples a pixel; triangles are walked by their edge functions. Many of millions of triangles lie
// between the samples: whatever only a sample needs is made when one is hit.

#include "growth/mesh/mesh_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/box.h"
#include "growth/mesh/depth_occlusion.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr int samples = 2;          // a pixel, each way
constexpr double border = 0.03;     // white around, a share of the width
constexpr double sky_reach = 0.03;  // how far hiding things are looked for, a share of the width

/// Right, up and towards the eye.
struct EyeFrame {
    SpacePoint right, up, towards;

    SpacePoint seen(SpacePoint p) const { return {dot(right, p), dot(up, p), dot(towards, p)}; }
};

EyeFrame eye_frame(UpAxis up_axis, const MeshView& view) {
    const double s = std::sin(view.elevation), c = std::cos(view.elevation);
    EyeFrame eye =
        up_axis == UpAxis::y ? EyeFrame{{1, 0, 0}, {0, c, -s}, {0, s, c}} : EyeFrame{{1, 0, 0}, {0, s, c}, {0, -c, s}};
    if (view.turn == 0) return eye;
    const SpacePoint axis = up_axis == UpAxis::y ? SpacePoint{0, 1, 0} : SpacePoint{0, 0, 1};
    const MeshPose round{.rotation = rotation_about(axis, view.turn)};
    for (SpacePoint* vector : {&eye.right, &eye.up, &eye.towards}) *vector = apply(round, *vector);
    return eye;
}

struct Canvas {
    int width = 0, height = 0;  ///< samples
    std::vector<double> depth;
    std::vector<std::array<float, 3>> light;    ///< colour, 0 to 255
    std::vector<std::array<float, 3>> normals;  ///< of what is seen; empty = not asked for
    double occlusion = 0;
};

double edge(SpacePoint a, SpacePoint b, double x, double y) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); }

/// Sheets are seen from both sides.
SpacePoint towards_eye(SpacePoint normal) { return unit(normal.z < 0 ? -1.0 * normal : normal); }

/// `occlusion` is taken off afterwards: then more light comes from all around, and from the second lamp.
std::array<float, 3> shaded(Color color, SpacePoint n, double occlusion) {
    const SpacePoint lamp = unit({-0.5, 0.65, 0.8}), fill = unit({0.8, -0.2, 0.5});
    const double around = 0.35 + 0.08 * occlusion, second = 0.15 + 0.15 * occlusion;
    const double lit = around + 0.6 * std::max(0.0, dot(n, lamp)) + second * std::max(0.0, dot(n, fill));
    const auto channel = [lit](std::uint8_t value) { return static_cast<float>(std::min(255.0, lit * value)); };
    return {channel(color.red), channel(color.green), channel(color.blue)};
}

/// Draws a triangle, in samples, z towards the eye. `normals` gives those of its corners, and is called if one is needed.
template <class Normals>
void draw(const std::array<SpacePoint, 3>& corners, Color color, const Normals& normals, Canvas& canvas) {
    const auto& [a, b, c] = corners;
    const double doubled = edge(a, b, c.x, c.y);
    if (doubled == 0) return;
    const auto clamped = [](double value, int most) { return static_cast<int>(std::clamp(value, 0.0, double(most))); };
    const int left = clamped(std::floor(std::min({a.x, b.x, c.x})), canvas.width);
    const int right = clamped(std::ceil(std::max({a.x, b.x, c.x})), canvas.width);
    const int top = clamped(std::floor(std::min({a.y, b.y, c.y})), canvas.height);
    const int bottom = clamped(std::ceil(std::max({a.y, b.y, c.y})), canvas.height);
    std::optional<std::array<SpacePoint, 3>> known;
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) {
            const double x = column + 0.5, y = row + 0.5;
            const double u = edge(b, c, x, y) / doubled, v = edge(c, a, x, y) / doubled, w = 1 - u - v;
            if (u < 0 || v < 0 || w < 0) continue;
            const double z = u * a.z + v * b.z + w * c.z;
            const std::size_t i =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(canvas.width) + static_cast<std::size_t>(column);
            if (z <= canvas.depth[i]) continue;
            if (!known) known = normals();
            const SpacePoint n = towards_eye(u * (*known)[0] + v * (*known)[1] + w * (*known)[2]);
            canvas.depth[i] = z;
            canvas.light[i] = shaded(color, n, canvas.occlusion);
            if (!canvas.normals.empty())
                canvas.normals[i] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
        }
}

/// The assembly before the eye.
class SeenAssembly {
  public:
    SeenAssembly(const MeshAssembly& assembly, const EyeFrame& eye, double crease) : assembly_(assembly), eye_(eye) {
        for (const NamedMesh& named : assembly.meshes) {
            normals_.push_back(corner_normals(named, crease));
            used_.emplace_back(named.mesh.positions.size(), 0);
            for (const auto& triangle : named.mesh.triangles)
                for (const int v : triangle) used_.back()[static_cast<std::size_t>(v)] = 1;
        }
    }

    Box box() const {
        Box box;
        for (const MeshInstance& instance : assembly_.instances) {
            const auto which = static_cast<std::size_t>(instance.mesh);
            const std::vector<SpacePoint>& positions = assembly_.meshes[which].mesh.positions;
            for (std::size_t v = 0; v < positions.size(); ++v) {
                if (used_[which][v] == 0) continue;
                const SpacePoint p = eye_.seen(apply(instance.pose, positions[v]));
                box = including(box, Point{p.x, p.y});
            }
        }
        return box;
    }

    /// `low_x` and `high_y` of what is seen lie at the canvas's upper left corner.
    void draw_on(Canvas& canvas, double scale, Point corner) const {
        std::vector<SpacePoint> seen;
        for (const MeshInstance& instance : assembly_.instances) {
            const auto which = static_cast<std::size_t>(instance.mesh);
            const NamedMesh& named = assembly_.meshes[which];
            seen.clear();
            for (const SpacePoint position : named.mesh.positions) {
                const SpacePoint p = eye_.seen(apply(instance.pose, position));
                seen.push_back({scale * (p.x - corner.x), scale * (corner.y - p.y), p.z});
            }
            for (std::size_t t = 0; t < named.mesh.triangles.size(); ++t) {
                const auto& [a, b, c] = named.mesh.triangles[t];
                const auto at = [&](int v) { return seen[static_cast<std::size_t>(v)]; };
                draw(
                    {at(a), at(b), at(c)}, named.color, [&] { return seen_normals(instance, t); }, canvas);
            }
        }
    }

  private:
    const MeshAssembly& assembly_;
    const EyeFrame& eye_;
    std::vector<std::vector<std::array<SpacePoint, 3>>> normals_;  ///< by mesh and triangle
    std::vector<std::vector<char>> used_;                          ///< by mesh and position: is it in a triangle?

    std::array<SpacePoint, 3> seen_normals(const MeshInstance& instance, std::size_t triangle) const {
        const SpacePoint s = instance.pose.scale;
        const bool even = s.x == s.y && s.y == s.z && s.x > 0;
        const MeshPose turn{.rotation = instance.pose.rotation};
        std::array<SpacePoint, 3> normals = normals_[static_cast<std::size_t>(instance.mesh)][triangle];
        for (SpacePoint& n : normals) n = eye_.seen(even ? apply(turn, n) : apply_to_normal(instance.pose, n));
        return normals;
    }
};

/// Darkens what sees little of the sky. `scale`: samples a unit of depth.
void occlude(Canvas& canvas, double scale, const MeshView& view) {
    DepthImage image{canvas.width, canvas.height, std::move(canvas.depth), std::move(canvas.normals)};
    for (double& depth : image.depth) depth *= scale;
    const std::vector<float> sky = open_sky(image, sky_reach * canvas.width);
    const auto strength = static_cast<float>(view.occlusion);
    for (std::size_t i = 0; i < sky.size(); ++i)
        for (float& channel : canvas.light[i]) channel *= 1 - strength * (1 - sky[i]);
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

/// What the picture shows: all, with a border, widened to the picture's proportions if those are given.
Box shown_box(const Box& seen, const MeshView& view) {
    Box box = grown(seen, border * std::max(width(seen), height(seen)));
    if (view.height <= 0) return box;
    const double wide = std::max(width(box), height(box) * view.width / view.height), high = wide * view.height / view.width;
    const Point half = 0.5 * Point{wide, high};
    return {center(box) - half, center(box) + half};
}

}  // namespace

Picture mesh_picture(const MeshAssembly& assembly, UpAxis up, const MeshView& view) {
    const EyeFrame eye = eye_frame(up, view);
    const SeenAssembly seen(assembly, eye, view.crease);
    const Box box = shown_box(seen.box(), view);
    const double scale = samples * view.width / width(box);
    const double rows = view.height > 0 ? view.height : std::max(1.0, std::round(view.width * height(box) / width(box)));
    constexpr double most_pixels = 64e6;
    if (rows * view.width > most_pixels)
        throw LimitError({}, "the picture has more than 64 million pixels; make it smaller");

    Canvas canvas{samples * view.width, samples * static_cast<int>(rows), {}, {}, {}, view.occlusion};
    const std::size_t count = static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height);
    canvas.depth.assign(count, -std::numeric_limits<double>::infinity());
    canvas.light.assign(count, {255, 255, 255});
    if (view.occlusion > 0) canvas.normals.resize(count);
    seen.draw_on(canvas, scale, {box.low.x, box.high.y});
    if (view.occlusion > 0) occlude(canvas, scale, view);
    return averaged(canvas);
}

}  // namespace rinceau

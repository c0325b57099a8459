#include "editor/gl/shape_store.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "editor/mesh/draw_mesh.h"
#include "geometry/parallel.h"

namespace rinceau {
namespace {

constexpr double pixel_deviation = 0.25;    // of a mesh from its curves, at the largest scale that it is used for
constexpr double buckets_an_octave = 4096;  // of the scales of fixed strokes
constexpr std::size_t many_shapes = 4096;
constexpr std::uint64_t tables_kept = 4;

/// Mixes words one after the other (multiply and rotate, constants of SplitMix64).
class Hash {
  public:
    void add(std::uint64_t word) {
        value_ = (std::rotl(value_, 27) ^ word) * 0x9E3779B97F4A7C15U;
        value_ ^= value_ >> 31U;
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(Point p) {
        add(p.x);
        add(p.y);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0x94D049BB133111EBU;
};

void add_paths(Hash& hash, const std::vector<Path>& paths) {
    for (const Path& path : paths) {
        hash.add(path.start);
        hash.add(2 * path.segments.size() + (path.closed ? 1 : 0));
        for (const Segment& segment : path.segments) {
            hash.add(segment.to);
            if (segment.straight) continue;
            hash.add(segment.control1);
            hash.add(segment.control2);
        }
    }
}

std::uint64_t shape_hash(const std::vector<Path>& paths, const Style& style, ShapeOrder order) {
    Hash hash;
    add_paths(hash, paths);
    hash.add(static_cast<std::uint64_t>(style.fill_rule) * 2 + static_cast<std::uint64_t>(order));
    hash.add(paints_fill(style) ? 1.0 : 0.0);
    hash.add(paints_stroke(style) ? style.stroke.width : 0.0);
    return hash.value();
}

bool same_stroke(const Stroke& a, const Stroke& b) {
    return a.width == b.width && a.fixed == b.fixed && a.cap == b.cap && a.join == b.join &&
           a.miter_limit == b.miter_limit && a.dashes == b.dashes && a.dash_offset == b.dash_offset && a.pen == b.pen;
}

bool same_shape(const Shape& shape, const std::vector<Path>& paths, const Style& style, ShapeOrder order) {
    if (shape.order != order || paints_fill(shape.style) != paints_fill(style)) return false;
    if (paints_stroke(shape.style) != paints_stroke(style)) return false;
    if (paints_fill(style) && shape.style.fill_rule != style.fill_rule) return false;
    if (shape.style.stroke_first != style.stroke_first) return false;
    if (paints_stroke(style) && !same_stroke(shape.style.stroke, style.stroke)) return false;
    return shape.paths == paths;
}

/// How far the stroke reaches from its line, mitres included.
double stroke_reach(const Style& style) {
    if (!paints_stroke(style)) return 0;
    const Stroke& stroke = style.stroke;
    const double pen = std::max(std::hypot(stroke.pen.a, stroke.pen.b), std::hypot(stroke.pen.c, stroke.pen.d));
    const double square_corner = std::sqrt(2.0);
    const double miter = stroke.join == LineJoin::miter ? stroke.miter_limit : 1;
    return 0.5 * stroke.width * std::max(1.0, pen) * std::max(square_corner, miter);
}

Shape new_shape(const std::vector<Path>& paths, const Style& style, ShapeOrder order) {
    Shape shape;
    shape.paths = paths;
    shape.style = style;
    shape.order = order;
    const Box box = bounds(paths);
    if (!is_empty(box)) {
        shape.origin = center(box);
        shape.radius = 0.5 * diagonal(box);
    }
    const double reach = stroke_reach(style);
    (style.stroke.fixed ? shape.fixed_margin : shape.radius) += reach;
    return shape;
}

/// Appends a part's triangles, with vertices of its own.
void append_part(ShapeMesh& mesh, const DrawMesh& drawn, LookPart part, std::vector<std::uint32_t>& renumbered) {
    constexpr std::uint32_t unseen = ~0U;
    renumbered.assign(drawn.points.size(), unseen);
    for (const std::uint32_t index : part == LookPart::fill ? drawn.fill : drawn.stroke) {
        std::uint32_t& number = renumbered[index];
        if (number == unseen) {
            number = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back({drawn.points[index].x, drawn.points[index].y, static_cast<float>(part)});
        }
        mesh.indices.push_back(number);
    }
}

ShapeMesh made_mesh(const Shape& shape, const MeshLevel& level) {
    const double scale = std::ldexp(1.0, level.level);
    const double stroke_scale = shape.style.stroke.fixed ? bucket_scale(level.stroke_bucket) : 1;
    const DrawMesh drawn = tessellated(transformed(shape.paths, translate(-shape.origin)), shape.style,
                                       {.deviation = pixel_deviation / scale, .stroke_scale = stroke_scale});
    const LookPart upper = shape.style.stroke_first ? LookPart::fill : LookPart::stroke;
    const LookPart lower = shape.style.stroke_first ? LookPart::stroke : LookPart::fill;
    const bool upper_first = shape.order == ShapeOrder::upper_first;
    ShapeMesh mesh;
    std::vector<std::uint32_t> renumbered;
    append_part(mesh, drawn, upper_first ? upper : lower, renumbered);
    append_part(mesh, drawn, upper_first ? lower : upper, renumbered);
    return mesh;
}

}  // namespace

int stroke_bucket(double scale) { return static_cast<int>(std::lround(buckets_an_octave * std::log2(scale))); }
double bucket_scale(int bucket) { return std::exp2(bucket / buckets_an_octave); }

std::shared_ptr<Shape> ShapeStore::shape(const std::vector<Path>& paths, const Style& style, const LookPaint& paint) {
    const bool both = paint.part(LookPart::fill).painted && paint.part(LookPart::stroke).painted;
    const ShapeOrder order = both && !paint.part(paint.upper).opaque ? ShapeOrder::lower_first : ShapeOrder::upper_first;
    const std::uint64_t hash = shape_hash(paths, style, order);
    const auto [first, last] = shapes_.equal_range(hash);
    auto found =
        std::find_if(first, last, [&](const auto& entry) { return same_shape(*entry.second, paths, style, order); });
    if (found == last) found = shapes_.emplace(hash, std::make_shared<Shape>(new_shape(paths, style, order)));
    found->second->last_use = now_;
    return found->second;
}

std::shared_ptr<const std::string> ShapeStore::text(const std::string& text) {
    const std::size_t hash = std::hash<std::string>{}(text);
    const auto [first, last] = texts_.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (*known->second == text) return known->second;
    return texts_.emplace(hash, std::make_shared<const std::string>(text))->second;
}

void ShapeStore::make_meshes(const std::vector<std::pair<std::shared_ptr<Shape>, MeshLevel>>& wanted,
                             std::chrono::steady_clock::time_point deadline) {
    std::vector<std::shared_ptr<const ShapeMesh>> made(wanted.size());
    for_each_index(wanted.size(), 0, [&](std::size_t k) {
        const bool first = k == 0;  // so that there is some progress, whatever the time
        if (!first && std::chrono::steady_clock::now() > deadline) return;
        made[k] = std::make_shared<const ShapeMesh>(made_mesh(*wanted[k].first, wanted[k].second));
    });
    for (std::size_t k = 0; k < wanted.size(); ++k)
        if (made[k]) wanted[k].first->meshes[wanted[k].second] = made[k];
}

void ShapeStore::forget_unused() {
    ++now_;
    std::erase_if(texts_, [](const auto& entry) { return entry.second.use_count() == 1; });
    if (shapes_.size() < many_shapes) return;
    std::erase_if(shapes_, [&](const auto& entry) { return entry.second->last_use + tables_kept < now_; });
}

std::shared_ptr<const ShapeMesh> nearest_mesh(const Shape& shape, const MeshLevel& level) {
    std::shared_ptr<const ShapeMesh> nearest;
    int least = 0;
    for (const auto& [known, mesh] : shape.meshes) {
        if (known.stroke_bucket != level.stroke_bucket) continue;
        const int distance = std::abs(known.level - level.level);
        if (nearest && distance >= least) continue;
        nearest = mesh;
        least = distance;
    }
    return nearest;
}

}  // namespace rinceau

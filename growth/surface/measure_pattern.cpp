// Overlaps are found by a sweep along the x axis over spheres about the bodies, not by the hash grid that placing uses; the
// narrow test is the same (bodies_overlap.h; its agreement with Bullet is a test of its own).
#include "growth/surface/measure_pattern.h"

#include <algorithm>
#include <cmath>

#include "growth/surface/bodies_overlap.h"

namespace rinceau {

namespace {

double outside_of_face(const SurfaceMesh& surface, SurfacePoint p) {
    double deepest = 0;
    for (const double weight : barycentric(surface, p)) deepest = std::min(deepest, weight);
    return -deepest * surface.longest_edge;
}

double distance_from_surface(const SurfacePattern& pattern, const SurfaceMesh& surface) {
    double worst = 0;
    for (const PatternShape& shape : pattern.placed) {
        const SpacePoint normal = normal_at(surface, shape.at);
        const SpacePoint offset = shape.position - position_in_space(surface, shape.at);
        const SpacePoint aside = offset - dot(offset, normal) * normal;
        worst = std::max({worst, abs(aside), outside_of_face(surface, shape.at)});
    }
    for (const PatternLine& line : pattern.lines)
        for (std::size_t i = 0; i < line.points.size(); ++i)
            worst = std::max(
                {worst, abs(line.points[i] - position_in_space(surface, line.at[i])), outside_of_face(surface, line.at[i])});
    return surface.diagonal > 0 ? worst / surface.diagonal : worst;
}

bool is_ancestor(const SurfacePattern& pattern, int ancestor, int of, int generations) {
    int at = pattern.placed[static_cast<std::size_t>(of)].parent;
    for (int i = 0; i < generations && at >= 0; ++i) {
        if (at == ancestor) return true;
        at = pattern.placed[static_cast<std::size_t>(at)].parent;
    }
    return false;
}

struct SweptBody {
    CollisionBody body;
    double radius = 0;
    int shape = 0;
};

std::vector<SweptBody> bodies_by_x(const SurfacePattern& pattern, const SurfaceMesh& surface) {
    std::vector<SweptBody> bodies;
    for (std::size_t i = 0; i < pattern.placed.size(); ++i) {
        const PatternShape& shape = pattern.placed[i];
        const SpacePoint normal = normal_at(surface, shape.at);
        const double lift = dot(shape.position - position_in_space(surface, shape.at), normal);
        SweptBody one{.body = collision_body(pattern.shapes[static_cast<std::size_t>(shape.shape)], shape.position,
                                             shape.axes, shape.size, normal, lift),
                      .shape = static_cast<int>(i)};
        one.radius = radius_of(one.body);
        bodies.push_back(one);
    }
    std::stable_sort(bodies.begin(), bodies.end(), [](const SweptBody& a, const SweptBody& b) {
        return a.body.centre.x - a.radius < b.body.centre.x - b.radius;
    });
    return bodies;
}

class OverlapCount {
  public:
    OverlapCount(const SurfacePattern& pattern, const PatternMeasureOptions& options)
        : pattern_(&pattern), options_(&options) {}

    bool is_overlap(const SweptBody& a, const SweptBody& b) const {
        const int first = std::min(a.shape, b.shape), later = std::max(a.shape, b.shape);
        const PatternShape& one = pattern_->placed[static_cast<std::size_t>(first)];
        const PatternShape& other = pattern_->placed[static_cast<std::size_t>(later)];
        if (!other.tested || (one.set >= 0 && one.set == other.set)) return false;
        double shrink = 1 - options_->touch - options_->dead_band;
        if (is_ancestor(*pattern_, first, later, options_->kin)) shrink /= 2;
        return bodies_overlap(a.body, b.body, shrink, shrink);
    }

  private:
    const SurfacePattern* pattern_;
    const PatternMeasureOptions* options_;
};

bool spheres_meet(const SweptBody& a, const SweptBody& b) {
    const SpacePoint apart = a.body.centre - b.body.centre;
    return dot(apart, apart) < (a.radius + b.radius) * (a.radius + b.radius);
}

void count_overlaps(const SurfacePattern& pattern, const SurfaceMesh& surface, const PatternMeasureOptions& options,
                    PatternMeasures& result) {
    const std::vector<SweptBody> bodies = bodies_by_x(pattern, surface);
    const OverlapCount count(pattern, options);
    std::vector<std::size_t> open;  // bodies whose spheres reach beyond the sweep
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const double sweep = bodies[i].body.centre.x - bodies[i].radius;
        std::erase_if(open, [&](std::size_t j) { return bodies[j].body.centre.x + bodies[j].radius <= sweep; });
        for (const std::size_t j : open) {
            if (!spheres_meet(bodies[i], bodies[j])) continue;
            if (++result.pairs > options.max_pairs) {
                result.complete = false;
                return;
            }
            result.overlaps += count.is_overlap(bodies[i], bodies[j]) ? 1 : 0;
        }
        open.push_back(i);
    }
}

}  // namespace

PatternMeasures measure_pattern(const SurfacePattern& pattern, const SurfaceMesh& surface,
                                const PatternMeasureOptions& options) {
    PatternMeasures result;
    result.surface_distance_max = distance_from_surface(pattern, surface);
    count_overlaps(pattern, surface, options, result);
    return result;
}

}  // namespace rinceau

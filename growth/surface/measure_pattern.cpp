// Overlaps are found by a sweep along the x axis over spheres about the shapes, not by the hash grid that placing uses, and
// by their meshes (solids_overlap.h), not by the bodies that stand for them then.
#include "growth/surface/measure_pattern.h"

#include <algorithm>
#include <cmath>

#include "growth/surface/solids_overlap.h"

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

struct SweptSolid {
    PlacedSolid solid;
    SpacePoint centre, normal;  ///< normal: of the surface
    double radius = 0;
    int shape = 0;
};

std::vector<SweptSolid> solids_by_x(const SurfacePattern& pattern, const SurfaceMesh& surface) {
    std::vector<SweptSolid> solids;
    for (std::size_t i = 0; i < pattern.placed.size(); ++i) {
        const PatternShape& shape = pattern.placed[i];
        SweptSolid one{
            .solid = {&pattern.shapes[static_cast<std::size_t>(shape.shape)], shape.position, shape.axes, shape.size},
            .normal = normal_at(surface, shape.at),
            .shape = static_cast<int>(i)};
        one.centre = centre_of(one.solid);
        one.radius = radius_of(one.solid);
        solids.push_back(one);
    }
    std::stable_sort(solids.begin(), solids.end(),
                     [](const SweptSolid& a, const SweptSolid& b) { return a.centre.x - a.radius < b.centre.x - b.radius; });
    return solids;
}

class OverlapCount {
  public:
    OverlapCount(const SurfacePattern& pattern, const PatternMeasureOptions& options)
        : pattern_(&pattern), options_(&options) {}

    void look_at(const SweptSolid& a, const SweptSolid& b, PatternMeasures& result) const {
        const int first = std::min(a.shape, b.shape), later = std::max(a.shape, b.shape);
        const PatternShape& one = pattern_->placed[static_cast<std::size_t>(first)];
        const PatternShape& other = pattern_->placed[static_cast<std::size_t>(later)];
        if (!other.tested || (one.set >= 0 && one.set == other.set)) return;
        const double shrink = 1 - options_->touch - options_->dead_band;
        if (!solids_overlap(a.solid, b.solid, shrink)) return;
        constexpr double opposed = -0.3;  // cosine of the normals on both faces of a thin sheet
        if (dot(a.normal, b.normal) < opposed) {
            ++result.through_sheet;
        } else if (!(one.set >= 0 && other.set >= 0) && is_ancestor(*pattern_, first, later, options_->kin)) {
            const bool deep = solids_overlap(a.solid, b.solid, shrink / 2);
            ++(deep ? result.overlaps : result.kin_touching);
        } else {
            ++result.overlaps;
        }
    }

  private:
    const SurfacePattern* pattern_;
    const PatternMeasureOptions* options_;
};

bool spheres_meet(const SweptSolid& a, const SweptSolid& b) {
    const SpacePoint apart = a.centre - b.centre;
    return dot(apart, apart) < (a.radius + b.radius) * (a.radius + b.radius);
}

void count_overlaps(const SurfacePattern& pattern, const SurfaceMesh& surface, const PatternMeasureOptions& options,
                    PatternMeasures& result) {
    const std::vector<SweptSolid> solids = solids_by_x(pattern, surface);
    const OverlapCount count(pattern, options);
    std::vector<std::size_t> open;  // solids whose spheres reach beyond the sweep
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const double sweep = solids[i].centre.x - solids[i].radius;
        std::erase_if(open, [&](std::size_t j) { return solids[j].centre.x + solids[j].radius <= sweep; });
        for (const std::size_t j : open) {
            if (!spheres_meet(solids[i], solids[j])) continue;
            if (++result.pairs > options.max_pairs) {
                result.complete = false;
                return;
            }
            count.look_at(solids[i], solids[j], result);
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

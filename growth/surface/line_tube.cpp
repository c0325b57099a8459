// A ring stands across the line; its first corner lies along the surface's normal, so that no ring is turned against the
// next one. At a sharp turn rings about one point turn with the line: outside they make it round, inside they lie in the
// body.

#include "growth/surface/line_tube.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace rinceau {
namespace {

constexpr double sharpest_mitre = pi / 6;  // a mitre adds up to 4 % to the width there
constexpr int cap_rings = 2;               // of a half sphere, besides its base and its tip

/// A point where the line bends or ends; neighbours differ.
struct LinePoint {
    SpacePoint at, normal;
    double radius = 0;
};

std::vector<LinePoint> points_of(const PatternLine& line) {
    constexpr double thinnest = 1e-3;  // of the widest: a line that runs out still has corners
    const double widest = line.widths.empty() ? 0 : *std::ranges::max_element(line.widths);
    std::vector<LinePoint> points;
    for (std::size_t i = 0; i < line.points.size() && widest > 0; ++i) {
        if (!points.empty() && line.points[i] == points.back().at) continue;
        points.push_back({line.points[i], line.normals[i], std::max(line.widths[i], thinnest * widest) / 2});
    }
    return points;
}

/// `v` without its part along `axis` (of length 1), of length 1; `otherwise` if nothing is left.
SpacePoint across(SpacePoint v, SpacePoint axis, SpacePoint otherwise) {
    const SpacePoint rest = v - dot(v, axis) * axis;
    constexpr double smallest = 1e-6;  // of the sine of the angle between both
    return abs(rest) > smallest * abs(v) ? unit(rest) : otherwise;
}

SpacePoint any_across(SpacePoint axis) {
    return unit(std::abs(axis.x) < std::abs(axis.y) ? cross(axis, {1, 0, 0}) : cross(axis, {0, 1, 0}));
}

class TubeMaker {
  public:
    TubeMaker(const PatternLine& line, int sides) : points_(points_of(line)), merged_(line.merged), sides_(sides) {
        result_.color = line.color;
    }

    NamedMesh make() {
        if (points_.size() < 2) return std::move(result_);
        up_ = any_across(direction(0));
        begin();
        for (std::size_t i = 1; i + 1 < points_.size(); ++i) bend(points_[i], direction(i - 1), direction(i));
        end();
        return std::move(result_);
    }

  private:
    std::vector<LinePoint> points_;
    bool merged_ = false;
    int sides_ = 3;
    SpacePoint up_;          ///< of the last ring
    std::vector<int> ring_;  ///< the last ring's vertices; a tip stands for all of them
    NamedMesh result_;

    SpacePoint direction(std::size_t piece) const { return unit(points_[piece + 1].at - points_[piece].at); }

    int add_vertex(SpacePoint p, SpacePoint normal) {
        result_.mesh.positions.push_back(p);
        result_.normals.push_back(normal);
        return static_cast<int>(result_.mesh.positions.size()) - 1;
    }

    /// Joins a ring to what was there before it. `lean`: how much its normals look along the line, sine of the angle;
    /// `wider`: how much more it reaches along `bent`, which is across the line.
    void add_ring(SpacePoint center, SpacePoint along, SpacePoint up, double radius, double lean, SpacePoint bent,
                  double wider) {
        up_ = across(up, along, across(up_, along, any_across(along)));
        const SpacePoint side = cross(along, up_);  // from up to side: counter-clockwise about the line
        const double flat = std::sqrt(std::max(0.0, 1 - lean * lean));
        std::vector<int> ring;
        for (int k = 0; k < sides_; ++k) {
            const double angle = two_pi * k / sides_;
            const SpacePoint out = std::cos(angle) * up_ + std::sin(angle) * side;
            const SpacePoint p = center + radius * (out + (wider * dot(out, bent)) * bent);
            const int old = ring_.empty() ? -1 : ring_[ring.size()];
            ring.push_back(old >= 0 && is_at(old, p, radius) ? old : add_vertex(p, unit(flat * out + lean * along)));
        }
        join_to(std::move(ring));
    }
    void add_tip(SpacePoint p, SpacePoint normal) {
        join_to(std::vector<int>(static_cast<std::size_t>(sides_), add_vertex(p, normal)));
    }

    /// Rings about one point share the corners that they turn about.
    bool is_at(int vertex, SpacePoint p, double radius) const {
        constexpr double same = 1e-9;
        return abs(result_.mesh.positions[static_cast<std::size_t>(vertex)] - p) <= same * radius;
    }
    void add_triangle(int a, int b, int c) {
        if (a != b && b != c && c != a) result_.mesh.triangles.push_back({a, b, c});
    }
    void join_to(std::vector<int> ring) {
        for (std::size_t k = 0; k < ring_.size(); ++k) {
            const std::size_t next = (k + 1) % ring_.size();
            add_triangle(ring_[k], ring_[next], ring[next]);
            add_triangle(ring_[k], ring[next], ring[k]);
        }
        ring_ = std::move(ring);
    }

    void begin() {
        const LinePoint& p = points_.front();
        const SpacePoint along = direction(0);
        add_tip(p.at - p.radius * along, -1.0 * along);
        for (int k = 1; k <= cap_rings + 1; ++k) {
            const double angle = pi / 2 * k / (cap_rings + 1);  // from the tip
            add_ring(p.at - p.radius * std::cos(angle) * along, along, p.normal, p.radius * std::sin(angle),
                     -std::cos(angle), {}, 0);
        }
    }

    void end() {
        const LinePoint& p = points_.back();
        const SpacePoint along = direction(points_.size() - 2);
        add_ring(p.at, along, p.normal, p.radius, 0, {}, 0);
        if (merged_) return add_tip(p.at, along);
        for (int k = cap_rings; k >= 1; --k) {
            const double angle = pi / 2 * k / (cap_rings + 1);
            add_ring(p.at + p.radius * std::cos(angle) * along, along, p.normal, p.radius * std::sin(angle), std::cos(angle),
                     {}, 0);
        }
        add_tip(p.at + p.radius * along, along);
    }

    void bend(const LinePoint& p, SpacePoint in, SpacePoint out) {
        const double turn = std::atan2(abs(cross(in, out)), dot(in, out));
        if (turn <= sharpest_mitre) {
            const SpacePoint along = unit(in + out);
            const SpacePoint bent = turn > 0 ? across(out - in, along, {}) : SpacePoint{};
            return add_ring(p.at, along, p.normal, p.radius, 0, bent, 1 / std::cos(turn / 2) - 1);
        }
        // In the plane of both; a line that turns back goes about the normal.
        const SpacePoint sideways = across(out, in, cross(across(p.normal, in, any_across(in)), in));
        const int steps = static_cast<int>(std::ceil(turn / sharpest_mitre));
        for (int k = 0; k <= steps; ++k) {
            const double angle = turn * k / steps;
            add_ring(p.at, std::cos(angle) * in + std::sin(angle) * sideways, p.normal, p.radius, 0, {}, 0);
        }
    }
};

}  // namespace

NamedMesh line_tube(const PatternLine& line, int sides) { return TubeMaker(line, sides).make(); }

}  // namespace rinceau

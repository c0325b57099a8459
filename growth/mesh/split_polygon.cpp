// Newell's normal (the sum of the cross products about the rim) tells the plane in which ears are cut.

#include "growth/mesh/split_polygon.h"

#include <algorithm>
#include <cmath>

#include "geometry/point.h"

namespace rinceau {
namespace {

SpacePoint mean_normal(std::span<const SpacePoint> rim) {
    SpacePoint sum;
    for (std::size_t i = 1; i + 1 < rim.size(); ++i) sum = sum + cross(rim[i] - rim[0], rim[i + 1] - rim[0]);
    return sum;
}

/// Seen along the axis that the normal is nearest to; counter-clockwise stays so.
std::vector<Point> seen_flat(std::span<const SpacePoint> rim) {
    const SpacePoint n = mean_normal(rim);
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    std::vector<Point> flat;
    flat.reserve(rim.size());
    for (const SpacePoint p : rim) {
        if (z >= x && z >= y) {
            flat.push_back(n.z < 0 ? Point{p.y, p.x} : Point{p.x, p.y});
        } else if (x >= y) {
            flat.push_back(n.x < 0 ? Point{p.z, p.y} : Point{p.y, p.z});
        } else {
            flat.push_back(n.y < 0 ? Point{p.x, p.z} : Point{p.z, p.x});
        }
    }
    return flat;
}

double turn(Point a, Point b, Point c) { return cross(b - a, c - b); }

/// Is the diagonal from corner 0 to 2 the better one of a quad?
bool cut_from_first(std::span<const SpacePoint> rim) {
    const SpacePoint n = mean_normal(rim);
    const auto least = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
        return std::min(dot(cross(rim[b] - rim[a], rim[c] - rim[a]), n), dot(cross(rim[c] - rim[a], rim[d] - rim[a]), n));
    };
    const bool first_folds = least(0, 1, 2, 3) <= 0, second_folds = least(1, 2, 3, 0) <= 0;
    if (first_folds != second_folds) return second_folds;
    return abs(rim[2] - rim[0]) <= abs(rim[3] - rim[1]);
}

/// The corners that are left of a polygon, as a ring of indices.
class EarCutter {
  public:
    explicit EarCutter(std::vector<Point> flat) : flat_(std::move(flat)) {
        for (std::size_t i = 0; i < flat_.size(); ++i) left_.push_back(i);
    }

    std::vector<std::array<std::size_t, 3>> cut() {
        std::vector<std::array<std::size_t, 3>> triangles;
        std::size_t at = 0;
        while (left_.size() > 3) {
            at = next_ear(at);
            triangles.push_back({corner(at, -1), corner(at, 0), corner(at, 1)});
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
            at = at % left_.size();
        }
        triangles.push_back({left_[0], left_[1], left_[2]});
        return triangles;
    }

  private:
    std::vector<Point> flat_;
    std::vector<std::size_t> left_;

    std::size_t corner(std::size_t at, int step) const {
        const std::size_t n = left_.size();
        return left_[(at + n + static_cast<std::size_t>(step + 1) - 1) % n];
    }
    bool is_ear(std::size_t at) const {
        const Point a = flat_[corner(at, -1)], b = flat_[corner(at, 0)], c = flat_[corner(at, 1)];
        if (turn(a, b, c) <= 0) return false;
        return std::ranges::none_of(left_, [&](std::size_t i) {
            const Point p = flat_[i];
            if (p == a || p == b || p == c) return false;
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }
    /// A polygon that crosses itself may have none: then any corner.
    std::size_t next_ear(std::size_t from) const {
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (is_ear((from + i) % left_.size())) return (from + i) % left_.size();
        return from;
    }
};

bool is_convex(const std::vector<Point>& flat) {
    for (std::size_t i = 0; i < flat.size(); ++i)
        if (turn(flat[i], flat[(i + 1) % flat.size()], flat[(i + 2) % flat.size()]) <= 0) return false;
    return true;
}

/// Of a convex polygon whose corners turn once.
std::vector<std::array<std::size_t, 3>> fan(std::size_t corners) {
    std::vector<std::array<std::size_t, 3>> triangles;
    for (std::size_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
    return triangles;
}

}  // namespace

std::vector<std::array<int, 3>> split_polygon(std::span<const SpacePoint> positions, std::span<const int> corners) {
    if (corners.size() == 3) return {{corners[0], corners[1], corners[2]}};
    std::vector<SpacePoint> rim;
    rim.reserve(corners.size());
    for (const int v : corners) rim.push_back(positions[static_cast<std::size_t>(v)]);
    std::vector<std::array<std::size_t, 3>> parts;
    if (corners.size() == 4) {
        parts = cut_from_first(rim) ? std::vector<std::array<std::size_t, 3>>{{0, 1, 2}, {0, 2, 3}}
                                    : std::vector<std::array<std::size_t, 3>>{{0, 1, 3}, {1, 2, 3}};
    } else {
        std::vector<Point> flat = seen_flat(rim);
        parts = is_convex(flat) ? fan(flat.size()) : EarCutter(std::move(flat)).cut();
    }
    std::vector<std::array<int, 3>> triangles;
    for (const auto& [a, b, c] : parts) triangles.push_back({corners[a], corners[b], corners[c]});
    return triangles;
}

}  // namespace rinceau

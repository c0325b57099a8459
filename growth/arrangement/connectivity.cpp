// Ijiri et al. 2008, section 4. Deviations: points that are nearly cocircular form one face with as many corners, where the
// paper keeps an arbitrary diagonal and lets the user flip it; skewed triangles are dropped from the rim inward only, for
// inside they would tear rings open; and one degree earlier than at 120, which is just the angle of a staggered rim.

#include "growth/arrangement/connectivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/delaunay.h"
#include "geometry/index_map.h"
#include "geometry/polygon.h"
#include "growth/joined_sets.h"

namespace rinceau {
namespace {

using Faces = std::vector<std::vector<int>>;

std::uint64_t edge_key(int from, int to) {
    return (static_cast<std::uint64_t>(from) << 32U) | static_cast<std::uint32_t>(to);
}

FaceCircle circle_through(Point a, Point b, Point c) {
    const Point ab = b - a;
    const Point ac = c - a;
    const double twice_area = cross(ab, ac);
    if (!(std::abs(twice_area) > 0)) return {0.5 * (a + b), INFINITY};
    const Point from_a = Point{ac.y * norm(ab) - ab.y * norm(ac), ab.x * norm(ac) - ac.x * norm(ab)} / (2 * twice_area);
    return {a + from_a, abs(from_a)};
}

double largest_angle(std::span<const Point> points, const std::array<int, 3>& corners) {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point at = points[static_cast<std::size_t>(corners[k])];
        const Point next = points[static_cast<std::size_t>(corners[(k + 1) % 3])] - at;
        const Point last = points[static_cast<std::size_t>(corners[(k + 2) % 3])] - at;
        largest = std::max(largest, std::abs(std::atan2(cross(next, last), dot(next, last))));
    }
    return largest;
}

double polygon_area(std::span<const Point> points, const std::vector<int>& face) {
    std::vector<Point> corners;
    for (const int p : face) corners.push_back(points[static_cast<std::size_t>(p)]);
    return signed_area(corners);
}

/// Square root of the area of a point: the angles of a face of n corners are those of (n - 2) / 2 points.
double spacing_of(std::span<const Point> points, const Faces& faces) {
    double whole = 0;
    double share = 0;
    for (const auto& face : faces) {
        whole += polygon_area(points, face);
        share += 0.5 * static_cast<double>(face.size() - 2);
    }
    return share > 0 ? std::sqrt(std::max(whole, 0.0) / share) : 0;
}

/// Which triangles count as one face: for each the lowest of its face.
std::vector<int> merged_roots(std::span<const Point> points, const std::vector<DelaunayTriangle>& triangles, double spacing,
                              double tie) {
    std::vector<FaceCircle> circles;
    circles.reserve(triangles.size());
    for (const DelaunayTriangle& t : triangles) circles.push_back(face_circle(points, {t.corners.begin(), t.corners.end()}));
    JoinedSets merged(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int other = triangles[t].neighbors[k];
            if (other <= static_cast<int>(t)) continue;
            const Point a = points[static_cast<std::size_t>(triangles[t].corners[k])];
            const Point b = points[static_cast<std::size_t>(triangles[t].corners[(k + 1) % 3])];
            const double apart = abs(circles[t].center - circles[static_cast<std::size_t>(other)].center);
            if (apart < tie * std::min(spacing, abs(b - a))) merged.join(static_cast<int>(t), other);
        }
    std::vector<int> roots(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) roots[t] = merged.root(static_cast<int>(t));
    return roots;
}

/// The ring of edges about triangles that share inner edges; empty if it is not a single ring.
std::vector<int> outline_of(const std::vector<std::pair<int, int>>& edges) {
    std::vector<int> ring{edges.front().first};
    for (std::size_t step = 0; step < edges.size(); ++step) {
        const auto next = std::ranges::find(edges, ring.back(), &std::pair<int, int>::first);
        if (next == edges.end()) return {};
        if (next->second == ring.front()) return ring.size() == edges.size() ? ring : std::vector<int>{};
        ring.push_back(next->second);
    }
    return {};
}

struct MergedFaces {
    Faces faces;
    std::vector<std::vector<int>> neighbors;  ///< faces across the edges; -1 = none
    std::vector<bool> too_wide;
};

/// One face for each root. What does not form a single ring stays triangles.
MergedFaces merged_faces(std::span<const Point> points, const std::vector<DelaunayTriangle>& triangles,
                         std::vector<int> roots, const ConnectivityOptions& options) {
    std::vector<std::vector<int>> members(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        members[static_cast<std::size_t>(roots[t])].push_back(static_cast<int>(t));
    MergedFaces merged;
    for (std::size_t root = 0; root < members.size(); ++root) {
        std::vector<std::pair<int, int>> edges;
        for (const int t : members[root])
            for (std::size_t k = 0; k < 3; ++k) {
                const DelaunayTriangle& triangle = triangles[static_cast<std::size_t>(t)];
                const int other = triangle.neighbors[k];
                if (other < 0 || roots[static_cast<std::size_t>(other)] != static_cast<int>(root))
                    edges.emplace_back(triangle.corners[k], triangle.corners[(k + 1) % 3]);
            }
        std::vector<int> ring = edges.empty() ? std::vector<int>{} : outline_of(edges);
        if (!ring.empty()) {
            merged.faces.push_back(std::move(ring));
            continue;
        }
        for (const int t : members[root]) {
            const auto& corners = triangles[static_cast<std::size_t>(t)].corners;
            merged.faces.emplace_back(corners.begin(), corners.end());
        }
    }
    for (const auto& face : merged.faces)
        merged.too_wide.push_back(face.size() == 3 &&
                                  largest_angle(points, {face[0], face[1], face[2]}) > options.max_angle);
    return merged;
}

IndexMap faces_left_of_edges(const Faces& faces) {
    IndexMap left(4 * faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < faces[f].size(); ++k)
            left.set(edge_key(faces[f][k], faces[f][(k + 1) % faces[f].size()]), static_cast<int>(f));
    return left;
}

/// Merged faces are too wide by their circle, because their angles are wide by nature.
void judge_large_faces(std::span<const Point> points, MergedFaces& merged) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t f = 0; f < merged.faces.size(); ++f) {
        if (merged.too_wide[f]) continue;
        const auto& face = merged.faces[f];
        for (std::size_t k = 0; k < face.size(); ++k, ++count)
            sum += abs(points[static_cast<std::size_t>(face[(k + 1) % face.size()])] -
                       points[static_cast<std::size_t>(face[k])]);
    }
    constexpr double widest = 2;  // mean edges
    const double limit = count > 0 ? widest * sum / static_cast<double>(count) : INFINITY;
    for (std::size_t f = 0; f < merged.faces.size(); ++f)
        if (merged.faces[f].size() > 3 && face_circle(points, merged.faces[f]).radius > limit) merged.too_wide[f] = true;
}

/// Drops what is too wide at the rim, and what lies open by that.
Faces peeled(MergedFaces merged) {
    const IndexMap left = faces_left_of_edges(merged.faces);
    std::vector<bool> dropped(merged.faces.size());
    std::vector<int> open;
    const auto neighbor = [&](int f, std::size_t k) {
        const auto& face = merged.faces[static_cast<std::size_t>(f)];
        return left.find(edge_key(face[(k + 1) % face.size()], face[k]));
    };
    const auto drop = [&](int f) {
        if (dropped[static_cast<std::size_t>(f)] || !merged.too_wide[static_cast<std::size_t>(f)]) return;
        dropped[static_cast<std::size_t>(f)] = true;
        open.push_back(f);
    };
    for (int f = 0; f < static_cast<int>(merged.faces.size()); ++f)
        for (std::size_t k = 0; k < merged.faces[static_cast<std::size_t>(f)].size(); ++k)
            if (neighbor(f, k) == IndexMap::none) drop(f);
    while (!open.empty()) {
        const int f = open.back();
        open.pop_back();
        for (std::size_t k = 0; k < merged.faces[static_cast<std::size_t>(f)].size(); ++k)
            if (const int other = neighbor(f, k); other != IndexMap::none) drop(other);
    }
    Faces kept;
    for (std::size_t f = 0; f < merged.faces.size(); ++f)
        if (!dropped[f]) kept.push_back(std::move(merged.faces[f]));
    return kept;
}

/// The neighbours of a point: of each face at it, the corner behind it leads to the corner before it.
struct PointSector {
    int first = 0;  ///< counter-clockwise about the point
    int last = 0;
    bool triangle = false;
    bool on_rim = false;  ///< the face has an edge on the rim
};

void add_ring(std::span<const Point> points, int point, const std::vector<PointSector>& sectors, Connectivity& result) {
    auto& ring = result.rings[static_cast<std::size_t>(point)];
    for (const PointSector& s : sectors) {
        ring.push_back(s.first);
        ring.push_back(s.last);
    }
    std::ranges::sort(ring);
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    const auto angle = [&](int other) {
        return arg(points[static_cast<std::size_t>(other)] - points[static_cast<std::size_t>(point)]);
    };
    std::ranges::stable_sort(ring, {}, angle);
    if (ring.empty()) return;
    std::rotate(ring.begin(), std::ranges::min_element(ring), ring.end());
    std::size_t closed = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const auto sector = std::ranges::find_if(
            sectors, [&](const PointSector& s) { return s.first == ring[k] && s.last == ring[(k + 1) % ring.size()]; });
        closed += sector != sectors.end() ? 1 : 0;
        result.joined[static_cast<std::size_t>(point)].push_back(sector != sectors.end() && sector->triangle);
    }
    const bool inner = closed == ring.size() && ring.size() >= 3;
    result.inner[static_cast<std::size_t>(point)] = inner;
    result.deep[static_cast<std::size_t>(point)] = inner && std::ranges::none_of(sectors, &PointSector::on_rim);
}

}  // namespace

FaceCircle face_circle(std::span<const Point> points, const std::vector<int>& face) {
    const auto corner = [&](std::size_t k) { return points[static_cast<std::size_t>(face[k])]; };
    if (face.size() == 3) return circle_through(corner(0), corner(1), corner(2));
    FaceCircle mean;
    const double share = 1 / static_cast<double>(face.size() - 2);
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
        const FaceCircle circle = circle_through(corner(0), corner(k), corner(k + 1));
        mean.center += share * circle.center;
        mean.radius += share * circle.radius;
    }
    return mean;
}

Connectivity connectivity_from_faces(std::span<const Point> points, Faces faces) {
    Connectivity result;
    for (auto& face : faces) std::rotate(face.begin(), std::ranges::min_element(face), face.end());
    std::ranges::sort(faces);
    const IndexMap left = faces_left_of_edges(faces);
    std::vector<std::vector<PointSector>> sectors(points.size());
    for (const auto& face : faces) {
        const std::size_t n = face.size();
        bool on_rim = false;
        for (std::size_t k = 0; k < n; ++k) {
            if (left.find(edge_key(face[(k + 1) % n], face[k])) != IndexMap::none) continue;
            on_rim = true;
            result.rim.emplace_back(face[k], face[(k + 1) % n]);
        }
        for (std::size_t k = 0; k < n; ++k)
            sectors[static_cast<std::size_t>(face[k])].push_back({face[(k + 1) % n], face[(k + n - 1) % n], n == 3, on_rim});
    }
    result.rings.resize(points.size());
    result.joined.resize(points.size());
    result.inner.resize(points.size());
    result.deep.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) add_ring(points, static_cast<int>(p), sectors[p], result);
    result.spacing = spacing_of(points, faces);
    result.faces = std::move(faces);
    return result;
}

Connectivity connectivity_of(std::span<const Point> points, const ConnectivityOptions& options) {
    const std::vector<DelaunayTriangle> triangles = delaunay(points);
    Faces even;  // those that are not skewed: slivers at the rim have no area to speak of
    for (const DelaunayTriangle& t : triangles)
        if (largest_angle(points, t.corners) <= options.max_angle) even.emplace_back(t.corners.begin(), t.corners.end());
    const double spacing = spacing_of(points, even);
    MergedFaces merged = merged_faces(points, triangles, merged_roots(points, triangles, spacing, options.tie), options);
    judge_large_faces(points, merged);
    return connectivity_from_faces(points, peeled(std::move(merged)));
}

std::optional<Faces> flipped_edge(std::span<const Point> points, const Connectivity& connectivity,
                                  std::pair<int, int> edge) {
    const int a = edge.first, b = edge.second;
    const IndexMap left = faces_left_of_edges(connectivity.faces);
    const int f = left.find(edge_key(a, b));
    const int g = left.find(edge_key(b, a));
    if (f == IndexMap::none || g == IndexMap::none) return {};
    const auto& left_face = connectivity.faces[static_cast<std::size_t>(f)];
    const auto& right_face = connectivity.faces[static_cast<std::size_t>(g)];
    if (left_face.size() != 3 || right_face.size() != 3) return {};
    const auto third = [&](const std::vector<int>& face) {
        return *std::ranges::find_if(face, [&](int p) { return p != a && p != b; });
    };
    const int c = third(left_face);
    const int d = third(right_face);
    const std::vector<int> first{a, d, c};
    const std::vector<int> second{b, c, d};
    if (!(polygon_area(points, first) > 0) || !(polygon_area(points, second) > 0)) return {};
    Faces faces = connectivity.faces;
    faces[static_cast<std::size_t>(f)] = first;
    faces[static_cast<std::size_t>(g)] = second;
    return faces;
}

}  // namespace rinceau

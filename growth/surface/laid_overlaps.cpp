#include "growth/surface/laid_overlaps.h"

#include <algorithm>
#include <array>

#include "geometry/index.h"

namespace rinceau {
namespace {

double area_of(const std::vector<Point>& polygon) {
    double doubled = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        doubled += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    return 0.5 * doubled;
}

/// What of the polygon lies left of the line from a to b.
void keep_left(const std::vector<Point>& polygon, Point a, Point b, std::vector<Point>& kept) {
    kept.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point p = polygon[k], q = polygon[k + 1 == polygon.size() ? 0 : k + 1];
        const double p_side = cross(b - a, p - a), q_side = cross(b - a, q - a);
        if (p_side >= 0) kept.push_back(p);
        if ((p_side > 0) != (q_side > 0) && p_side != q_side && p_side != 0 && q_side != 0)
            kept.push_back(p + (p_side / (p_side - q_side)) * (q - p));
    }
}

std::vector<Point> scaled_hull(const std::vector<Point>& hull, double factor) {
    Box box;
    for (const Point p : hull) box = including(box, p);
    std::vector<Point> scaled;
    for (const Point p : hull) scaled.push_back(center(box) + factor * (p - center(box)));
    return scaled;
}

}  // namespace

double convex_common_area(const Point* a, int a_count, const Point* b, int b_count) {
    std::vector<Point> polygon(a, a + a_count), kept;
    for (int k = 0; k < b_count && polygon.size() >= 3; ++k) {
        keep_left(polygon, b[k], b[k + 1 == b_count ? 0 : k + 1], kept);
        std::swap(polygon, kept);
    }
    return polygon.size() < 3 ? 0 : area_of(polygon);
}

bool scaled_hulls_overlap(const std::vector<Point>& a, const std::vector<Point>& b, double factor) {
    const std::vector<Point> large_a = scaled_hull(a, factor), large_b = scaled_hull(b, factor);
    return convex_common_area(large_a.data(), static_cast<int>(large_a.size()), large_b.data(),
                              static_cast<int>(large_b.size())) > 0;
}

LaidOverlaps::Known LaidOverlaps::known_of(const LaidShape& shape) {
    struct Piece {
        int face;
        int first, count;
    };
    Known known;
    std::vector<Piece> pieces;
    for (const LaidLayer& layer : shape.layers) {
        const int offset = static_cast<int>(known.corners.size());
        known.corners.insert(known.corners.end(), layer.area.corners.begin(), layer.area.corners.end());
        for (const LaidPiece& piece : layer.area.pieces) pieces.push_back({piece.face, offset + piece.first, piece.count});
    }
    std::ranges::stable_sort(pieces, {}, &Piece::face);
    for (const Piece& piece : pieces) {
        if (known.faces.empty() || known.faces.back().face != piece.face) known.faces.push_back({piece.face, {}, {}});
        OnFace& on = known.faces.back();
        Box box;
        for (int k = piece.first; k < piece.first + piece.count; ++k) box = including(box, known.corners[at(k)]);
        on.box = including(on.box, box);
        on.pieces.push_back({box, piece.first, piece.count});
    }
    return known;
}

int LaidOverlaps::add(const LaidShape& shape) {
    shapes_.push_back(known_of(shape));
    return balls_.add(shape.centre, shape.radius);
}

double LaidOverlaps::common_area(const Known& a, const OnFace& on_a, const Known& b, const OnFace& on_b, double enough) {
    double sum = 0;
    for (const BoxedPiece& p : on_a.pieces) {
        if (!overlap(p.box, on_b.box)) continue;
        for (const BoxedPiece& q : on_b.pieces) {
            if (!overlap(p.box, q.box)) continue;
            sum += convex_common_area(&a.corners[at(p.first)], p.count, &b.corners[at(q.first)], q.count);
            if (sum >= enough) return sum;
        }
    }
    return sum;
}

double LaidOverlaps::common_area(const Known& a, const Known& b, double enough) {
    double sum = 0;
    auto x = a.faces.begin();
    auto y = b.faces.begin();
    while (x != a.faces.end() && y != b.faces.end() && sum < enough) {
        if (x->face < y->face) {
            ++x;
        } else if (y->face < x->face) {
            ++y;
        } else {
            if (overlap(x->box, y->box)) sum += common_area(a, *x, b, *y, enough - sum);
            ++x;
            ++y;
        }
    }
    return sum;
}

std::vector<LaidOverlap> LaidOverlaps::with(const LaidShape& shape, double enough) const {
    std::vector<int> near;
    balls_.visit(shape.centre, shape.radius, [&](int other) { near.push_back(other); });
    if (near.empty()) return {};
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    const Known known = known_of(shape);
    std::vector<LaidOverlap> overlaps;
    for (const int other : near) {
        const double area = common_area(known, shapes_[at(other)], enough);
        if (area > 0) overlaps.push_back({other, area});
    }
    return overlaps;
}

}  // namespace rinceau

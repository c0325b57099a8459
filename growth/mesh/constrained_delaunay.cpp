// Sloan 1993, "A fast algorithm for generating constrained Delaunay triangulations": edges that cross the wanted one are
// flipped away, in turn, as far as their quadrilaterals are convex.

#include "growth/mesh/constrained_delaunay.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "geometry/delaunay.h"

namespace rinceau {
namespace {

constexpr std::size_t next(std::size_t k) { return (k + 1) % 3; }
constexpr std::size_t previous(std::size_t k) { return (k + 2) % 3; }

/// Does d lie clearly inside the circle through a, b, c (counter-clockwise)?
bool in_circle(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
    const auto from_d = [d](GridPoint p) { return Point{static_cast<double>(p.x - d.x), static_cast<double>(p.y - d.y)}; };
    const Point pa = from_d(a), pb = from_d(b), pc = from_d(c);
    const double first = norm(pa) * cross(pb, pc), second = norm(pb) * cross(pc, pa), third = norm(pc) * cross(pa, pb);
    constexpr double rounding = 1e-13;  // share of the terms; a flip less is no harm, one that is taken back is
    return first + second + third > rounding * (std::abs(first) + std::abs(second) + std::abs(third));
}

}  // namespace

ConstrainedDelaunay::ConstrainedDelaunay(std::vector<GridPoint> points)
    : points_(std::move(points)), triangle_of_(points_.size(), -1) {
    std::vector<Point> real;
    real.reserve(points_.size());
    for (const GridPoint p : points_) real.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
    for (const DelaunayTriangle& t : delaunay(real)) {
        for (const int corner : t.corners)
            triangle_of_[static_cast<std::size_t>(corner)] = static_cast<int>(triangles_.size());
        triangles_.push_back({t.corners, t.neighbors, {}});
    }
}

std::vector<int> ConstrainedDelaunay::triangles_about(int point) const {
    std::vector<int> about;
    const int first = triangle_of_[static_cast<std::size_t>(point)];
    const auto corner_in = [&](int t) {
        const auto& corners = triangle(t).corners;
        return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), point) - corners.begin());
    };
    for (int t = first; t >= 0;) {
        about.push_back(t);
        t = triangle(t).neighbors[previous(corner_in(t))];
        if (t == first) return about;
    }
    if (first < 0) return about;
    for (int t = triangle(first).neighbors[corner_in(first)]; t >= 0; t = triangle(t).neighbors[corner_in(t)])
        about.push_back(t);
    return about;
}

ConstrainedDelaunay::Side ConstrainedDelaunay::side(int from, int to) const {
    for (const int t : triangles_about(from))
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangle(t).corners[k], b = triangle(t).corners[next(k)];
            if ((a == from && b == to) || (a == to && b == from)) return {t, static_cast<int>(k)};
        }
    return {};
}

ConstrainedDelaunay::Side ConstrainedDelaunay::across(Side s) const {
    const Triangle& here = triangle(s.triangle);
    const int other = here.neighbors[static_cast<std::size_t>(s.edge)];
    if (other < 0) return {};
    const auto& neighbors = triangle(other).neighbors;
    const int start = here.corners[next(static_cast<std::size_t>(s.edge))];
    for (std::size_t k = 0; k < 3; ++k)
        if (neighbors[k] == s.triangle && triangle(other).corners[k] == start) return {other, static_cast<int>(k)};
    return {};
}

int ConstrainedDelaunay::opposite(Side s) const {
    return triangle(s.triangle).corners[previous(static_cast<std::size_t>(s.edge))];
}

bool ConstrainedDelaunay::can_flip(Side s) const {
    const Side other = across(s);
    if (other.triangle < 0 || triangle(s.triangle).drawn[static_cast<std::size_t>(s.edge)] > 0) return false;
    const GridPoint a = at(triangle(s.triangle).corners[static_cast<std::size_t>(s.edge)]);
    const GridPoint b = at(triangle(other.triangle).corners[static_cast<std::size_t>(other.edge)]);
    const GridPoint c = at(opposite(s)), d = at(opposite(other));
    return orientation(a, d, c) > 0 && orientation(d, b, c) > 0;
}

void ConstrainedDelaunay::hand_over(int neighbor, int from, int to) {
    if (neighbor < 0) return;
    for (int& n : triangle(neighbor).neighbors)
        if (n == from) {
            n = to;
            return;
        }
}

void ConstrainedDelaunay::flip(Side s) {
    const Side o = across(s);
    const auto k = static_cast<std::size_t>(s.edge), j = static_cast<std::size_t>(o.edge);
    const Triangle t = triangle(s.triangle), u = triangle(o.triangle);
    const int a = t.corners[k], b = t.corners[next(k)], c = t.corners[previous(k)], d = u.corners[previous(j)];
    triangle(s.triangle) = {{a, d, c},
                            {u.neighbors[next(j)], o.triangle, t.neighbors[previous(k)]},
                            {u.drawn[next(j)], 0, t.drawn[previous(k)]}};
    triangle(o.triangle) = {{d, b, c},
                            {u.neighbors[previous(j)], t.neighbors[next(k)], s.triangle},
                            {u.drawn[previous(j)], t.drawn[next(k)], 0}};
    hand_over(u.neighbors[next(j)], o.triangle, s.triangle);
    hand_over(t.neighbors[next(k)], s.triangle, o.triangle);
    for (const int p : {a, d, c}) triangle_of_[static_cast<std::size_t>(p)] = s.triangle;
    triangle_of_[static_cast<std::size_t>(b)] = o.triangle;
}

void ConstrainedDelaunay::mark(Side s) {
    ++triangle(s.triangle).drawn[static_cast<std::size_t>(s.edge)];
    const Side other = across(s);
    if (other.triangle >= 0) ++triangle(other.triangle).drawn[static_cast<std::size_t>(other.edge)];
}

/// Flips the crossed edges until none crosses the segment.
bool ConstrainedDelaunay::flip_away(std::vector<std::array<int, 2>> crossed, int from, int to) {
    std::deque<std::array<int, 2>> waiting(crossed.begin(), crossed.end());
    const auto strictly_crosses = [&](int p, int q) {
        if (p == from || q == from || p == to || q == to) return false;
        return (orientation(at(from), at(to), at(p)) > 0) != (orientation(at(from), at(to), at(q)) > 0);
    };
    std::size_t tries = 100 + 4 * waiting.size() * waiting.size();
    while (!waiting.empty()) {
        if (tries-- == 0) return false;
        const auto [p, q] = waiting.front();
        waiting.pop_front();
        const Side s = side(p, q);
        if (s.triangle < 0) return false;
        if (!can_flip(s)) {
            waiting.push_back({p, q});
            continue;
        }
        const int c = opposite(s), d = opposite(across(s));
        flip(s);
        if (strictly_crosses(c, d)) waiting.push_back({c, d});
    }
    return true;
}

/// Draws up to the first point on the segment; that point, or -1.
int ConstrainedDelaunay::draw_first(int from, int to) {
    Side s;
    for (const int t : triangles_about(from)) {
        const auto& corners = triangle(t).corners;
        const auto i = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), from) - corners.begin());
        const std::array<int, 2> others{corners[next(i)], corners[previous(i)]};
        std::array<std::int64_t, 2> sides{};
        for (std::size_t k = 0; k < 2; ++k) {
            const GridPoint p = at(others[k]), a = at(from), b = at(to);
            sides[k] = orientation(a, b, p);
            const bool ahead = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y) > 0;
            if (sides[k] == 0 && ahead) {
                mark(side(from, others[k]));
                return others[k];
            }
        }
        if (sides[0] < 0 && sides[1] > 0) s = {t, static_cast<int>(next(i))};
    }
    if (s.triangle < 0) return -1;
    std::vector<std::array<int, 2>> crossed;
    int end = -1;
    while (end < 0) {
        const auto k = static_cast<std::size_t>(s.edge);
        if (triangle(s.triangle).drawn[k] > 0) return -1;
        const int right = triangle(s.triangle).corners[k], left = triangle(s.triangle).corners[next(k)];
        crossed.push_back({right, left});
        const Side other = across(s);
        if (other.triangle < 0) return -1;
        const int ahead = opposite(other);
        const std::int64_t turn = orientation(at(from), at(to), at(ahead));
        if (turn == 0) end = ahead;
        // The other triangle is (left, right, ahead): its edge right-ahead follows, then ahead-left.
        const std::size_t step = static_cast<std::size_t>(other.edge);
        s = {other.triangle, static_cast<int>(turn > 0 ? next(step) : previous(step))};
    }
    if (!flip_away(std::move(crossed), from, end)) return -1;
    const Side drawn = side(from, end);
    if (drawn.triangle < 0) return -1;
    mark(drawn);
    return end;
}

bool ConstrainedDelaunay::draw(int from, int to) {
    for (int at_point = from; at_point != to;) {
        at_point = draw_first(at_point, to);
        if (at_point < 0) return false;
    }
    return true;
}

void ConstrainedDelaunay::relax() {
    std::vector<Side> waiting;
    for (int t = static_cast<int>(triangles_.size()) - 1; t >= 0; --t)
        for (int k = 0; k < 3; ++k) waiting.push_back({t, k});
    std::size_t flips = 50 * triangles_.size();
    while (!waiting.empty() && flips > 0) {
        const Side s = waiting.back();
        waiting.pop_back();
        if (!can_flip(s)) continue;
        const Side other = across(s);
        const auto& c = triangle(s.triangle).corners;
        if (!in_circle(at(c[0]), at(c[1]), at(c[2]), at(opposite(other)))) continue;
        flip(s);
        --flips;
        for (int k = 0; k < 3; ++k) {
            waiting.push_back({s.triangle, k});
            waiting.push_back({other.triangle, k});
        }
    }
}

std::vector<std::array<int, 3>> ConstrainedDelaunay::inside() const {
    enum class State : unsigned char { unknown, outside, inside };
    std::vector<State> states(triangles_.size(), State::unknown);
    std::vector<int> waiting;
    const auto decide = [&](int t, bool in) {
        State& state = states[static_cast<std::size_t>(t)];
        if (state != State::unknown) return;
        state = in ? State::inside : State::outside;
        waiting.push_back(t);
    };
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (triangles_[t].neighbors[k] < 0) decide(static_cast<int>(t), triangles_[t].drawn[k] % 2 == 1);
    while (!waiting.empty()) {
        const int t = waiting.back();
        waiting.pop_back();
        for (std::size_t k = 0; k < 3; ++k)
            if (triangle(t).neighbors[k] >= 0)
                decide(triangle(t).neighbors[k],
                       (states[static_cast<std::size_t>(t)] == State::inside) != (triangle(t).drawn[k] % 2 == 1));
    }
    std::vector<std::array<int, 3>> found;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        if (states[t] == State::inside) found.push_back(triangles_[t].corners);
    return found;
}

}  // namespace rinceau

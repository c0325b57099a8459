// Between two neighbouring levels of all corners and crossings no edges cross: sorted from left to right, they bound
// trapezoids. One that goes on between the same two edges in the next level is the same trapezoid.

#include "editor/mesh/trapezoids.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "scene/painted_region.h"

namespace rinceau {
namespace {

/// An edge that is not level, from its lower end to its upper.
struct Edge {
    Point low;
    Point high;
    int winding = 1;  ///< +1 where the contour runs upwards

    double x_at(double y) const {
        if (y >= high.y) return high.x;
        return low.x + (high.x - low.x) * std::max(0.0, (y - low.y) / (high.y - low.y));
    }
};

std::vector<Edge> edges_of(const Contours& contours) {
    std::vector<Edge> edges;
    for (const std::vector<Point>& contour : contours) {
        if (contour.empty()) continue;
        Point from = contour.back();
        for (const Point to : contour) {
            if (from.y < to.y) edges.push_back({from, to, 1});
            if (to.y < from.y) edges.push_back({to, from, -1});
            from = to;
        }
    }
    return edges;
}

/// Where two edges cross, unless they only touch at their ends.
std::optional<double> crossing_level(const Edge& a, const Edge& b) {
    const double low = std::max(a.low.y, b.low.y);
    const double high = std::min(a.high.y, b.high.y);
    if (!(low < high)) return std::nullopt;
    const double before = a.x_at(low) - b.x_at(low);
    const double after = a.x_at(high) - b.x_at(high);
    if (before == 0 || after == 0 || (before < 0) == (after < 0)) return std::nullopt;
    return low + (high - low) * (before / (before - after));
}

/// Does the winding number lie inside?
bool is_inside(int winding, FillRule rule) { return rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0; }

std::vector<double> levels_of(const std::vector<Edge>& edges) {
    std::vector<double> levels;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        levels.push_back(edges[i].low.y);
        levels.push_back(edges[i].high.y);
        for (std::size_t j = 0; j < i; ++j)
            if (const auto level = crossing_level(edges[i], edges[j])) levels.push_back(*level);
    }
    std::ranges::sort(levels);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
}

/// What lies inside between two edges, from `level` on upwards.
struct Trapezoid {
    std::size_t left = 0;
    std::size_t right = 0;
    double level = 0;
};

class TrapezoidWriter {
  public:
    TrapezoidWriter(const std::vector<Edge>& edges, FillRule rule) : edges_(edges), rule_(rule), by_low_end_(edges.size()) {
        for (std::size_t i = 0; i < edges.size(); ++i) by_low_end_[i] = i;
        std::ranges::sort(by_low_end_, {}, [&](std::size_t i) { return std::pair(edges[i].low.y, i); });
    }

    Triangles write() {
        const std::vector<double> levels = levels_of(edges_);
        for (std::size_t i = 0; i + 1 < levels.size(); ++i) pass(levels[i], levels[i + 1]);
        if (!levels.empty()) close_all_but({}, levels.back());
        return std::move(triangles_);
    }

  private:
    void pass(double low, double high) {
        std::erase_if(crossed_, [&](const auto& edge) { return edges_[edge.second].high.y <= low; });
        while (next_ < by_low_end_.size() && edges_[by_low_end_[next_]].low.y <= low)
            crossed_.push_back({0, by_low_end_[next_++]});
        const double middle = 0.5 * (low + high);
        for (auto& [x, edge] : crossed_) x = edges_[edge].x_at(middle);
        std::ranges::sort(crossed_);
        std::vector<Trapezoid> spans = spans_from(low);
        close_all_but(spans, low);
        open_ = std::move(spans);
    }
    std::vector<Trapezoid> spans_from(double level) const {
        std::vector<Trapezoid> spans;
        int winding = 0;
        std::size_t left = 0;
        for (const auto& [x, edge] : crossed_) {
            const bool was_inside = is_inside(winding, rule_);
            winding += edges_[edge].winding;
            const bool inside = is_inside(winding, rule_);
            if (inside && !was_inside) left = edge;
            if (was_inside && !inside) spans.push_back({left, edge, level});
        }
        return spans;
    }
    /// Ends the open trapezoids at the level, but those that the spans go on with, which begin where these began.
    void close_all_but(std::vector<Trapezoid>& spans, double level) {
        for (const Trapezoid& open : open_) {
            const auto same = std::ranges::find_if(
                spans, [&](const Trapezoid& span) { return span.left == open.left && span.right == open.right; });
            if (same == spans.end()) {
                emit(open, level);
            } else {
                same->level = open.level;
            }
        }
    }
    void close_all_but(std::vector<Trapezoid>&& spans, double level) { close_all_but(spans, level); }

    void emit(const Trapezoid& trapezoid, double high) {
        const Edge& left = edges_[trapezoid.left];
        const Edge& right = edges_[trapezoid.right];
        const double low = trapezoid.level;
        const Point corners[] = {
            {left.x_at(low), low}, {right.x_at(low), low}, {right.x_at(high), high}, {left.x_at(high), high}};
        const auto first = static_cast<std::uint32_t>(triangles_.points.size());
        triangles_.points.insert(triangles_.points.end(), std::begin(corners), std::end(corners));
        if (corners[0].x < corners[1].x) triangles_.indices.insert(triangles_.indices.end(), {first, first + 1, first + 2});
        if (corners[3].x < corners[2].x) triangles_.indices.insert(triangles_.indices.end(), {first, first + 2, first + 3});
    }

    const std::vector<Edge>& edges_;
    FillRule rule_;
    std::vector<std::size_t> by_low_end_;
    std::size_t next_ = 0;
    std::vector<std::pair<double, std::size_t>> crossed_;  // x in the middle of the level, edge
    std::vector<Trapezoid> open_;
    Triangles triangles_;
};

/// The stretches of a level line that lie inside, those with narrow gaps between them as one.
std::vector<std::pair<double, double>> inside_stretches(std::vector<std::pair<double, int>> crossings, FillRule rule,
                                                        double narrow) {
    std::ranges::sort(crossings);
    std::vector<std::pair<double, double>> stretches;
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].second;
        if (!is_inside(winding, rule)) continue;
        if (!stretches.empty() && crossings[i].first - stretches.back().second <= narrow) {
            stretches.back().second = crossings[i + 1].first;
        } else {
            stretches.push_back({crossings[i].first, crossings[i + 1].first});
        }
    }
    return stretches;
}

}  // namespace

double crossing_count(const Contours& contours) {
    const std::vector<Edge> edges = edges_of(contours);
    const std::size_t count = edges.size();
    constexpr std::size_t counted_all = 1000;
    if (count <= counted_all) {
        double crossings = 0;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < i; ++j) crossings += crossing_level(edges[i], edges[j]).has_value() ? 1 : 0;
        return crossings;
    }
    // Each edge against some others, spread over all.
    const std::size_t partners = counted_all * counted_all / count + 1;
    double crossings = 0;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < partners; ++k)
            crossings += crossing_level(edges[i], edges[(i + 1 + (k * count + i) / partners) % count]).has_value() ? 1 : 0;
    return 0.5 * crossings * static_cast<double>(count) / static_cast<double>(partners);
}

Triangles trapezoid_triangles(const Contours& contours, FillRule rule) {
    const std::vector<Edge> edges = edges_of(contours);
    return TrapezoidWriter(edges, rule).write();
}

Triangles row_triangles(const Contours& contours, FillRule rule, int rows) {
    const Box box = bounds(contours);
    const double height_of_row = height(box) / rows;
    std::vector<std::vector<std::pair<double, int>>> crossings(static_cast<std::size_t>(rows));
    for (const Edge& edge : edges_of(contours)) {
        const auto row_from = [&](double y) { return std::ceil((y - box.low.y) / height_of_row - 0.5); };
        const auto end = static_cast<int>(std::min<double>(rows, row_from(edge.high.y)));
        for (int row = std::max(0, static_cast<int>(row_from(edge.low.y))); row < end; ++row)
            crossings[static_cast<std::size_t>(row)].push_back(
                {edge.x_at(box.low.y + (row + 0.5) * height_of_row), edge.winding});
    }
    Triangles triangles;
    for (int row = 0; row < rows; ++row) {
        const double low = box.low.y + row * height_of_row;
        for (const auto& [left, right] :
             inside_stretches(std::move(crossings[static_cast<std::size_t>(row)]), rule, height_of_row)) {
            const auto first = static_cast<std::uint32_t>(triangles.points.size());
            const double high = low + height_of_row;
            triangles.points.insert(triangles.points.end(), {{left, low}, {right, low}, {right, high}, {left, high}});
            triangles.indices.insert(triangles.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
        }
    }
    return triangles;
}

}  // namespace rinceau

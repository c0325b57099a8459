// Which sub-paths belong together. Outlines that come closer than their strokes reach are joined into clusters; then the
// winding number about each cluster, which is the same all over it since nothing crosses it, says whether it lies in the
// filled part of those around it (it belongs to them: a hole) or outside (a piece of its own: apart, or an island in a hole).

#include "scene/compound_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/polygon.h"
#include "scene/painted_region.h"
#include "scene/pen.h"

namespace rinceau {
namespace {

// Curves are flattened, and outlines count as touching, within this share of the element's diagonal.
constexpr double fineness = 1e-4;
// Steps of comparing corners and boxes after which an element stays whole: a fraction of a second.
constexpr long most_steps = 20'000'000;

struct Outline {
    std::vector<Point> corners;
    Box box;           ///< of the corners
    double reach = 0;  ///< of the stroke, where it matters
    bool closed = false;
};

class Clusters {
  public:
    explicit Clusters(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = find(a), b = find(b);
        // The first sub-path stands for its cluster.
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parent_;
};

bool is_opaque(const Paint& paint) {
    const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint);
    return gradient == nullptr || std::ranges::all_of((*gradient)->stops, [](const GradientStop& stop) { return stop.opacity >= 1; });
}

/// Can it be seen which of two overlapping strokes (or a stroke and a fill) is painted first, or that both are?
bool stroke_order_shows(const Style& style) {
    if (!paints_stroke(style)) return false;
    if (style.opacity < 1 || style.stroke.opacity < 1 || !is_opaque(style.stroke.paint)) return true;
    return paints_fill(style) && (style.fill != style.stroke.paint || style.fill_opacity < 1);
}

/// Half widths that the sharpest mitre of an outline reaches, at most the limit.
double mitre_reach(const std::vector<Point>& corners, bool closed, double limit) {
    double reach = 1;
    const std::size_t count = corners.size();
    for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < count; ++i) {
        const Point before = corners[i] - corners[(i + count - 1) % count], after = corners[(i + 1) % count] - corners[i];
        const double lengths = abs(before) * abs(after);
        if (lengths == 0) continue;
        // 1 / sin(half the inner angle) = sqrt(2 / (1 + cos(turn))).
        const double half = std::sqrt(2 / std::max(1 + dot(before, after) / lengths, 1e-9));
        if (half <= limit) reach = std::max(reach, half);
    }
    return reach;
}

std::vector<Outline> outlines_of(const std::vector<Path>& paths, const Style& style, double deviation) {
    const bool reaches = stroke_order_shows(style);
    const double half_width = 0.5 * style.stroke.width * largest_stretch(style.stroke.pen);
    std::vector<Outline> outlines;
    for (const Path& path : paths) {
        Outline& outline = outlines.emplace_back();
        outline.corners = flattened(path, deviation);
        outline.closed = path.closed;
        for (const Point p : outline.corners) outline.box = including(outline.box, p);
        if (!reaches) continue;
        const double mitre = style.stroke.join == LineJoin::miter ? mitre_reach(outline.corners, path.closed, style.stroke.miter_limit) : 1;
        outline.reach = half_width * std::max(mitre, style.stroke.cap == LineCap::square ? std::numbers::sqrt2 : 1.0);
    }
    return outlines;
}

struct Edge {
    Point from, to;
};

/// The edges of an outline that meet `box`; `all_round` with the closing edge.
std::vector<Edge> edges_within(const Outline& outline, const Box& box, bool all_round) {
    std::vector<Edge> edges;
    const auto& corners = outline.corners;
    const auto add = [&](Point from, Point to) {
        if (overlap(including(including(Box{}, from), to), box)) edges.push_back({from, to});
    };
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) add(corners[i], corners[i + 1]);
    if (all_round || outline.closed || corners.size() == 1) add(corners.back(), corners.front());
    return edges;
}

bool within(const Edge& a, const Edge& b, double distance) {
    if (segment_crossing(a.from, a.to, b.from, b.to)) return true;
    return distance_to_segment(a.from, b.from, b.to) <= distance || distance_to_segment(a.to, b.from, b.to) <= distance ||
           distance_to_segment(b.from, a.from, a.to) <= distance || distance_to_segment(b.to, a.from, a.to) <= distance;
}

class Splitter {
  public:
    Splitter(const std::vector<Path>& paths, const Style& style)
        : paths_(paths), style_(style), size_(diagonal(bounds(paths))), deviation_(std::max(fineness * size_, 1e-300)),
          outlines_(outlines_of(paths, style, deviation_)), clusters_(paths.size()), around_(paths.size()), regions_(paths.size()), wide_(paths.size()) {}

    std::vector<std::vector<Path>> pieces() {
        if (!find_pairs()) return {paths_};
        if (paints_fill(style_))
            for (std::size_t i = 0; i < paths_.size(); ++i)
                if (!attach_hole(i)) return {paths_};
        return collected();
    }

  private:
    bool spend(std::size_t steps) {
        steps_ += static_cast<long>(steps);
        return steps_ <= most_steps;
    }

    bool touch(const Outline& a, const Outline& b, double distance, bool& in_time) {
        const bool all_round = paints_fill(style_);
        const std::vector<Edge> of_a = edges_within(a, grown(b.box, distance), all_round);
        const std::vector<Edge> of_b = edges_within(b, grown(a.box, distance), all_round);
        in_time = spend(a.corners.size() + b.corners.size() + of_a.size() * of_b.size());
        if (!in_time) return true;
        for (const Edge& edge : of_a) {
            const Box near_edge = grown(including(including(Box{}, edge.from), edge.to), distance);
            for (const Edge& other : of_b)
                if (overlap(near_edge, including(including(Box{}, other.from), other.to)) && within(edge, other, distance)) return true;
        }
        return false;
    }

    const Region& region_of(std::size_t i) {
        if (regions_[i].empty()) regions_[i] = enclosed_region({paths_[i]}, style_.fill_rule, deviation_);
        return regions_[i];
    }

    /// Fills that meet in single corners only draw the same apart; where they overlap or share an edge they do not.
    bool only_corners_meet(std::size_t a, std::size_t b) {
        if (!paints_fill(style_) || stroke_order_shows(style_)) return false;
        // Doubled corners of a fine polygon: Clipper's cost grows little faster than their number.
        if (!spend(16 * (outlines_[a].corners.size() + outlines_[b].corners.size()))) return false;
        const double margin = 4 * deviation_;
        if (wide_[a].empty()) wide_[a] = offset_region(region_of(a), margin);
        const Region common = intersection_of(wide_[a], region_of(b));
        // About a corner the margin cuts off some squares of itself; along an edge a strip.
        constexpr double corner_squares = 60;
        return area(common) <= corner_squares * margin * margin;
    }

    /// Joins outlines that touch and notes which boxes hold which outlines. False if it takes too long.
    bool find_pairs() {
        std::vector<std::size_t> order(paths_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        double widest_reach = 0;
        for (const Outline& outline : outlines_) widest_reach = std::max(widest_reach, outline.reach);
        std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return outlines_[a].box.low.x < outlines_[b].box.low.x; });
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                const Outline &a = outlines_[order[i]], &b = outlines_[order[j]];
                if (b.box.low.x > a.box.high.x + 2 * widest_reach + deviation_) break;
                if (!spend(1)) return false;
                const double distance = a.reach + b.reach + 2 * deviation_;
                if (!overlap(grown(a.box, distance), b.box)) continue;
                bool in_time = true;
                if (touch(a, b, distance, in_time) && !only_corners_meet(order[i], order[j])) clusters_.join(order[i], order[j]);
                if (!in_time) return false;
                around_[order[i]].push_back(order[j]);
                around_[order[j]].push_back(order[i]);
            }
        return true;
    }

    /// If the cluster that outline `i` stands for lies in the filled part of others, joins it to the innermost of them.
    bool attach_hole(std::size_t i) {
        if (clusters_.find(i) != i || outlines_[i].corners.size() < 2) return true;
        const Point at = outlines_[i].corners.front();
        int winding = 0;
        std::size_t innermost = i;
        double least_area = 0;
        for (const std::size_t j : around_[i]) {
            const Outline& outer = outlines_[j];
            if (clusters_.find(j) == i || !overlap(outer.box, Box{at, at})) continue;
            if (!spend(outer.corners.size())) return false;
            const int turns = winding_number(outer.corners, at);
            if (turns == 0) continue;
            winding += turns;
            const double area = std::abs(signed_area(outer.corners));
            if (innermost == i || area < least_area) innermost = j, least_area = area;
        }
        const bool filled = style_.fill_rule == FillRule::evenodd ? winding % 2 != 0 : winding != 0;
        if (filled) holes_.emplace_back(i, innermost);
        return true;
    }

    std::vector<std::vector<Path>> collected() {
        // Only now, so that clusters stay what they were while windings were counted.
        for (const auto& [hole, outer] : holes_) clusters_.join(hole, outer);
        std::vector<std::vector<Path>> pieces;
        std::vector<std::size_t> piece_of(paths_.size());
        for (std::size_t i = 0; i < paths_.size(); ++i) {
            const std::size_t first = clusters_.find(i);
            if (first == i) {
                piece_of[i] = pieces.size();
                pieces.emplace_back();
            }
            pieces[piece_of[first]].push_back(paths_[i]);
        }
        return pieces;
    }

    const std::vector<Path>& paths_;
    const Style& style_;
    double size_;
    double deviation_;
    std::vector<Outline> outlines_;
    Clusters clusters_;
    std::vector<std::vector<std::size_t>> around_;  ///< outlines whose boxes come near
    std::vector<std::pair<std::size_t, std::size_t>> holes_;
    std::vector<Region> regions_, wide_;  ///< what each sub-path encloses, and that grown by a margin; made when needed
    long steps_ = 0;
};

}  // namespace

std::vector<std::vector<Path>> connected_pieces(const std::vector<Path>& paths, const Style& style) {
    if (paths.size() < 2) return {paths};
    if (paints_fill(style) || stroke_order_shows(style)) return Splitter(paths, style).pieces();
    std::vector<std::vector<Path>> single;
    for (const Path& path : paths) single.push_back({path});
    return single;
}

std::vector<Element> split_compound_paths(std::vector<Element> elements) {
    std::vector<Element> split;
    split.reserve(elements.size());
    for (Element& element : elements) {
        if (!element.verbatim.empty() || element.paths.size() < 2) {
            split.push_back(std::move(element));
            continue;
        }
        for (std::vector<Path>& piece : connected_pieces(element.paths, element.style)) {
            Element part;
            part.paths = std::move(piece);
            part.style = element.style;
            part.id = element.id;
            split.push_back(std::move(part));
        }
    }
    return split;
}

}  // namespace rinceau

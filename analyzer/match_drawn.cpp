#include "analyzer/match_drawn.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "analyzer/gradient_difference.h"
#include "analyzer/outline_deviation.h"
#include "geometry/parallel.h"

namespace rinceau {
namespace {

/// All in tolerances. An element further off than `reach` is another one; below `exact` any of several candidates will do.
constexpr double reach_in_tolerances = 4;
constexpr double exact_in_tolerances = 0.01;
/// Deviations that differ by less are equal: then paint order decides.
constexpr double step_in_tolerances = 1.0 / 16;
/// Of the polylines; leaves the deviation right to a twentieth of the default tolerance of 2e-4 diagonals.
constexpr double accuracy_in_tolerances = 0.01;
/// Candidates of one element that are measured, nearest boxes first, and rounds until all candidates have had their turn.
constexpr std::size_t candidates_per_round = 16;
constexpr int rounds = 64;

using CellKey = std::pair<double, double>;
struct CellHash {
    std::size_t operator()(const CellKey& key) const {
        const std::uint64_t mixed = std::bit_cast<std::uint64_t>(key.first) * 0x9E3779B97F4A7C15ULL +
                                    std::bit_cast<std::uint64_t>(key.second) * 0xC2B2AE3D27D4EB4FULL;
        return static_cast<std::size_t>(mixed ^ (mixed >> 29U));
    }
};
struct Cell {
    std::vector<std::size_t> drawn;  ///< in paint order
    std::size_t first_free = 0;      ///< all before are taken
};

/// Largest difference of the sides.
double box_distance(const Box& a, const Box& b) {
    return std::max({std::abs(a.low.x - b.low.x), std::abs(a.low.y - b.low.y), std::abs(a.high.x - b.high.x),
                     std::abs(a.high.y - b.high.y)});
}

std::vector<Box> outline_boxes(const Scene& scene, int threads) {
    std::vector<Box> boxes(scene.elements.size());
    for_each_index(boxes.size(), threads, [&](std::size_t i) {
        const Box box = bounds(scene.elements[i].paths);
        boxes[i] = is_empty(box) ? Box{{0, 0}, {0, 0}} : box;
    });
    return boxes;
}

bool all_closed(const std::vector<Path>& paths) { return std::ranges::all_of(paths, &Path::closed); }

/// A fill closes every sub-path.
std::vector<Path> as_filled(std::vector<Path> paths) {
    for (Path& path : paths) path.closed = true;
    return paths;
}

constexpr const char* stage = "check";

class Matcher {
  public:
    Matcher(const Scene& scene, const Scene& drawn, double tolerance, int threads, const Progress& progress)
        : progress_(progress),
          scene_(scene),
          drawn_(drawn),
          tolerance_(tolerance),
          reach_(reach_in_tolerances * tolerance),
          threads_(threads),
          scene_boxes_(outline_boxes(scene, threads)),
          drawn_boxes_(outline_boxes(drawn, threads)),
          taken_(drawn.elements.size(), false),
          matches_(scene.elements.size()) {}

    std::vector<DrawnMatch> run() {
        match_verbatim();
        fill_cells();
        match_exact();
        match_nearest(true);
        match_nearest(false);
        return std::move(matches_);
    }

  private:
    struct Candidate {
        double deviation;
        std::int64_t step;  ///< the deviation in steps
        std::size_t element;
        std::size_t drawn;
    };

    const Progress& progress_;
    const Scene& scene_;
    const Scene& drawn_;
    double tolerance_;
    double reach_;
    int threads_;
    std::vector<Box> scene_boxes_;
    std::vector<Box> drawn_boxes_;
    std::vector<bool> taken_;
    std::vector<DrawnMatch> matches_;
    std::unordered_map<CellKey, Cell, CellHash> cells_;

    bool open(std::size_t element) const { return matches_[element].drawn < 0 && scene_.elements[element].verbatim.empty(); }

    void take(std::size_t element, std::size_t drawn, double deviation, bool same_style) {
        matches_[element] = {static_cast<int>(drawn), deviation, same_style};
        taken_[drawn] = true;
    }

    void match_verbatim() {
        std::map<std::string_view, std::vector<std::size_t>> fragments;  // last = lowest
        for (std::size_t j = drawn_.elements.size(); j-- > 0;) {
            if (!drawn_.elements[j].verbatim.empty()) fragments[drawn_.elements[j].verbatim].push_back(j);
        }
        for (std::size_t i = 0; i < scene_.elements.size(); ++i) {
            if (scene_.elements[i].verbatim.empty()) continue;
            const auto found = fragments.find(scene_.elements[i].verbatim);
            if (found == fragments.end() || found->second.empty()) continue;
            take(i, found->second.back(), 0, true);
            found->second.pop_back();
        }
    }

    double cell_index(double coordinate) const { return std::floor(coordinate / (2 * reach_)) + 0.0; }

    /// Where a drawn element's centre lies.
    Cell& cell_of(std::size_t drawn) {
        const Point p = center(drawn_boxes_[drawn]);
        return cells_[{cell_index(p.x), cell_index(p.y)}];
    }

    void fill_cells() {
        for (std::size_t j = 0; j < drawn_.elements.size(); ++j) {
            if (drawn_.elements[j].verbatim.empty()) cell_of(j).drawn.push_back(j);
        }
    }

    void pass_over_taken(Cell& cell) const {
        while (cell.first_free < cell.drawn.size() && taken_[cell.drawn[cell.first_free]]) ++cell.first_free;
    }

    /// The cells whose elements may have their centres within reach: two each way, three where a centre stands so nearly in
    /// the middle of its cell that rounding puts both ends of its reach into the cells beside it.
    std::vector<const Cell*> cells_near(Point p) const {
        std::vector<const Cell*> near;
        for (const double x : {p.x - reach_, p.x, p.x + reach_}) {
            for (const double y : {p.y - reach_, p.y, p.y + reach_}) {
                const auto found = cells_.find({cell_index(x), cell_index(y)});
                if (found != cells_.end() && std::find(near.begin(), near.end(), &found->second) == near.end()) {
                    near.push_back(&found->second);
                }
            }
        }
        return near;
    }

    /// Calls visit(drawn) for what is free in the cell, in paint order, until it returns false.
    template <class Visit>
    void visit_free(const Cell& cell, Visit visit) const {
        for (std::size_t k = cell.first_free; k < cell.drawn.size(); ++k) {
            if (!taken_[cell.drawn[k]] && !visit(cell.drawn[k])) return;
        }
    }

    double deviation(std::size_t element, std::size_t drawn) const {
        const Element& a = scene_.elements[element];
        const Element& b = drawn_.elements[drawn];
        const DeviationOptions options{reach_, accuracy_in_tolerances * tolerance_, tolerance_ / 4};
        const bool as_drawn = paints_stroke(a.style) || (all_closed(a.paths) && all_closed(b.paths));
        const double found = as_drawn ? outline_deviation(a.paths, b.paths, options)
                                      : outline_deviation(as_filled(a.paths), as_filled(b.paths), options);
        const bool winding_counts = paints_fill(a.style) && a.style.fill_rule == FillRule::nonzero;
        return found < reach_ && winding_counts && !wind_alike(a.paths, b.paths, std::max(found, tolerance_ / 4)) ? reach_
                                                                                                                  : found;
    }

    bool style_agrees(std::size_t element, std::size_t drawn) const {
        const Style& style = scene_.elements[element].style;
        Style other = drawn_.elements[drawn].style;
        // Gradients are compared where they are seen.
        const Box& outline = scene_boxes_[element];
        const double half_width = paints_stroke(style) ? style.stroke.width / 2 : 0;
        if (same_where_seen(style.fill, other.fill, outline)) other.fill = style.fill;
        if (same_where_seen(style.stroke.paint, other.stroke.paint, grown(outline, half_width)))
            other.stroke.paint = style.stroke.paint;
        return same_style(style, other, tolerance_);
    }

    bool same_where_seen(const Paint& a, const Paint& b, const Box& box) const {
        const auto* p = std::get_if<std::shared_ptr<const Gradient>>(&a);
        const auto* q = std::get_if<std::shared_ptr<const Gradient>>(&b);
        return p && q && same_gradient_in(**p, **q, box, tolerance_);
    }

    void match_exact() {
        const double exact = exact_in_tolerances * tolerance_;
        for (std::size_t i = 0; i < scene_.elements.size(); ++i) {
            report(progress_, stage, 0);
            if (!open(i)) continue;
            std::size_t best = drawn_.elements.size();
            double best_deviation = 0;
            for (const Cell* cell : cells_near(center(scene_boxes_[i]))) {
                visit_free(*cell, [&](std::size_t j) {
                    if (j >= best) return false;
                    if (box_distance(scene_boxes_[i], drawn_boxes_[j]) > exact || !style_agrees(i, j)) return true;
                    const double found = deviation(i, j);
                    if (found > exact) return true;
                    best = j;
                    best_deviation = found;
                    return false;
                });
            }
            if (best == drawn_.elements.size()) continue;
            take(i, best, best_deviation, true);
            pass_over_taken(cell_of(best));
        }
    }

    std::vector<std::size_t> nearest_free(std::size_t element, bool same_style_only) const {
        std::vector<std::pair<double, std::size_t>> near;
        for (const Cell* cell : cells_near(center(scene_boxes_[element]))) {
            visit_free(*cell, [&](std::size_t j) {
                const double apart = box_distance(scene_boxes_[element], drawn_boxes_[j]);
                if (apart <= reach_ && (!same_style_only || style_agrees(element, j))) near.emplace_back(apart, j);
                return true;
            });
        }
        const std::size_t kept = std::min(near.size(), candidates_per_round);
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
        std::vector<std::size_t> indices;
        for (std::size_t k = 0; k < kept; ++k) indices.push_back(near[k].second);
        return indices;
    }

    /// For each open element what is free near it.
    std::vector<Candidate> candidates_now(bool same_style_only) const {
        std::vector<std::size_t> still_open;
        for (std::size_t i = 0; i < scene_.elements.size(); ++i) {
            if (open(i)) still_open.push_back(i);
        }
        std::vector<std::vector<Candidate>> by_element(still_open.size());
        for_each_index(still_open.size(), threads_, stage, progress_, [&](std::size_t k, const Progress&) {
            const std::size_t i = still_open[k];
            for (const std::size_t j : nearest_free(i, same_style_only)) {
                const double found = deviation(i, j);
                const double step = std::floor(found / (step_in_tolerances * tolerance_));
                if (found < reach_) by_element[k].push_back({found, static_cast<std::int64_t>(step), i, j});
            }
        });
        std::vector<Candidate> candidates;
        for (const auto& some : by_element) candidates.insert(candidates.end(), some.begin(), some.end());
        return candidates;
    }

    void match_nearest(bool same_style_only) {
        for (int round = 0; round < rounds; ++round) {
            std::vector<Candidate> candidates = candidates_now(same_style_only);
            if (candidates.empty()) return;
            std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
                return std::tie(a.step, a.element, a.drawn) < std::tie(b.step, b.element, b.drawn);
            });
            for (const Candidate& c : candidates) {
                if (!open(c.element) || taken_[c.drawn]) continue;
                take(c.element, c.drawn, c.deviation, same_style_only);
                pass_over_taken(cell_of(c.drawn));
            }
        }
    }
};

}  // namespace

std::vector<DrawnMatch> match_drawn(const Scene& scene, const Scene& drawn, double tolerance, int threads,
                                    const Progress& progress) {
    return Matcher(scene, drawn, tolerance, threads, progress).run();
}

}  // namespace rinceau

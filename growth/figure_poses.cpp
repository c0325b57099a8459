#include "growth/figure_poses.h"

#include <algorithm>
#include <cmath>

#include "growth/figure_shapes.h"
#include "scene/path.h"

namespace rinceau {
namespace {

int color_number(const std::optional<Color>& color) {
    return color ? (color->red << 16) + (color->green << 8) + color->blue : -1;
}

const Terminal& terminal_of(const FigureParts& parts, const Placement& placement) {
    return parts.grammar.terminals[static_cast<std::size_t>(placement.terminal)];
}

std::vector<int> look_of(const FigureParts& parts, int part) {
    const Placement& p = parts.parts[static_cast<std::size_t>(part)].placement;
    const int style = p.style != 0 ? p.style : terminal_of(parts, p).style;
    return {p.terminal, style, color_number(p.repaint.fill), color_number(p.repaint.stroke)};
}

/// A point that moves with the terminal.
Point middle(const FigureParts& parts, int part) {
    const Placement& placement = parts.parts[static_cast<std::size_t>(part)].placement;
    const Terminal& terminal = terminal_of(parts, placement);
    const Box box = terminal.verbatim.empty() ? bounds(terminal.paths) : terminal.verbatim_box;
    return apply(placement.pose, center(box));
}

/// Tries maps from one group to another.
class FigureMatch {
  public:
    FigureMatch(const FigureParts& parts, const std::vector<int>& from, const std::vector<int>& to)
        : parts_(parts), from_(from), to_(to) {
        Box box;
        for (const int i : from) box = including(box, part(i).box);
        size_ = diagonal(box);
        for (const int i : from) from_looks_.push_back(look_of(parts, i));
        for (const int i : to) to_looks_.push_back(look_of(parts, i));
    }

    std::optional<Similarity> map() const {
        const std::size_t first = rarest();
        for (std::size_t q = 0; q < to_.size(); ++q) {
            if (to_looks_[q] != from_looks_[first]) continue;
            const Similarity by_pose = part(to_[q]).placement.pose * inverse(part(from_[first]).placement.pose);
            if (fits(by_pose)) return by_pose;
            if (const auto by_places = map_by_places(first, q)) return by_places;
        }
        return {};
    }

  private:
    const FigurePart& part(int i) const { return parts_.parts[static_cast<std::size_t>(i)]; }

    std::size_t rarest() const {
        const auto copies = [&](std::size_t i) { return std::ranges::count(from_looks_, from_looks_[i]); };
        std::size_t best = 0;
        for (std::size_t i = 1; i < from_.size(); ++i)
            if (copies(i) < copies(best)) best = i;
        return best;
    }

    /// Round and symmetric shapes have no angle of their own: then two places tell it.
    std::optional<Similarity> map_by_places(std::size_t first, std::size_t q) const {
        const Point p0 = middle(parts_, from_[first]);
        const Point q0 = middle(parts_, to_[q]);
        std::size_t far = first;
        for (std::size_t i = 0; i < from_.size(); ++i)
            if (abs(middle(parts_, from_[i]) - p0) > abs(middle(parts_, from_[far]) - p0)) far = i;
        const Point p1 = middle(parts_, from_[far]) - p0;
        if (!(abs(p1) > tolerance * size_)) return {};
        for (std::size_t r = 0; r < to_.size(); ++r) {
            if (r == q || to_looks_[r] != from_looks_[far]) continue;
            const Point q1 = middle(parts_, to_[r]) - q0;
            if (!(abs(q1) > 0)) continue;
            for (const bool mirrored : {false, true}) {
                Similarity map{q1 / flipped_if(mirrored, p1), {}, mirrored};
                map.translation = q0 - apply(map, p0);
                if (fits(map)) return map;
            }
        }
        return {};
    }

    bool fits(const Similarity& map) const {
        const double scale = scale_of(map);
        if (!std::isfinite(scale)) return false;
        const double slack = tolerance * size_ * scale;
        std::vector<bool> taken(to_.size());
        for (std::size_t i = 0; i < from_.size(); ++i) {
            const Region moved = transformed(part(from_[i]).region, map);
            const Point middle_moved = center(bounds(moved));
            bool found = false;
            for (std::size_t j = 0; j < to_.size() && !found; ++j) {
                if (taken[j] || to_looks_[j] != from_looks_[i]) continue;
                if (abs(center(part(to_[j]).box) - middle_moved) > 2 * slack) continue;
                found = same_outline(moved, part(to_[j]).region, slack);
                if (found) taken[j] = true;
            }
            if (!found) return false;
        }
        return true;
    }

    static constexpr double tolerance = 0.01;
    const FigureParts& parts_;
    const std::vector<int>& from_;
    const std::vector<int>& to_;
    std::vector<std::vector<int>> from_looks_, to_looks_;
    double size_ = 0;
};

}  // namespace

std::vector<std::vector<int>> looks_of(const FigureParts& parts, const std::vector<int>& group) {
    std::vector<std::vector<int>> looks;
    for (const int part : group) looks.push_back(look_of(parts, part));
    std::ranges::sort(looks);
    return looks;
}

std::optional<Similarity> same_figure(const FigureParts& parts, const std::vector<int>& from, const std::vector<int>& to) {
    if (from.size() != to.size()) return {};
    return FigureMatch(parts, from, to).map();
}

}  // namespace rinceau

#include "analyzer/shape_looks.h"

#include <algorithm>
#include <map>

#include "analyzer/outline_deviation.h"
#include "analyzer/painted_form.h"

namespace rinceau {

namespace {

bool same_symmetry(const SymmetryGroup& a, const SymmetryGroup& b) {
    constexpr double same_turn = 1e-3;  // radians: far less than between elements of a group of at most 96
    if (a.continuous != b.continuous || a.elements.size() != b.elements.size()) return false;
    return std::ranges::all_of(a.elements, [&](const Similarity& s) {
        return std::ranges::any_of(b.elements, [&](const Similarity& t) {
            return s.mirrored == t.mirrored && abs(s.linear - t.linear) < same_turn;
        });
    });
}

/// Of the diagonal: far less than what is seen, so that it may come on top of all other deviations.
constexpr double unseen_share = 1e-5;

class LookMerger {
  public:
    LookMerger(const Instancing& instancing, double diagonal) : looks_(instancing.looks), diagonal_(diagonal) {
        largest_scale_.resize(looks_.size(), 0);
        for (const Instance& instance : instancing.instances) {
            double& largest = largest_scale_[static_cast<std::size_t>(instance.look)];
            largest = std::max(largest, scale_of(instance.pose));
        }
    }

    /// Looks that become one; the first of each list has the outline.
    std::vector<std::vector<int>> groups() const {
        std::vector<std::vector<int>> groups;
        std::map<int, std::vector<std::size_t>> groups_of_shape;
        for (std::size_t k = 0; k < looks_.size(); ++k) {
            std::vector<std::size_t>& candidates = groups_of_shape[looks_[k].shape];
            const bool placed = looks_[k].verbatim.empty() && std::ranges::any_of(candidates, [&](std::size_t g) {
                return joined(groups[g], static_cast<int>(k));
            });
            if (placed) continue;
            candidates.push_back(groups.size());
            groups.push_back({static_cast<int>(k)});
        }
        return groups;
    }

  private:
    const Look& look(int l) const { return looks_[static_cast<std::size_t>(l)]; }

    /// Does the outline of `a` draw what `b` draws, in the style of `b`? Both lie in the unit frame of their shape.
    bool outline_serves(int a, int b) const {
        constexpr double same_start = 1e-3;  // unit lengths: a start point that may be moved unseen
        const PaintedForm form_a = painted_form(Element{look(a).paths, look(b).unit_style}, Similarity{});
        const PaintedForm form_b = painted_form(Element{look(b).paths, look(b).unit_style}, Similarity{});
        if (!same_form(form_a, form_b) || !same_starts(form_a, Similarity{}, form_b, same_start)) return false;
        const double allowed = unseen_share * diagonal_ / std::max(largest_scale_[static_cast<std::size_t>(b)], 1e-12);
        return outline_deviation(look(a).paths, look(b).paths, {2 * allowed, allowed / 4, allowed / 4}) <= allowed;
    }

    /// Takes the look into the group if one outline serves all.
    bool joined(std::vector<int>& group, int with) const {
        if (!look(group.front()).verbatim.empty() || !same_symmetry(look(group.front()).symmetry, look(with).symmetry)) return false;
        const bool serves = outline_serves(group.front(), with);
        if (!serves && !std::ranges::all_of(group, [&](int l) { return outline_serves(with, l); })) return false;
        group.push_back(with);
        if (!serves) std::swap(group.front(), group.back());
        return true;
    }

    const std::vector<Look>& looks_;
    double diagonal_;
    std::vector<double> largest_scale_;
};

}  // namespace

std::optional<Instancing> merged_by_shape(const Instancing& instancing, double diagonal) {
    const std::vector<Look>& looks = instancing.looks;
    const std::vector<std::vector<int>> groups = LookMerger(instancing, diagonal).groups();
    if (groups.size() == looks.size()) return std::nullopt;
    std::vector<int> times(looks.size(), 0);
    for (const Instance& instance : instancing.instances) ++times[static_cast<std::size_t>(instance.look)];
    Instancing merged{.shapes = instancing.shapes, .styles = instancing.styles};
    std::vector<std::pair<int, int>> place(looks.size());  // (look, tint)
    for (const std::vector<int>& group : groups) {
        Look look = looks[static_cast<std::size_t>(group.front())];
        const auto commonest = std::ranges::max_element(group, {}, [&](int l) { return times[static_cast<std::size_t>(l)]; });
        look.unit_style = looks[static_cast<std::size_t>(*commonest)].unit_style;
        look.style = looks[static_cast<std::size_t>(*commonest)].style;
        for (std::size_t k = 0; k < group.size(); ++k) {
            place[static_cast<std::size_t>(group[k])] = {static_cast<int>(merged.looks.size()), static_cast<int>(k)};
            if (group.size() > 1) look.tints.push_back(looks[static_cast<std::size_t>(group[k])].unit_style);
        }
        merged.looks.push_back(std::move(look));
    }
    for (const Instance& instance : instancing.instances) {
        const auto [look, tint] = place[static_cast<std::size_t>(instance.look)];
        merged.instances.push_back({look, instance.pose, tint});
    }
    return merged;
}

}  // namespace rinceau

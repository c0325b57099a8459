#include "analyzer/symmetry_rules.h"

#include <algorithm>
#include <cmath>

#include "analyzer/item_copies.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

using Orbits = std::vector<std::vector<int>>;

Item& item_at(SearchState& state, int item) { return state.rules.items[static_cast<std::size_t>(item)]; }

/// Orbits of a rotation, each begun with its member in a sector that begins in the widest gap between the items' directions.
Orbits cut_into_sectors(const SearchState& state, const SceneSymmetry& symmetry) {
    const double sector = two_pi / symmetry.group.fold;
    const auto angle_modulo = [&](int item, double begin, double period) {
        const double angle = std::fmod(arg(state.item(item).pose.translation - symmetry.group.centre) - begin, period);
        return angle < 0 ? angle + period : angle;
    };
    std::vector<double> directions;
    for (const std::vector<int>& orbit : symmetry.orbits) directions.push_back(angle_modulo(orbit.front(), 0, sector));
    std::ranges::sort(directions);
    double start = directions.front(), widest = directions.front() + sector - directions.back();
    for (std::size_t k = 0; k + 1 < directions.size(); ++k) {
        const double gap = directions[k + 1] - directions[k];
        if (gap > widest + 1e-9) {
            widest = gap;
            start = directions[k + 1];
        }
    }
    // Half a gap back, so that rounding does not tear what stands in one direction.
    const double begin = start - 0.5 * widest;
    Orbits turned = symmetry.orbits;
    for (std::vector<int>& orbit : turned) {
        std::rotate(orbit.begin(),
                    std::ranges::min_element(orbit, {}, [&](int i) { return angle_modulo(i, begin, two_pi); }), orbit.end());
    }
    return turned;
}

class Opening {
  public:
    Opening(SearchState state, const SceneSymmetry& symmetry, const SearchOptions& options, const Progress& progress)
        : state_(std::move(state)), symmetry_(symmetry), group_(symmetry.group), options_(options), progress_(progress) {}

    SearchState run() {
        const Orbits orbits = group_.mirrored ? symmetry_.orbits : cut_into_sectors(state_, symmetry_);
        sort_out(orbits);
        const std::vector<Similarity> drawn = take_mean_poses(orbits);
        Copier copier(state_, orbits);
        std::vector<int> sector = group_.mirrored ? mirrored_halves(copier) : rules_of(inner_);
        if (group_.fold == 1) {
            whole_ = add_group(state_, sector, pivot_on_axis());
        } else {
            if (group_.mirrored) append(sector, rules_of(on_axis_));
            sector_pivot_ = sector_pivot(sector);
            whole_ = add_ring(copier, grouped(sector, sector_pivot_));
        }
        take_drawn_poses(orbits, drawn);
        keep_alive(state_, listed_rest_);
        for (const int item : unlisted_rest_) item_at(state_, item).alive = true;
        item_at(state_, whole_).alive = true;
        return std::move(state_);
    }

  private:
    static void append(std::vector<int>& items, const std::vector<int>& more) {
        items.insert(items.end(), more.begin(), more.end());
    }

    /// What becomes of each item: inside of a sector or half, on a mirror axis of a sector, or left in place.
    void sort_out(const Orbits& orbits) {
        std::vector<char> moved(state_.rules.items.size(), 0);
        for (const std::vector<int>& orbit : orbits) {
            const bool on_axis = symmetry_.on_axis(orbit);
            if (on_axis && group_.fold == 1) continue;
            (on_axis ? on_axis_ : inner_).push_back(orbit.front());
            for (const int item : orbit) moved[static_cast<std::size_t>(item)] = 1;
        }
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const int item = static_cast<int>(i);
            if (!state_.item(item).alive || moved[i]) continue;
            const bool listed = std::ranges::binary_search(state_.alive(state_.item(item).part), item);
            (listed ? listed_rest_ : unlisted_rest_).push_back(item);
        }
    }

    /// The items that rules are made of stand at the mean of their images, each turned back: better than any one of them.
    /// Returns the poses that they are drawn in.
    std::vector<Similarity> take_mean_poses(const Orbits& orbits) {
        std::vector<Similarity> drawn;
        for (const std::vector<int>& orbit : orbits) {
            Item& first = item_at(state_, orbit.front());
            drawn.push_back(first.pose);
            const Part& part = state_.part(first.part);
            Complex linear{};
            Point place;
            for (std::size_t k = 0; k < orbit.size(); ++k) {
                const Similarity map = group_.map(k), wanted = map * drawn.back();
                const Similarity image = inverse(map) * nearest_pose(part, state_.item(orbit[k]).pose, wanted);
                linear += image.linear;
                place += image.translation;
            }
            const double share = 1 / static_cast<double>(orbit.size());
            first.pose = {share * linear, share * place, first.pose.mirrored};
        }
        return drawn;
    }

    void take_drawn_poses(const Orbits& orbits, const std::vector<Similarity>& drawn) {
        for (std::size_t o = 0; o < orbits.size(); ++o) {
            Item& first = item_at(state_, orbits[o].front());
            first.pose = nearest_pose(state_.part(first.part), drawn[o], first.pose);
        }
    }

    std::vector<int> rules_of(const std::vector<int>& items) {
        if (items.empty()) return {};
        keep_alive(state_, items);
        state_ = generate_rules(std::move(state_), options_, progress_);
        return root_items(state_.rules);
    }

    /// One item, a group if there are several.
    int grouped(const std::vector<int>& items, const Similarity& pivot) {
        return items.size() == 1 ? items.front() : add_group(state_, items, pivot);
    }

    /// The rules of one half, and both halves.
    std::vector<int> mirrored_halves(Copier& copier) {
        const std::vector<int> roots = rules_of(inner_);
        if (roots.empty()) return {};
        const Similarity pivot = group_.fold == 1 ? pivot_on_axis() : turtle_at(group_.centre, group_.axis);
        const int half = grouped(roots, pivot);
        const int other = copier.copy(half, group_.map(1), [](std::size_t) { return std::size_t{1}; });
        return {half, other};
    }

    int add_ring(Copier& copier, int sector) {
        const Similarity first = state_.item(sector).pose;
        const Similarity whole{first.linear, group_.centre, first.mirrored};
        const std::size_t stride = group_.mirrored ? 2 : 1;
        Rule rule;
        rule.kind = RuleKind::ring;
        rule.repeated = state_.item(sector).part;
        Part part;
        part.count = group_.fold;
        std::vector<int> members;
        for (std::size_t k = 0; k < static_cast<std::size_t>(group_.fold); ++k) {
            const Similarity about = group_.map(stride * k);
            part.children.push_back({rule.repeated, inverse(whole) * about * first});
            members.push_back(k == 0 ? sector
                                     : copier.copy(sector, about, [&](std::size_t index) { return index + stride * k; }));
            if (k == 1) rule.step = inverse(first) * about * first;
        }
        part.pivot = inverse(whole) * sector_pivot_;
        const int ring = add_part(state_, std::move(rule), std::move(part));
        return add_item(state_, ring, whole, std::move(members));
    }

    /// A turtle that heads along `heading` (unit).
    static Similarity turtle_at(Point place, Complex heading) { return {heading * Complex{0, -1}, place, false}; }

    /// The foot of the half's middle on the mirror axis.
    Similarity pivot_on_axis() const {
        Point mean;
        for (const int item : inner_) mean += state_.item(item).pose.translation;
        mean = mean / static_cast<double>(std::max<std::size_t>(1, inner_.size()));
        const Point foot = group_.centre + dot(mean - group_.centre, group_.axis) * group_.axis;
        return turtle_at(foot, group_.axis);
    }

    /// The centre, facing the mirror axis of the sector or else its first member.
    Similarity sector_pivot(const std::vector<int>& sector) const {
        if (group_.mirrored || sector.empty()) return turtle_at(group_.centre, group_.axis);
        const Point ahead = state_.item(sector.front()).pose.translation - group_.centre;
        return turtle_at(group_.centre, norm(ahead) > 0 ? ahead / abs(ahead) : Complex{0, 1});
    }

    SearchState state_;
    const SceneSymmetry& symmetry_;
    const PointGroup& group_;
    const SearchOptions& options_;
    const Progress& progress_;
    std::vector<int> inner_, on_axis_, listed_rest_, unlisted_rest_;
    Similarity sector_pivot_;
    int whole_ = -1;
};

}  // namespace

SearchState open_with_symmetry(SearchState state, const SceneSymmetry& symmetry, const SearchOptions& options,
                               const Progress& progress) {
    return Opening(std::move(state), symmetry, options, progress).run();
}

}  // namespace rinceau

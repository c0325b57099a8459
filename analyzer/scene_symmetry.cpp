#include "analyzer/scene_symmetry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "analyzer/pose_grid.h"

namespace rinceau {

namespace {

constexpr double least_moved_share = 0.5;     // of the items that a symmetry must move to be tried
constexpr std::size_t items_sampled = 60;     // to see whether a candidate is worth looking up every item
constexpr double least_sample_share = 0.25;   // of the sample that must have an image
constexpr std::size_t looked_up_in_full = 8;  // candidates
constexpr double least_mirror_share = 0.9;    // of what the turns alone save, for mirrors that leave some of it
constexpr std::size_t kept = 2;               // symmetries

/// All listed items by part, for look-up.
class Drawing {
  public:
    explicit Drawing(const SearchState& state) : state_(state), grid_of_part_(state.members.size(), -1) {
        for (std::size_t p = 0; p < state.members.size(); ++p) {
            if (state.members[p].empty()) continue;
            grid_of_part_[p] = static_cast<int>(grids_.size());
            grids_.emplace_back(state.rules, static_cast<int>(p), state.members[p]);
            items_.insert(items_.end(), state.members[p].begin(), state.members[p].end());
        }
    }
    const SearchState& state() const { return state_; }
    const std::vector<int>& items() const { return items_; }

    /// The item that stands where the map takes `item`, or -1. Exact copies about an exact centre: the error of the centre
    /// counts for all alike.
    int image(int item, const Similarity& map) const {
        const PoseTolerance tolerance{2 * state_.tolerance.size, 2 * state_.tolerance.angle, 0};
        const Item& at = state_.item(item);
        const PoseGrid& grid = grids_[static_cast<std::size_t>(grid_of_part_[static_cast<std::size_t>(at.part)])];
        const auto match = grid.find(map * at.pose, 0, tolerance);
        return match ? match->item : -1;
    }

  private:
    const SearchState& state_;
    std::vector<int> grid_of_part_;
    std::vector<PoseGrid> grids_;
    std::vector<int> items_;
};

/// Share of a sample of the items that the group's first map takes onto another item.
double sampled_share(const Drawing& drawing, const PointGroup& group) {
    const Similarity map = group.map(1);
    const std::vector<int>& items = drawing.items();
    const std::size_t count = std::min(items.size(), items_sampled);
    std::size_t moved = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const int item = items[k * items.size() / count];
        const int image = drawing.image(item, map);
        if (image >= 0 && image != item) ++moved;
        // A quarter of the sample without any image is enough to give up.
        if (moved == 0 && 4 * k > count + 16) return 0;
    }
    return static_cast<double>(moved) / static_cast<double>(count);
}

/// Images of an item under all maps, as SceneSymmetry wants them; nothing if one is missing or they do not fit together.
std::optional<std::vector<int>> orbit_from(const Drawing& drawing, const PointGroup& group, const std::vector<Similarity>& maps,
                                           int item) {
    std::vector<int> orbit;
    for (const Similarity& map : maps) {
        orbit.push_back(drawing.image(item, map));
        if (orbit.back() < 0) return std::nullopt;
    }
    if (orbit.front() != item) return std::nullopt;
    std::vector<int> distinct = orbit;
    std::ranges::sort(distinct);
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    if (distinct.size() == orbit.size()) return orbit;
    // On a mirror axis every item comes twice.
    const bool on_axis = group.mirrored && distinct.size() == static_cast<std::size_t>(group.fold);
    return on_axis ? std::optional(orbit) : std::nullopt;
}

std::vector<Similarity> maps_of(const PointGroup& group) {
    std::vector<Similarity> maps;
    for (std::size_t k = 0; k < group.order(); ++k) maps.push_back(group.map(k));
    return maps;
}

std::vector<std::vector<int>> orbits_of(const Drawing& drawing, const PointGroup& group) {
    const std::vector<Similarity> maps = maps_of(group);
    std::vector<std::vector<int>> orbits;
    std::vector<char> used(drawing.state().rules.items.size(), 0);
    for (const int start : drawing.items()) {
        if (used[static_cast<std::size_t>(start)]) continue;
        auto orbit = orbit_from(drawing, group, maps, start);
        if (!orbit) continue;
        const bool fresh = std::ranges::none_of(*orbit, [&](int i) { return used[static_cast<std::size_t>(i)] != 0; });
        if (!fresh) continue;
        for (const int item : *orbit) used[static_cast<std::size_t>(item)] = 1;
        orbits.push_back(std::move(*orbit));
    }
    return orbits;
}

/// Centre and axis that fit the orbits best: as good as the drawing's numbers.
PointGroup refined(const SearchState& state, PointGroup group, const std::vector<std::vector<int>>& orbits) {
    Point mean;
    double count = 0;
    for (const std::vector<int>& orbit : orbits) {
        for (const int item : orbit) mean += state.item(item).pose.translation;
        count += static_cast<double>(orbit.size());
    }
    if (count == 0) return group;
    mean = mean / count;
    // (Of a mirror alone this is a point of the axis.)
    group.centre = mean;
    if (!group.mirrored) return group;
    Complex sum{};
    for (const std::vector<int>& orbit : orbits) {
        for (std::size_t k = 0; k < orbit.size(); k += 2) {
            // Turned back into the first sector, the item and its mirror image.
            const Similarity back = inverse(group.map(k));
            const Point item = apply(back, state.item(orbit[k]).pose.translation) - mean;
            const Point image = apply(back, state.item(orbit[k + 1]).pose.translation) - mean;
            if (orbit[k] != orbit[k + 1]) sum += item * image;
        }
    }
    if (norm(sum) > 0) {
        const Complex axis = polar(1, 0.5 * arg(sum));
        group.axis = dot(axis, group.axis) < 0 ? -axis : axis;
    }
    return group;
}

/// Orbits that begin in the half sector that follows the mirror axis counter-clockwise.
std::vector<std::vector<int>> from_first_half_sector(const Drawing& drawing, const PointGroup& group,
                                                     const std::vector<std::vector<int>>& orbits) {
    constexpr double on_border = 1e-3;  // radians: an item there lies on the border, whichever side rounding puts it
    const double half_sector = pi / group.fold;
    const std::vector<Similarity> maps = maps_of(group);
    std::vector<std::vector<int>> begun;
    for (const std::vector<int>& orbit : orbits) {
        // How far outside of the half sector; the lowest item among equals.
        const auto outside = [&](int item) {
            const Point from_centre = drawing.state().item(item).pose.translation - group.centre;
            const double angle = arg(conj(group.axis) * from_centre);
            const double out = std::max({0.0, -angle - on_border, angle - half_sector - on_border});
            return std::pair{group.fold == 1 && out > pi - 2 * on_border ? 0.0 : out, item};
        };
        const int start = *std::ranges::min_element(orbit, {}, outside);
        auto turned = orbit_from(drawing, group, maps, start);
        if (!turned) continue;
        const bool own_image = std::ranges::count(*turned, start) > 1;
        const std::size_t last_turn = turned->size() - 2;
        if (!own_image || (*turned)[1] == (*turned)[0] || (*turned)[1] == (*turned)[last_turn]) begun.push_back(std::move(*turned));
    }
    return begun;
}

double saved_bits(const SearchState& state, const SceneSymmetry& symmetry) {
    double bits = 0;
    for (const std::vector<int>& orbit : symmetry.orbits) {
        const int distinct = symmetry.on_axis(orbit) ? symmetry.group.fold : static_cast<int>(orbit.size());
        bits += (distinct - 1) * state.cost(state.item(orbit.front()).part).item_bits;
    }
    return bits;
}

/// Items that have another item as their image.
double moved_items(const SceneSymmetry& symmetry) {
    double moved = 0;
    for (const std::vector<int>& orbit : symmetry.orbits) {
        moved += symmetry.on_axis(orbit) ? (symmetry.group.fold > 1 ? symmetry.group.fold : 0) : static_cast<double>(orbit.size());
    }
    return moved;
}

std::optional<SceneSymmetry> looked_up(const Drawing& drawing, const PointGroup& group) {
    SceneSymmetry symmetry{group, orbits_of(drawing, group), 0};
    if (symmetry.orbits.empty()) return std::nullopt;
    symmetry.group = refined(drawing.state(), group, symmetry.orbits);
    symmetry.orbits = orbits_of(drawing, symmetry.group);
    if (symmetry.group.mirrored) symmetry.orbits = from_first_half_sector(drawing, symmetry.group, symmetry.orbits);
    symmetry.saved_bits = saved_bits(drawing.state(), symmetry);
    return symmetry;
}

/// Directions of possible mirror axes through the centre of a turning symmetry, in [0, pi / fold), the most agreed upon first:
/// items of some orbits, those of rare parts first, ask which axis takes them to a copy of theirs at the same distance.
std::vector<double> axis_directions(const Drawing& drawing, const SceneSymmetry& turning) {
    constexpr std::size_t orbits_asked = 16, partners_asked = 100, tried = 3;
    constexpr double angle_cell = 0.01;  // radians
    const SearchState& state = drawing.state();
    const PointGroup& group = turning.group;
    const auto from_centre = [&](int item) { return state.item(item).pose.translation - group.centre; };
    std::vector<std::size_t> count(state.rules.parts.size(), 0);
    const auto part_of = [&](std::size_t o) { return static_cast<std::size_t>(state.item(turning.orbits[o].front()).part); };
    std::vector<std::size_t> asked;
    for (std::size_t o = 0; o < turning.orbits.size(); ++o) {
        ++count[part_of(o)];
        asked.push_back(o);
    }
    std::ranges::stable_sort(asked, {}, [&](std::size_t o) { return count[part_of(o)]; });
    if (asked.size() > orbits_asked) asked.resize(orbits_asked);

    std::map<std::int64_t, std::pair<std::size_t, double>> cells;  // votes, sum of angles
    for (const std::size_t o : asked) {
        const int first = turning.orbits[o].front();
        const double reach = abs(from_centre(first)), slack = 2 * state.tolerance.size * scale_of(state.item(first).pose);
        if (reach <= slack) continue;
        std::size_t partners = 0;
        for (std::size_t q = 0; q < turning.orbits.size() && partners < partners_asked; ++q) {
            const int partner = turning.orbits[q].front();
            if (part_of(q) != part_of(o) || std::abs(abs(from_centre(partner)) - reach) > slack) continue;
            ++partners;
            const double direction = 0.5 * arg(from_centre(first) * from_centre(partner));
            if (drawing.image(first, reflection(group.centre, polar(1, direction))) < 0) continue;
            const double sector = pi / group.fold, angle = direction - sector * std::floor(direction / sector);
            auto& [votes, sum] = cells[std::llround(angle / angle_cell)];
            ++votes;
            sum += angle;
        }
    }
    std::vector<std::pair<std::size_t, double>> ranked;
    for (const auto& [unused, cell] : cells) ranked.emplace_back(cell.first, cell.second / static_cast<double>(cell.first));
    std::ranges::stable_sort(ranked, [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<double> directions;
    for (const auto& [unused, angle] : ranked) {
        if (directions.size() < tried) directions.push_back(angle);
    }
    return directions;
}

/// The turning symmetry with mirror axes through its centre that moves as much as it can.
std::optional<SceneSymmetry> with_mirrors(const Drawing& drawing, const SceneSymmetry& turning) {
    std::optional<SceneSymmetry> best;
    for (const double direction : axis_directions(drawing, turning)) {
        PointGroup group = turning.group;
        group.mirrored = true;
        group.axis = polar(1, direction);
        if (sampled_share(drawing, {group.centre, 1, true, group.axis}) < least_sample_share) continue;
        auto symmetry = looked_up(drawing, group);
        if (symmetry && (!best || symmetry->saved_bits > best->saved_bits)) best = std::move(symmetry);
    }
    return best;
}

bool same_group(const PointGroup& a, const PointGroup& b, double near) {
    if (a.fold != b.fold || a.mirrored != b.mirrored) return false;
    if (a.fold > 1) return abs(a.centre - b.centre) <= near;
    return std::abs(cross(a.axis, b.axis)) < 0.01 && std::abs(cross(a.axis, b.centre - a.centre)) <= near;
}

}  // namespace

std::vector<SceneSymmetry> find_scene_symmetries(const SearchState& state) {
    const Drawing drawing(state);
    if (drawing.items().size() < 4) return {};
    const double least_moved = least_moved_share * static_cast<double>(drawing.items().size());

    // The candidates whose sample is moved most; higher folds first among equals.
    struct Sampled {
        PointGroup group;
        double promise = 0;
    };
    std::vector<Sampled> sampled;
    for (const PointGroup& group : vote_for_point_groups(state)) {
        const bool known = std::ranges::any_of(
            sampled, [&](const Sampled& other) { return same_group(group, other.group, 1e-3 * state.diagonal); });
        if (known) continue;
        const double share = sampled_share(drawing, group);
        if (share < least_sample_share) continue;
        const auto order = static_cast<double>(group.order());
        sampled.push_back({group, share * (order - 1) / order});
    }
    std::ranges::stable_sort(sampled, [](const Sampled& a, const Sampled& b) { return a.promise > b.promise; });
    if (sampled.size() > looked_up_in_full) sampled.resize(looked_up_in_full);

    std::vector<SceneSymmetry> found;
    for (const Sampled& candidate : sampled) {
        auto symmetry = looked_up(drawing, candidate.group);
        if (!symmetry || moved_items(*symmetry) < least_moved) continue;
        if (!symmetry->group.mirrored) {
            auto mirrored = with_mirrors(drawing, *symmetry);
            if (mirrored && mirrored->saved_bits > least_mirror_share * symmetry->saved_bits) found.push_back(std::move(*mirrored));
        }
        found.push_back(std::move(*symmetry));
    }
    std::ranges::stable_sort(found,
                             [](const SceneSymmetry& a, const SceneSymmetry& b) { return a.saved_bits > b.saved_bits; });
    if (found.size() > kept) found.resize(kept);
    return found;
}

}  // namespace rinceau

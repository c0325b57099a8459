#include "analyzer/scene_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rinceau {

namespace {

constexpr std::array folds{2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 15, 16, 18, 20, 24, 30, 32, 36};
constexpr double centre_cell = 0.004;        // of the diagonal
constexpr std::size_t items_asked = 40;      // of each part
constexpr std::size_t partners_asked = 120;  // of each of these
constexpr std::size_t candidates_tried = 60;

Complex turn_of(int fold) { return polar(1, two_pi / fold); }

struct Candidate {
    Point centre;
    int fold = 2;
    int votes = 0;
};

/// Centres about which an n-fold turn takes one item of a part onto another.
std::vector<Candidate> candidates_of(const SearchState& state) {
    struct Sum {
        Point centre;
        int votes = 0;
    };
    const double cell = centre_cell * state.diagonal;
    std::array<Complex, folds.size()> turns;
    for (std::size_t f = 0; f < folds.size(); ++f) turns[f] = turn_of(folds[f]);
    std::map<std::tuple<int, std::int64_t, std::int64_t>, Sum> sums;
    for (std::size_t p = 0; p < state.members.size(); ++p) {
        const Part& part = state.part(static_cast<int>(p));
        const std::vector<int>& items = state.members[p];
        const std::size_t stride = 1 + items.size() / items_asked, step = 1 + items.size() / partners_asked;
        for (std::size_t i = 0; i < items.size(); i += stride) {
            const Similarity& from = state.item(items[i]).pose;
            for (std::size_t j = 0; j < items.size(); j += step) {
                const Similarity& to = state.item(items[j]).pose;
                if (i == j || std::abs(scale_of(to) / scale_of(from) - 1) > state.tolerance.turn(part.radius)) continue;
                for (std::size_t f = 0; f < folds.size(); ++f) {
                    const Complex turn = turns[f];
                    const Similarity turned{turn * from.linear, to.translation, from.mirrored};
                    if (matching_gauge(part, to, turned, state.tolerance.turn(part.radius)) < 0) continue;
                    const Point centre = (to.translation - turn * from.translation) / (Complex{1, 0} - turn);
                    Sum& sum = sums[{folds[f], std::llround(centre.x / cell), std::llround(centre.y / cell)}];
                    sum.centre += centre;
                    ++sum.votes;
                }
            }
        }
    }
    std::vector<Candidate> candidates;
    for (const auto& [key, sum] : sums) {
        if (sum.votes >= 2) candidates.push_back({sum.centre / sum.votes, std::get<0>(key), sum.votes});
    }
    std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) { return a.votes > b.votes; });
    if (candidates.size() > candidates_tried) candidates.resize(candidates_tried);
    return candidates;
}

Similarity rotation_about(Point centre, Complex turn) { return {turn, centre - turn * centre, false}; }

/// Items that the rotation takes round through `fold` different items and back.
std::vector<std::vector<int>> orbits_of(const SearchState& state, const std::vector<PoseGrid>& grids, Point centre,
                                        int fold) {
    const Similarity rotation = rotation_about(centre, turn_of(fold));
    // Exact copies about an exact centre: the error of the centre counts for all alike.
    const PoseTolerance tolerance{2 * state.tolerance.size, 2 * state.tolerance.angle, 0};
    std::vector<std::vector<int>> orbits;
    std::vector<char> used(state.rules.items.size(), 0);
    for (const PoseGrid& grid : grids) {
        for (const int start : state.alive(grid.part())) {
            std::vector<int> orbit{start};
            Similarity at = state.item(start).pose;
            while (static_cast<int>(orbit.size()) <= fold) {
                at = rotation * at;
                const auto match = grid.find(at, 0, tolerance);
                if (!match || used[static_cast<std::size_t>(match->item)]) break;
                orbit.push_back(match->item);
                at.translation = state.item(match->item).pose.translation;
            }
            const bool closes = static_cast<int>(orbit.size()) == fold + 1 && orbit.back() == start;
            orbit.pop_back();
            std::vector<int> sorted = orbit;
            std::ranges::sort(sorted);
            if (!closes || std::ranges::adjacent_find(sorted) != sorted.end()) continue;
            for (const int item : orbit) used[static_cast<std::size_t>(item)] = 1;
            orbits.push_back(std::move(orbit));
        }
    }
    return orbits;
}

/// The mean of the orbits' centres, each as good as the drawing's numbers.
Point refined_centre(const SearchState& state, const std::vector<std::vector<int>>& orbits) {
    Point sum;
    double count = 0;
    for (const std::vector<int>& orbit : orbits) {
        for (const int item : orbit) sum += state.item(item).pose.translation;
        count += static_cast<double>(orbit.size());
    }
    return sum / count;
}

}  // namespace

std::optional<SceneRotation> find_scene_rotation(const SearchState& state) {
    std::size_t living = 0;
    std::vector<PoseGrid> grids;
    for (std::size_t p = 0; p < state.members.size(); ++p) {
        living += state.members[p].size();
        if (state.members[p].size() >= 2) grids.emplace_back(state.rules, static_cast<int>(p), state.members[p]);
    }
    std::optional<SceneRotation> best;
    for (const Candidate& candidate : candidates_of(state)) {
        SceneRotation rotation{candidate.centre, candidate.fold, orbits_of(state, grids, candidate.centre, candidate.fold),
                               0};
        if (rotation.orbits.empty()) continue;
        rotation.centre = refined_centre(state, rotation.orbits);
        rotation.orbits = orbits_of(state, grids, rotation.centre, rotation.fold);
        if (2 * rotation.orbits.size() * static_cast<std::size_t>(rotation.fold) < living) continue;
        for (const std::vector<int>& orbit : rotation.orbits) {
            rotation.saved_bits += (rotation.fold - 1) * state.cost(state.item(orbit.front()).part).item_bits;
        }
        if (!best || rotation.saved_bits > best->saved_bits) best = std::move(rotation);
    }
    return best;
}

}  // namespace rinceau

#include "analyzer/scene_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/index_map.h"

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

/// Votes for (fold, centre), in cells of the plane.
class CentreVotes {
  public:
    explicit CentreVotes(double cell) : cell_(cell) {}

    void add(int fold, Point centre) {
        const double x = std::round(centre.x / cell_), y = std::round(centre.y / cell_);
        if (!(std::abs(x) < farthest && std::abs(y) < farthest)) return;
        const int known = cells_.find_or_insert(key(fold, x, y), static_cast<int>(sums_.size()));
        if (known == static_cast<int>(sums_.size())) sums_.push_back({key(fold, x, y), {{}, fold, 0}});
        Candidate& sum = sums_[static_cast<std::size_t>(known)].sum;
        sum.centre += centre;
        ++sum.votes;
    }
    /// The most voted, at least twice each, at the means of their votes.
    std::vector<Candidate> most_voted(std::size_t most) && {
        std::erase_if(sums_, [](const Sum& sum) { return sum.sum.votes < 2; });
        const auto rank = [](const Sum& sum) { return std::pair{-sum.sum.votes, sum.key}; };
        const auto kept = static_cast<std::ptrdiff_t>(std::min(most, sums_.size()));
        std::ranges::partial_sort(sums_, sums_.begin() + kept, {}, rank);
        std::vector<Candidate> candidates;
        for (std::ptrdiff_t k = 0; k < kept; ++k) {
            candidates.push_back(sums_[static_cast<std::size_t>(k)].sum);
            candidates.back().centre = candidates.back().centre / candidates.back().votes;
        }
        return candidates;
    }

  private:
    static constexpr double farthest = 1 << 27;  // cells: a key has 28 bits for each coordinate
    static std::uint64_t key(int fold, double x, double y) {
        const auto biased = [](double cell) { return static_cast<std::uint64_t>(cell + farthest); };
        return static_cast<std::uint64_t>(fold) << 56U | biased(x) << 28U | biased(y);
    }
    struct Sum {
        std::uint64_t key;
        Candidate sum;
    };
    double cell_;
    std::vector<Sum> sums_;
    IndexMap cells_;
};

/// Centres about which an n-fold turn takes one item of a part onto another.
std::vector<Candidate> candidates_of(const SearchState& state) {
    std::array<Complex, folds.size()> turns;
    for (std::size_t f = 0; f < folds.size(); ++f) turns[f] = turn_of(folds[f]);
    CentreVotes votes(centre_cell * state.diagonal);
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
                    votes.add(folds[f], (to.translation - turn * from.translation) / (Complex{1, 0} - turn));
                }
            }
        }
    }
    return std::move(votes).most_voted(candidates_tried);
}

Similarity rotation_about(Point centre, Complex turn) { return {turn, centre - turn * centre, false}; }

/// Items that the rotation takes round through `fold` different items and back; looked for from every `stride`-th item.
std::vector<std::vector<int>> orbits_of(const SearchState& state, const std::vector<PoseGrid>& grids, Point centre, int fold,
                                        std::size_t stride) {
    const Similarity rotation = rotation_about(centre, turn_of(fold));
    // Exact copies about an exact centre: the error of the centre counts for all alike.
    const PoseTolerance tolerance{2 * state.tolerance.size, 2 * state.tolerance.angle, 0};
    std::vector<std::vector<int>> orbits;
    std::vector<char> used(state.rules.items.size(), 0);
    for (const PoseGrid& grid : grids) {
        const std::vector<int>& items = state.alive(grid.part());
        for (std::size_t k = 0; k < items.size(); k += stride) {
            const int start = items[k];
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

/// The candidate with its orbits about the best centre, if there are any, and what they save of the items that were asked.
std::optional<SceneRotation> rotation_of(const SearchState& state, const std::vector<PoseGrid>& grids,
                                         const Candidate& candidate, std::size_t stride) {
    SceneRotation rotation{candidate.centre, candidate.fold, {}, 0};
    rotation.orbits = orbits_of(state, grids, rotation.centre, rotation.fold, stride);
    if (rotation.orbits.empty()) return std::nullopt;
    rotation.centre = refined_centre(state, rotation.orbits);
    rotation.orbits = orbits_of(state, grids, rotation.centre, rotation.fold, stride);
    const double saved_share = (rotation.fold - 1.0) / rotation.fold;
    for (const std::vector<int>& orbit : rotation.orbits) {
        const int part = state.item(orbit.front()).part;
        const std::vector<int>& items = state.alive(part);
        for (const int item : orbit) {
            const bool asked = (std::ranges::lower_bound(items, item) - items.begin()) % static_cast<int>(stride) == 0;
            if (asked) rotation.saved_bits += saved_share * state.cost(part).item_bits;
        }
    }
    return rotation;
}

/// The candidates that save most as far as a sample of the items tells.
std::vector<Candidate> most_promising(const SearchState& state, const std::vector<PoseGrid>& grids, std::size_t living) {
    constexpr std::size_t sample = 200;
    constexpr std::size_t most_promising = 8;
    const std::vector<Candidate> candidates = candidates_of(state);
    std::vector<std::pair<double, std::size_t>> ranks;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        const auto rotation = rotation_of(state, grids, candidates[c], 1 + living / sample);
        if (rotation && !rotation->orbits.empty()) ranks.emplace_back(-rotation->saved_bits, c);
    }
    std::ranges::sort(ranks);
    if (ranks.size() > most_promising) ranks.resize(most_promising);
    std::vector<Candidate> promising;
    for (const auto& [rank, c] : ranks) promising.push_back(candidates[c]);
    return promising;
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
    for (const Candidate& candidate : most_promising(state, grids, living)) {
        auto rotation = rotation_of(state, grids, candidate, 1);
        if (!rotation || 2 * rotation->orbits.size() * static_cast<std::size_t>(rotation->fold) < living) continue;
        if (!best || rotation->saved_bits > best->saved_bits) best = std::move(rotation);
    }
    return best;
}

}  // namespace rinceau

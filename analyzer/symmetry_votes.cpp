#include "analyzer/symmetry_votes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace rinceau {

Similarity reflection(Point through, Complex axis) {
    const Complex linear = axis * axis;
    return {linear, through - linear * conj(through), true};
}

Similarity PointGroup::map(std::size_t k) const {
    const std::size_t turns = mirrored ? k / 2 : k;
    const Complex turn = turns == 0 ? Complex{1, 0} : polar(1, two_pi * static_cast<double>(turns) / fold);
    const Similarity rotation{turn, centre - turn * centre, false};
    return mirrored && k % 2 == 1 ? rotation * reflection(centre, axis) : rotation;
}

namespace {

constexpr std::array folds{2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 15, 16, 18, 20, 24, 30, 32, 36};
constexpr double place_cell = 0.004;         // of the diagonal
constexpr double angle_cell = 0.016;         // radians
constexpr std::size_t items_asked = 40;      // of each part
constexpr std::size_t partners_asked = 120;  // of each of these
constexpr std::size_t most_votes = 60'000;
constexpr std::size_t most_voted = 60;       // of turns, and as many mirrors
constexpr std::size_t parts_centred = 8;     // parts whose mean is tried as a centre

/// A vote for a turn (fold > 1; place = centre) or a mirror axis (fold 1; place = its foot below the drawing's middle).
struct Vote {
    std::tuple<int, std::int64_t, std::int64_t> key;
    Point place;
    double angle = 0;  ///< of a mirror axis, in [0, pi)
};

class Voting {
  public:
    explicit Voting(const SearchState& state) : state_(state), cell_(place_cell * state.diagonal) {
        double count = 0;
        for (const auto& members : state.members) {
            for (const int i : members) middle_ += state.item(i).pose.translation;
            count += static_cast<double>(members.size());
        }
        middle_ = middle_ / std::max(1.0, count);
    }

    std::vector<PointGroup> run() {
        // Rare parts say most.
        std::vector<int> parts;
        for (std::size_t p = 0; p < state_.members.size(); ++p) {
            if (!state_.members[p].empty()) parts.push_back(static_cast<int>(p));
        }
        std::ranges::stable_sort(parts, {}, [&](int p) { return state_.alive(p).size(); });
        std::vector<PointGroup> groups = centres_of(parts);
        for (const int p : parts) {
            if (votes_.size() >= most_votes) break;
            vote(p);
        }
        const std::vector<PointGroup> voted = most_voted_groups();
        groups.insert(groups.end(), voted.begin(), voted.end());
        return groups;
    }

  private:
    /// A turn of the whole drawing about a centre leaves the mean of every part in place.
    std::vector<PointGroup> centres_of(const std::vector<int>& parts) const {
        std::vector<PointGroup> groups;
        std::size_t used = 0;
        for (const int p : parts) {
            if (state_.alive(p).size() < 3 || used == parts_centred) continue;
            ++used;
            Point mean;
            for (const int i : state_.alive(p)) mean += state_.item(i).pose.translation;
            mean = mean / static_cast<double>(state_.alive(p).size());
            const bool known = std::ranges::any_of(groups, [&](const PointGroup& g) { return abs(g.centre - mean) < 0.01 * cell_; });
            if (known) continue;
            for (const int fold : folds) groups.push_back({mean, fold, false, {1, 0}});
        }
        return groups;
    }

    void vote(int p) {
        const Part& part = state_.part(p);
        const std::vector<int>& items = state_.alive(p);
        const std::size_t stride = 1 + items.size() / items_asked, step = 1 + items.size() / partners_asked;
        const double turn = state_.tolerance.turn(part.radius);
        for (std::size_t i = 0; i < items.size(); i += stride) {
            const Similarity& from = state_.item(items[i]).pose;
            for (std::size_t j = 0; j < items.size(); j += step) {
                const Similarity& to = state_.item(items[j]).pose;
                if (std::abs(scale_of(to) / scale_of(from) - 1) > turn) continue;
                if (part.symmetry.continuous) {
                    if (i != j) vote_of_places(from.translation, to.translation);
                    continue;
                }
                for (const Similarity& gauge : part.symmetry.elements) vote_of_map(to * gauge * inverse(from), i == j);
            }
        }
    }

    /// Round items: every turn that takes one place to the other, and the mirror axis between them.
    void vote_of_places(Point from, Point to) {
        for (const int fold : folds) {
            const Complex turn = polar(1, two_pi / fold);
            vote_turn((to - turn * from) / (Complex{1, 0} - turn), fold);
        }
        const Complex across = to - from;
        if (norm(across) > 0) vote_mirror(0.5 * (from + to), Complex{0, 1} * across / abs(across));
    }

    void vote_of_map(const Similarity& map, bool same_item) {
        const Complex linear = map.linear / abs(map.linear);
        if (map.mirrored) {
            // A reflection has no glide along its axis.
            if (abs(linear * conj(map.translation) + map.translation) > cell_) return;
            vote_mirror(0.5 * map.translation, polar(1, 0.5 * arg(linear)));
            return;
        }
        const double angle = arg(linear);
        if (same_item || !(angle > 0)) return;
        const auto fold = static_cast<int>(std::lround(two_pi / angle));
        if (!std::ranges::binary_search(folds, fold) || std::abs(two_pi / fold - angle) > angle_cell) return;
        const Complex turn = polar(1, two_pi / fold);
        vote_turn(map.translation / (Complex{1, 0} - turn), fold);
    }

    std::int64_t cells(double length) const { return std::llround(length / cell_); }

    void vote_turn(Point centre, int fold) {
        if (abs(centre - middle_) > state_.diagonal) return;
        votes_.push_back({{fold, cells(centre.x - middle_.x), cells(centre.y - middle_.y)}, centre, 0});
    }

    void vote_mirror(Point through, Complex axis) {
        double angle = arg(axis);
        if (angle < 0) angle += pi;
        if (angle >= pi) angle -= pi;
        axis = polar(1, angle);
        const Point foot = through + dot(middle_ - through, axis) * axis;
        votes_.push_back({{1, cells(cross(axis, foot - middle_)), std::llround(angle / angle_cell)}, foot, angle});
    }

    /// The cells with most votes, turns and mirrors apart.
    std::vector<PointGroup> most_voted_groups() {
        std::ranges::stable_sort(votes_, {}, &Vote::key);
        struct Cell {
            PointGroup group;
            std::size_t votes = 0;
        };
        std::vector<Cell> cells;
        for (std::size_t begin = 0; begin < votes_.size();) {
            std::size_t end = begin;
            Point place;
            double angle = 0;
            for (; end < votes_.size() && votes_[end].key == votes_[begin].key; ++end) {
                place += votes_[end].place;
                angle += votes_[end].angle;
            }
            const auto count = static_cast<double>(end - begin);
            const int fold = std::get<0>(votes_[begin].key);
            if (end - begin >= 2) {
                cells.push_back({{place / count, fold, fold == 1, polar(1, angle / count)}, end - begin});
            }
            begin = end;
        }
        std::ranges::stable_sort(cells, [](const Cell& a, const Cell& b) { return a.votes > b.votes; });
        std::vector<PointGroup> groups;
        std::size_t turns = 0, mirrors = 0;
        for (const Cell& cell : cells) {
            std::size_t& used = cell.group.mirrored ? mirrors : turns;
            if (used++ < most_voted) groups.push_back(cell.group);
        }
        return groups;
    }

    const SearchState& state_;
    double cell_;
    Point middle_;
    std::vector<Vote> votes_;
};

}  // namespace

std::vector<PointGroup> vote_for_point_groups(const SearchState& state) { return Voting(state).run(); }

}  // namespace rinceau

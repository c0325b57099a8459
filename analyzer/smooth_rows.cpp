#include "analyzer/smooth_rows.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace rinceau {

namespace {

constexpr std::size_t neighbours_tried = 6;
constexpr double most_change = 2;           // of the length or the size, from one step to the next
constexpr double most_bend = pi / 3;
constexpr double reach = 0.2;               // of the step before: how far off the next item may lie
constexpr double size_reach = 0.15;         // relative: how far off its size may be
constexpr double in_the_way = pi / 9;       // no other item lies nearer in the direction of a step

class RowFinder {
  public:
    RowFinder(const SearchState& state, int p, std::span<const std::vector<int>> neighbours)
        : state_(state), items_(state.alive(p)), neighbours_(neighbours) {
        for (std::size_t k = 0; k < items_.size(); ++k) slot_[items_[k]] = k;
    }

    std::vector<std::vector<int>> run(std::size_t least) {
        std::vector<std::vector<int>> rows;
        for (const int first : items_) {
            const std::vector<int>& near = neighbours_of(first);
            for (std::size_t n = 0; n < std::min(near.size(), neighbours_tried); ++n) {
                if (steps_.contains({first, near[n]}) || blocked(first, near[n])) continue;
                std::vector<int> row = longest_from(first, near[n], least);
                if (row.size() < least) continue;
                note(row);
                if (falls(row)) std::ranges::reverse(row);
                rows.push_back(std::move(row));
            }
        }
        return rows;
    }

  private:
    const std::vector<int>& neighbours_of(int item) const { return neighbours_[slot_.at(item)]; }
    Point place(int item) const { return state_.item(item).pose.translation; }
    double size(int item) const { return scale_of(state_.item(item).pose); }

    /// Both ways: a row is found once.
    void note(const std::vector<int>& row) {
        for (std::size_t k = 0; k + 1 < row.size(); ++k) {
            steps_.insert({row[k], row[k + 1]});
            steps_.insert({row[k + 1], row[k]});
        }
    }
    bool falls(const std::vector<int>& row) const {
        int rising = 0;
        for (std::size_t k = 0; k + 1 < row.size(); ++k) {
            rising += state_.item(row[k]).first < state_.item(row[k + 1]).first ? 1 : -1;
        }
        return rising < 0;
    }

    /// Another item lies nearer in the same direction: who goes on from there would skip it.
    bool blocked(int from, int to) const {
        const Point way = place(to) - place(from);
        for (const int other : neighbours_of(from)) {
            if (other == to) return false;  // the rest is farther
            const Complex ratio = (place(other) - place(from)) / way;
            if (std::abs(arg(ratio)) < in_the_way) return true;
        }
        return false;
    }

    std::vector<int> longest_from(int first, int second, std::size_t least) const {
        std::vector<int> longest;
        const std::vector<int>& near = neighbours_of(second);
        for (std::size_t n = 0; n < std::min(near.size(), neighbours_tried); ++n) {
            const int third = near[n];
            if (third == first || !goes_on(first, second, third) || blocked(second, third)) continue;
            std::vector<int> row{first, second, third};
            while (extend(row)) {}
            if (row.size() < least) continue;
            std::ranges::reverse(row);
            while (extend(row)) {}
            std::ranges::reverse(row);
            if (row.size() > longest.size()) longest = std::move(row);
        }
        return longest;
    }

    bool goes_on(int a, int b, int c) const {
        const Complex ratio = (place(c) - place(b)) / (place(b) - place(a));
        const double growth = size(c) * size(a) / (size(b) * size(b));
        return abs(ratio) < most_change && abs(ratio) > 1 / most_change && std::abs(arg(ratio)) < most_bend &&
               growth < most_change && growth > 1 / most_change && std::abs(std::log(size(b) / size(a))) < std::log(most_change);
    }

    /// The neighbour of the last item that is nearest to where the row would go on as it went so far.
    bool extend(std::vector<int>& row) const {
        const int a = row[row.size() - 3], b = row[row.size() - 2], c = row.back();
        const Point before = place(b) - place(a), last = place(c) - place(b);
        const double length = 2 * abs(last) - abs(before);
        if (!(length > 0)) return false;
        // How the direction changes, changes as evenly.
        double bend = arg(last / before);
        if (row.size() > 3) bend += arg(last / before / (before / (place(a) - place(row[row.size() - 4]))));
        const Point predicted = place(c) + Point(last / abs(last) * polar(length, bend));
        const double wanted_size = std::max(2 * size(c) - size(b), 1e-3 * size(c));
        int best = -1;
        double least = reach * abs(last);
        for (const int next : neighbours_of(c)) {
            const double off = abs(place(next) - predicted);
            if (off < least && std::abs(size(next) / wanted_size - 1) < size_reach) {
                least = off;
                best = next;
            }
        }
        if (best < 0 || std::ranges::find(row, best) != row.end()) return false;
        row.push_back(best);
        return true;
    }

    const SearchState& state_;
    const std::vector<int>& items_;
    std::span<const std::vector<int>> neighbours_;
    std::unordered_map<int, std::size_t> slot_;
    std::set<std::pair<int, int>> steps_;  // of rows that were found
};

}  // namespace

std::vector<std::vector<int>> smooth_rows(const SearchState& state, int p, std::span<const std::vector<int>> neighbours,
                                          std::size_t least) {
    return RowFinder(state, p, neighbours).run(least);
}

std::vector<Similarity> smooth_frames(const SearchState& state, std::span<const int> row) {
    std::vector<Similarity> frames;
    double turn = 0;  // from frame to frame
    for (const int i : row) {
        const Item& item = state.item(i);
        const Part& part = state.part(item.part);
        if (part.symmetry.continuous) {
            frames.push_back({{scale_of(item.pose), 0}, item.pose.translation, false});
            continue;
        }
        if (frames.empty()) {
            frames.push_back(item.pose);
            continue;
        }
        double least = 2 * pi;
        Similarity best;
        for (const Similarity& gauge : part.symmetry.elements) {
            const Similarity frame = item.pose * gauge;
            if (frame.mirrored != frames.front().mirrored) continue;
            const double off = std::abs(wrap_angle(arg(frame.linear / frames.back().linear) - turn));
            if (off < least) {
                least = off;
                best = frame;
            }
        }
        if (least > pi) return {};
        turn = arg(best.linear / frames.back().linear);
        frames.push_back(best);
    }
    return frames;
}

}  // namespace rinceau

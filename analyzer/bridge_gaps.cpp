#include "analyzer/bridge_gaps.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "analyzer/gather.h"

namespace rinceau {

namespace {

constexpr int widest_gap = 2;           // places that may be missing in a row
constexpr std::size_t fewest_alone = 2;  // members of the run at the end of a line that stands alone

/// A stretch of a line without a gap.
struct Segment {
    std::size_t begin = 0, end = 0;  // places
    bool operator==(const Segment&) const = default;
};

/// Places that follow the step, from an item of the rule on both ways.
struct Line {
    std::deque<Gathered> places;
    std::deque<int> run_of;  // place -> item of the rule that holds it, or -1
    Similarity first, last;  // frames of the outermost places
    std::size_t exceptions = 0;
};

class Bridge {
  public:
    Bridge(SearchState& state, GridCache& grids, int rule) : state_(state), grids_(grids), rule_index_(rule) {}

    /// True if anything was joined.
    bool run(std::set<int>& touched) {
        bool changed = false;
        for (int gap = 0; gap <= widest_gap; ++gap) {
            std::vector<Line> lines = lines_with(gap);
            const Witnesses witnesses = gap == 0 ? Witnesses{} : witnesses_of(lines);
            for (const Line& line : lines) {
                if (gap == 0) {
                    changed |= join(line, {0, line.places.size()}, touched);
                } else {
                    for (const Segment& part : worth_joining(line, witnesses)) changed |= join(line, part, touched);
                }
            }
        }
        return changed;
    }

  private:
    const Rule& rule() const { return state_.rules.rules[static_cast<std::size_t>(rule_index_)]; }

    /// Parts of the rule that have living items.
    void find_parts() {
        parts_.clear();
        for (std::size_t p = 0; p < state_.rules.parts.size(); ++p) {
            if (state_.rules.parts[p].rule == rule_index_ && !state_.members[p].empty()) parts_.push_back(static_cast<int>(p));
        }
    }

    /// Living items of the rule, longest first.
    std::vector<int> living_runs() const {
        std::vector<int> runs;
        for (const int p : parts_) {
            for (const int i : state_.alive(p)) {
                if (state_.item(i).alive) runs.push_back(i);
            }
        }
        std::ranges::stable_sort(runs, [&](int a, int b) {
            const Item &x = state_.item(a), &y = state_.item(b);
            return std::pair{y.members.size(), x.first} < std::pair{x.members.size(), y.first};
        });
        return runs;
    }

    /// Each living run in one line; gaps of up to `gap` places are crossed.
    std::vector<Line> lines_with(int gap) {
        std::vector<Line> lines;
        used_.clear();
        find_parts();
        for (const int run : living_runs()) {
            if (used_.contains(run)) continue;
            Line line = begun_with(run);
            extend(line, gap, true);
            extend(line, gap, false);
            lines.push_back(std::move(line));
        }
        return lines;
    }

    Line begun_with(int run) {
        Line line;
        used_.insert(run);
        const Item& item = state_.item(run);
        const std::vector<Child>& children = state_.part(item.part).children;
        for (const int member : item.members) {
            line.places.push_back({member, {}, {}, 0});
            line.run_of.push_back(run);
            line.exceptions += member < 0 ? 1 : 0;
        }
        line.first = item.pose * children.front().pose;
        line.last = item.pose * children.back().pose;
        return line;
    }

    void extend(Line& line, int gap, bool forward) {
        while (extend_once(line, gap, forward)) {
        }
    }

    bool extend_once(Line& line, int gap, bool forward) {
        const Similarity step = forward ? rule().step : inverse(rule().step);
        Similarity frame = forward ? line.last : line.first;
        for (int missing = 0; missing <= gap; ++missing) {
            const Point before = frame.translation;
            frame = frame * step;
            const double distance = abs(frame.translation - before);
            if (add_run(line, frame, distance, missing, forward) || add_member(line, frame, distance, missing, forward)) return true;
        }
        return false;
    }

    /// Another run of the rule that goes on here.
    bool add_run(Line& line, const Similarity& frame, double distance, int missing, bool forward) {
        for (const int p : parts_) {
            const std::vector<Child>& children = state_.part(p).children;
            const Similarity& near_end = (forward ? children.front() : children.back()).pose;
            const Similarity& far_end = (forward ? children.back() : children.front()).pose;
            const Similarity predicted = frame * inverse(near_end);
            const double reach = distance + abs(predicted.translation - frame.translation);
            const auto match = grids_.of(p).find(predicted, reach, link_tolerance(state_));
            if (!match || !used_.insert(match->item).second) continue;
            add_gap(line, missing, forward);
            const Similarity pose =
                state_.item(match->item).pose * state_.part(p).symmetry.elements[static_cast<std::size_t>(match->gauge)];
            // From the near end to the far one.
            for (const int member : members_from(state_, match->item, frame)) {
                add_place(line, {member, {}, {}, 0}, match->item, forward);
                line.exceptions += member < 0 ? 1 : 0;
            }
            (forward ? line.last : line.first) = pose * far_end;
            return true;
        }
        return false;
    }

    /// A single member, or what can be gathered of one.
    bool add_member(Line& line, const Similarity& frame, double distance, int missing, bool forward) {
        const auto found = gather(state_, grids_, rule().repeated, frame, distance);
        if (!found) return false;
        const bool whole = found->item >= 0 && found->exceptions == 0;
        // Beyond a gap only what is whole; exceptions are at most a third of the line.
        if (!whole && (missing > 0 || 3 * (line.exceptions + 1) > line.places.size() + 1)) return false;
        if (found->item >= 0 && !used_.insert(found->item).second) return false;
        for (const int run : found->runs) {
            if (!used_.insert(run).second) return false;
        }
        add_gap(line, missing, forward);
        add_place(line, *found, -1, forward);
        line.exceptions += whole ? 0 : 1;
        (forward ? line.last : line.first) = frame;
        return true;
    }

    void add_gap(Line& line, int missing, bool forward) {
        for (int k = 0; k < missing; ++k) add_place(line, {}, -1, forward);
        line.exceptions += static_cast<std::size_t>(missing);
    }

    static void add_place(Line& line, Gathered place, int run, bool forward) {
        if (forward) {
            line.places.push_back(std::move(place));
            line.run_of.push_back(run);
        } else {
            line.places.push_front(std::move(place));
            line.run_of.push_front(run);
        }
    }

    // ---- Which gaps are bridged

    using Pattern = std::vector<char>;  // which places are taken
    struct Witnesses {
        std::map<std::size_t, int> whole;                     // lines without gaps, by length
        std::map<std::size_t, std::map<Pattern, int>> broken;  // lines with gaps, by length
    };

    static Pattern pattern_of(const Line& line, const Segment& part) {
        Pattern pattern;
        for (std::size_t k = part.begin; k < part.end; ++k) pattern.push_back(line.places[k].missing() ? 0 : 1);
        return pattern;
    }

    /// Stretches between gaps that no item of the rule holds already.
    static std::vector<Segment> segments_of(const Line& line) {
        std::vector<Segment> segments;
        bool open = false;
        for (std::size_t k = 0; k < line.places.size(); ++k) {
            const bool gap = line.places[k].missing() && line.run_of[k] < 0;
            if (!gap && !open) segments.push_back({k, k});
            if (!gap) segments.back().end = k + 1;
            open = !gap;
        }
        return segments;
    }

    Witnesses witnesses_of(const std::vector<Line>& lines) const {
        Witnesses witnesses;
        for (const Line& line : lines) {
            const std::vector<Segment> segments = segments_of(line);
            for (const Segment& segment : segments) {
                if (segment.end - segment.begin > 1) ++witnesses.whole[segment.end - segment.begin];
            }
            if (segments.size() > 1) ++witnesses.broken[line.places.size()][pattern_of(line, {0, line.places.size()})];
        }
        return witnesses;
    }

    static bool few_exceptions(const Pattern& pattern) {
        const auto missing = static_cast<std::size_t>(std::ranges::count(pattern, 0));
        return 3 * missing <= pattern.size();
    }

    /// Other lines of the length do without these gaps, and not fewer than have just the same.
    static bool witnessed(const Witnesses& witnesses, const Pattern& pattern) {
        const auto whole = witnesses.whole.find(pattern.size());
        int others = whole == witnesses.whole.end() ? 0 : whole->second, same = 1;
        const auto broken = witnesses.broken.find(pattern.size());
        if (broken != witnesses.broken.end()) {
            for (const auto& [other, count] : broken->second) {
                if (other == pattern) {
                    same = count;
                } else {
                    others += count;
                }
            }
        }
        constexpr int few_alike = 2;  // more with just these gaps must be outnumbered
        return few_exceptions(pattern) && !has_even_gaps(pattern) && others >= (same > few_alike ? 2 * same : same);
    }

    /// Does a line of so many places, with a gap at most behind it, come round?
    bool comes_round(std::size_t places) const {
        const double allowed = state_.tolerance.turn(state_.part(rule().repeated).radius);
        const double turn = arg(rule().step.linear), growth = std::abs(std::log(scale_of(rule().step)));
        for (std::size_t n = places; n <= places + widest_gap; ++n) {
            const auto count = static_cast<double>(n);
            if (std::abs(turn) > allowed && std::abs(wrap_angle(count * turn)) <= allowed && count * growth <= allowed) return true;
        }
        return false;
    }

    /// A line that stands alone: its runs differ in length, and those at its ends, unless these meet, are runs.
    bool stands_alone(const Witnesses& witnesses, const Line& line, const std::vector<Segment>& segments,
                      const Pattern& pattern) const {
        const auto length = [](const Segment& s) { return s.end - s.begin; };
        const bool ends = length(segments.front()) >= fewest_alone && length(segments.back()) >= fewest_alone;
        const bool runs = ends || comes_round(line.places.size());
        const bool blocks = std::ranges::all_of(segments, [&](const Segment& s) { return length(s) == length(segments.front()); });
        const auto broken = witnesses.broken.find(line.places.size());
        const bool alone = broken != witnesses.broken.end() && broken->second.size() == 1 && broken->second.begin()->second == 1;
        return few_exceptions(pattern) && runs && !blocks && !has_even_gaps(pattern) && alone;
    }

    std::vector<Segment> worth_joining(const Line& line, const Witnesses& witnesses) const {
        const std::vector<Segment> segments = segments_of(line);
        if (segments.size() < 2) return {};
        // The longest stretches that are as long as others are.
        std::vector<Segment> joined;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            std::size_t last = i;
            for (std::size_t j = segments.size() - 1; j > i && last == i; --j) {
                if (witnessed(witnesses, pattern_of(line, {segments[i].begin, segments[j].end}))) last = j;
            }
            if (last == i) continue;
            joined.push_back({segments[i].begin, segments[last].end});
            i = last;
        }
        const Segment everything{0, line.places.size()};
        if (joined.empty() && stands_alone(witnesses, line, segments, pattern_of(line, everything))) joined.push_back(everything);
        return joined;
    }

    /// Makes one item of a stretch of the line; false if it is one already or does not fit.
    bool join(const Line& line, const Segment& stretch, std::set<int>& touched) {
        Gathered plan;
        std::set<int> runs;
        bool gathered = false;
        for (std::size_t k = stretch.begin; k < stretch.end; ++k) {
            plan.members.push_back(line.places[k]);
            if (line.run_of[k] >= 0) runs.insert(line.run_of[k]);
            gathered |= line.run_of[k] < 0;
        }
        if (runs.size() < 2 && !gathered) return false;
        plan.runs.assign(runs.begin(), runs.end());
        const int part = part_of_count(state_, rule_index_, static_cast<int>(plan.members.size()));
        // Where the line's first place is, seen from the stretch.
        Similarity first = line.first;
        for (std::size_t k = 0; k < stretch.begin; ++k) first = first * rule().step;
        const Similarity pose = first * inverse(state_.part(part).children.front().pose);
        std::set<int> parts;
        const int item = make_item(state_, part, plan, pose, parts);
        for (const int p : parts) grids_.forget(p);
        refresh(state_, {parts.begin(), parts.end()});
        touched.insert(parts.begin(), parts.end());
        return item >= 0;
    }

    SearchState& state_;
    GridCache& grids_;
    int rule_index_;
    std::vector<int> parts_;
    std::set<int> used_;
};

}  // namespace

void bridge_gaps(SearchState& state, GridCache& grids, Substitution& made) {
    improve_sequences(state, made, [&](int rule, std::set<int>& touched) { Bridge(state, grids, rule).run(touched); });
}

}  // namespace rinceau

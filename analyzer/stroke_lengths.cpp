#include "analyzer/stroke_lengths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace rinceau {

namespace {

/// Of hairlines, whose width shows as a shade.
constexpr double width_tolerance = 0.05;
/// The differences of periods add up along the outline.
constexpr double period_tolerance = 1e-3;
/// Numbers that differ by less differ by rounding.
constexpr double rounding = 1e-9;

using Indices = std::vector<std::size_t>;

/// All values from `low` to `high` will do for the stroke.
struct Interval {
    double low = 0, middle = 0, high = 0;
    std::size_t stroke = 0;
};

struct Cluster {
    Indices strokes;
    double value = 0;
};

/// The value that is most their own of those that will do for all.
double common_value(std::vector<Interval> intervals) {
    double low = intervals.front().low;
    double high = intervals.front().high;
    for (const Interval& i : intervals) {
        low = std::max(low, i.low);
        high = std::min(high, i.high);
    }
    const auto median = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::ranges::nth_element(intervals, median, {}, &Interval::middle);
    return std::clamp(median->middle, low, high);
}

/// The fewest values such that every interval holds one: again and again the first end.
std::vector<Cluster> clusters_of(std::vector<Interval> intervals) {
    std::ranges::stable_sort(intervals, {}, &Interval::high);
    std::vector<Cluster> clusters;
    for (std::size_t first = 0; first < intervals.size();) {
        std::vector<Interval> members;
        std::size_t next = first;
        while (next < intervals.size() && intervals[next].low <= intervals[first].high) members.push_back(intervals[next++]);
        Cluster cluster{{}, common_value(members)};
        for (const Interval& member : members) cluster.strokes.push_back(member.stroke);
        clusters.push_back(std::move(cluster));
        first = next;
    }
    return clusters;
}

/// One way to understand the strokes of a shape and kind.
struct Reading {
    std::vector<StrokeLengths> groups;
    std::vector<Indices> members;
};

class LengthsFinder {
  public:
    LengthsFinder(const std::vector<DrawnStroke>& strokes, double smallest_seen)
        : strokes_(strokes), smallest_seen_(smallest_seen), result_(strokes.size()) {}

    std::vector<StrokeLengths> run() {
        std::map<std::pair<int, std::uint64_t>, Indices> kinds;
        for (std::size_t i = 0; i < strokes_.size(); ++i) kinds[{strokes_[i].shape, strokes_[i].kind}].push_back(i);
        for (const auto& [key, members] : kinds) read(key.second, members);
        settle_undecided();
        return std::move(result_);
    }

  private:
    void read(std::uint64_t kind, const Indices& members) {
        Reading scaling = reading(members, false);
        const bool scales_only = std::ranges::any_of(members, [&](std::size_t i) { return strokes_[i].scales_only; });
        if (scales_only) return take(scaling);
        Reading fixed = reading(members, true);
        if (scaling.groups.size() < fixed.groups.size()) return take(scaling);
        if (scaling.groups.size() == fixed.groups.size()) {
            undecided_.push_back({kind, std::move(scaling), std::move(fixed)});
            return;
        }
        for (const StrokeLengths& lengths : fixed.groups) fixed_.insert(fixed_key(kind, lengths));
        take(fixed);
    }

    Reading reading(const Indices& members, bool fixed) const {
        const auto unit = [&](std::size_t i) { return fixed ? 1.0 : strokes_[i].scale; };
        std::vector<Interval> widths;
        for (const std::size_t i : members) {
            const double width = strokes_[i].width;
            const double slack = std::max(rounding * width, std::min(smallest_seen_, width_tolerance * width));
            widths.push_back({(width - slack) / unit(i), width / unit(i), (width + slack) / unit(i), i});
        }
        Reading result;
        for (const Cluster& of_width : clusters_of(std::move(widths))) {
            std::vector<Interval> periods;
            for (const std::size_t i : of_width.strokes) {
                const double period = strokes_[i].dash_period / unit(i);
                periods.push_back({(1 - period_tolerance) * period, period, (1 + period_tolerance) * period, i});
            }
            for (Cluster& cluster : clusters_of(std::move(periods))) {
                result.groups.push_back({-1, of_width.value, cluster.value, fixed});
                result.members.push_back(std::move(cluster.strokes));
            }
        }
        return result;
    }

    void take(const Reading& reading) {
        for (std::size_t k = 0; k < reading.groups.size(); ++k) {
            StrokeLengths lengths = reading.groups[k];
            lengths.group = groups_++;
            for (const std::size_t i : reading.members[k]) result_[i] = lengths;
        }
    }

    /// Shapes of which nothing tells whether their strokes scale follow those of which it is known.
    void settle_undecided() {
        for (const Undecided& both : undecided_) {
            const bool elsewhere_fixed = std::ranges::all_of(both.fixed.groups, [&](const StrokeLengths& lengths) {
                return fixed_.contains(fixed_key(both.kind, lengths));
            });
            take(elsewhere_fixed ? both.fixed : both.scaling);
        }
    }

    using FixedKey = std::tuple<std::uint64_t, std::int64_t, std::int64_t>;
    static FixedKey fixed_key(std::uint64_t kind, const StrokeLengths& lengths) {
        constexpr double step = 1e-5;  // of the logarithm: lengths of five equal digits
        const auto digits = [&](double length) { return length > 0 ? std::llround(std::log(length) / step) : 0; };
        return {kind, digits(lengths.width), digits(lengths.dash_period)};
    }

    struct Undecided {
        std::uint64_t kind;
        Reading scaling, fixed;
    };

    const std::vector<DrawnStroke>& strokes_;
    double smallest_seen_;
    std::vector<StrokeLengths> result_;
    std::set<FixedKey> fixed_;
    std::vector<Undecided> undecided_;
    int groups_ = 0;
};

}  // namespace

std::vector<StrokeLengths> common_stroke_lengths(const std::vector<DrawnStroke>& strokes, double smallest_seen) {
    return LengthsFinder(strokes, smallest_seen).run();
}

}  // namespace rinceau

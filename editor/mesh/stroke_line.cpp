#include "editor/mesh/stroke_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/cubic_bezier.h"

namespace rinceau {
namespace {

/// Of a curve's direction steps at its ends, in deviations: too short to be seen.
constexpr double direction_step = 1.0 / 64;

/// Tangents that differ by less (radians) go on without a corner.
constexpr double corner_angle = 1e-3;

class LineWriter {
  public:
    explicit LineWriter(Point start) { line_.points.push_back({start, false}); }

    Point last() const { return line_.points.back().at; }
    void add(Point at, bool smooth) {
        if (at != last()) line_.points.push_back({at, smooth});
    }
    StrokeLine take(bool closed) {
        line_.closed = closed;
        if (closed && line_.points.size() > 1 && line_.points.back().at == line_.points.front().at) line_.points.pop_back();
        return std::move(line_);
    }

  private:
    StrokeLine line_;
};

Point unit(Point v) {
    const double length = abs(v);
    return length > 0 ? v / length : Point{};
}

/// The direction in which the curve leaves its start: of the first of its points that lies elsewhere.
Point start_direction(const CubicBezier& curve) {
    for (const Point to : {curve.control1, curve.control2, curve.to})
        if (to != curve.from) return unit(to - curve.from);
    return {};
}

Point end_direction(const CubicBezier& curve) {
    return -start_direction({curve.to, curve.control2, curve.control1, curve.from});
}

void add_curve(LineWriter& line, const CubicBezier& curve, double deviation) {
    const double step = direction_step * deviation;
    const std::vector<Point> points = flattened(curve, deviation);
    // Chords are not tangents: without a first and a last step along them, thick caps and mitres would lean.
    const Point behind_start = curve.from + step * start_direction(curve);
    const Point before_end = curve.to - step * end_direction(curve);
    const bool room = !points.empty() && abs(points.front() - curve.from) > 2 * step &&
                      (points.size() < 2 || abs(points[points.size() - 2] - curve.to) > 2 * step);
    if (room) line.add(behind_start, true);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) line.add(points[i], true);
    if (room) line.add(before_end, true);
    line.add(curve.to, false);
}

/// Where the line goes on without a corner, joins are round and cannot be seen.
StrokeLine with_smooth_corners(StrokeLine line) {
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!line.closed && (i == 0 || i + 1 == count)) continue;
        const Point at = line.points[i].at;
        const Point in = unit(at - line.points[(i + count - 1) % count].at);
        const Point out = unit(line.points[(i + 1) % count].at - at);
        if (dot(in, out) > 0 && std::abs(cross(in, out)) < corner_angle) line.points[i].smooth = true;
    }
    return line;
}

/// A walk along a line that cuts it into dashes.
class DashCutter {
  public:
    DashCutter(const std::vector<double>& dashes, double offset) : dashes_(dashes) {
        double period = 0;
        for (const double dash : dashes) period += dash;
        left_ = std::fmod(offset, period);
        if (left_ < 0) left_ += period;
        while (left_ > 0 && left_ >= dashes_[index_]) {
            left_ -= dashes_[index_];
            next_dash();
        }
        left_ = dashes_[index_] - left_;
    }

    std::vector<StrokeLine> cut(const StrokeLine& line) {
        const std::size_t count = line.points.size();
        const bool starts_on = on();
        if (on()) begin(line.points.front());
        for (std::size_t i = 1; i < count + (line.closed ? 1 : 0); ++i) walk(line.points[i - 1], line.points[i % count]);
        const bool ends_on = on();
        if (on()) finish();
        if (line.closed && starts_on && ends_on && !cuts_) return {line};
        if (line.closed && starts_on && ends_on) join_ends();
        return std::move(parts_);
    }

  private:
    bool on() const { return index_ % 2 == 0; }
    void next_dash() { index_ = (index_ + 1) % dashes_.size(); }

    void begin(const StrokePoint& point) { part_.points = {{point.at, false}}; }
    void finish() {
        part_.direction = direction_;
        parts_.push_back(std::move(part_));
        part_ = {};
    }
    void walk(const StrokePoint& from, const StrokePoint& to) {
        const double length = abs(to.at - from.at);
        direction_ = (to.at - from.at) / length;
        double walked = 0;
        while (walked + left_ < length) {
            walked += left_;
            const Point at = from.at + walked * direction_;
            if (on()) {
                add({at, false});
                finish();
            } else {
                begin({at, false});
            }
            cuts_ = true;
            next_dash();
            left_ = dashes_[index_];
        }
        left_ -= length - walked;
        if (on()) add(to);
    }
    void add(const StrokePoint& point) {
        if (part_.points.empty() || part_.points.back().at != point.at) part_.points.push_back(point);
    }
    /// The last dash of a closed line runs on into the first.
    void join_ends() {
        StrokeLine last = std::move(parts_.back());
        parts_.pop_back();
        StrokeLine& first = parts_.front();
        last.points.back().smooth = false;
        last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
        first.points = std::move(last.points);
    }

    const std::vector<double>& dashes_;
    std::size_t index_ = 0;
    double left_ = 0;  // of the dash or gap that the walk is in
    bool cuts_ = false;
    Point direction_{1, 0};
    StrokeLine part_;
    std::vector<StrokeLine> parts_;
};

double length_of(const StrokeLine& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) sum += abs(line.points[i].at - line.points[i - 1].at);
    return line.closed ? sum + abs(line.points.front().at - line.points.back().at) : sum;
}

}  // namespace

std::vector<StrokeLine> stroke_lines(const Path& path, double deviation) {
    if (path.segments.empty() && !path.closed) return {};
    LineWriter line(path.start);
    for (const Segment& segment : path.segments) {
        if (segment.straight) {
            line.add(segment.to, false);
        } else {
            add_curve(line, {line.last(), segment.control1, segment.control2, segment.to}, deviation);
        }
    }
    return {with_smooth_corners(line.take(path.closed))};
}

std::vector<StrokeLine> dashed(const StrokeLine& line, const std::vector<double>& dashes, double offset, int max_dashes) {
    double period = 0;
    for (const double dash : dashes) period += dash;
    const bool valid = period > 0 && std::isfinite(period) && std::isfinite(offset) &&
                       std::ranges::all_of(dashes, [](double dash) { return dash >= 0; });
    if (!valid || line.points.size() < 2) return {line};
    if (length_of(line) / period * static_cast<double>(dashes.size()) > 2.0 * max_dashes) return {line};
    return DashCutter(dashes, offset).cut(line);
}

}  // namespace rinceau

// Caps and outer joins by Anti-Grain Geometry. Inner joins are drawn so that each contour winds about everything within
// half a width of its line at least once, however short and bent the line is.

#include "editor/mesh/stroke_outline.h"

#include <agg_array.h>
#include <agg_basics.h>
#include <agg_math_stroke.h>
#include <agg_vertex_sequence.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/mesh/stroke_line.h"
#include "scene/pen.h"

namespace rinceau {
namespace {

/// So many dashes in all that no picture shows them apart.
constexpr int max_dashes = 100'000;

using Vertices = agg::pod_bvector<agg::point_d>;

agg::vertex_dist vertex(Point p) { return {p.x, p.y}; }
Point to_the_right(Point direction) { return {direction.y, -direction.x}; }

agg::line_join_e agg_join(LineJoin join) {
    if (join == LineJoin::round) return agg::round_join;
    return join == LineJoin::bevel ? agg::bevel_join : agg::miter_join_revert;
}

agg::line_cap_e agg_cap(LineCap cap) {
    if (cap == LineCap::round) return agg::round_cap;
    return cap == LineCap::square ? agg::square_cap : agg::butt_cap;
}

class OutlineWriter {
  public:
    OutlineWriter(const Stroke& stroke, double width, double deviation)
        : half_width_(0.5 * width), cap_(stroke.cap), join_(agg_join(stroke.join)) {
        constexpr double agg_deviation = 0.125;  // of arcs at AGG's scale 1
        pen_.width(width);
        pen_.line_cap(agg_cap(stroke.cap));
        pen_.miter_limit(stroke.miter_limit);
        pen_.approximation_scale(agg_deviation / deviation);
    }

    void add(const StrokeLine& line) {
        if (line.points.size() < 2) {
            add_dot(line);
        } else if (line.closed) {
            add_closed(line.points);
        } else {
            add_open(line.points);
        }
    }
    Contours take() { return std::move(contours_); }

  private:
    using Points = std::vector<StrokePoint>;

    void add_dot(const StrokeLine& line) {
        if (cap_ == LineCap::butt) return;
        const Point at = line.points.front().at;
        cap(at, at + line.direction);
        cap(at, at - line.direction);
        finish();
    }
    void add_open(const Points& points) {
        const std::size_t last = points.size() - 1;
        cap(points[0].at, points[1].at);
        for (std::size_t i = 1; i < last; ++i) join(points[i - 1], points[i], points[i + 1]);
        cap(points[last].at, points[last - 1].at);
        for (std::size_t i = last; i-- > 1;) join(points[i + 1], points[i], points[i - 1]);
        finish();
    }
    void add_closed(const Points& points) {
        const std::size_t count = points.size();
        const auto before = [&](std::size_t i) { return points[(i + count - 1) % count]; };
        const auto after = [&](std::size_t i) { return points[(i + 1) % count]; };
        for (std::size_t i = 0; i < count; ++i) join(before(i), points[i], after(i));
        finish();
        for (std::size_t i = count; i-- > 0;) join(after(i), points[i], before(i));
        finish();
    }

    void cap(Point at, Point towards) {
        pen_.calc_cap(vertices_, vertex(at), vertex(towards), abs(towards - at));
        append();
    }
    /// The outline's right side at a corner.
    void join(const StrokePoint& from, const StrokePoint& at, const StrokePoint& to) {
        const double length_in = abs(at.at - from.at);
        const double length_out = abs(to.at - at.at);
        const Point in = (at.at - from.at) / length_in;
        const Point out = (to.at - at.at) / length_out;
        if (cross(in, out) < 0) {
            inner_join(at.at, in, out, std::min(length_in, length_out));
            return;
        }
        pen_.line_join(at.smooth ? agg::round_join : join_);
        pen_.calc_join(vertices_, vertex(from.at), vertex(at.at), vertex(to.at), length_in, length_out);
        append();
    }
    void inner_join(Point at, Point in, Point out, double shorter) {
        const Point end = half_width_ * to_the_right(in);
        const Point start = half_width_ * to_the_right(out);
        // Each side gives up half_width tan(turn / 2), of which it can give half its length. The tangent of near half turns
        // is all rounding.
        constexpr double sharpest = 0.1;
        const double cosine_above = 1 + dot(in, out);
        if (cosine_above > sharpest && half_width_ * std::abs(cross(in, out)) <= 0.5 * shorter * cosine_above) {
            contour_.push_back(at + (end + start) / cosine_above);
        } else {
            contour_.insert(contour_.end(), {at + end, at, at + start});
        }
    }
    void append() {
        for (unsigned i = 0; i < vertices_.size(); ++i) contour_.push_back({vertices_[i].x, vertices_[i].y});
    }
    void finish() {
        contours_.push_back(std::move(contour_));
        contour_.clear();
    }

    double half_width_;
    LineCap cap_;
    agg::line_join_e join_;
    agg::math_stroke<Vertices> pen_;
    Vertices vertices_;
    std::vector<Point> contour_;
    Contours contours_;
};

Contours transformed(Contours contours, const Affine& map) {
    for (std::vector<Point>& contour : contours)
        for (Point& p : contour) p = apply(map, p);
    return contours;
}

}  // namespace

Contours stroke_outline(const std::vector<Path>& paths, const Stroke& stroke, double stroke_scale, double deviation) {
    const Affine pen{stroke.pen.a, stroke.pen.b, stroke.pen.c, stroke.pen.d};
    if (determinant(pen) == 0) return {};
    // A dash ends across its chord: the finer the chords, the straighter it stands.
    constexpr double dash_fineness = 1.0 / 8;
    const double fineness = stroke.dashes.empty() ? 1 : dash_fineness;
    const double frame_length = stroke.fixed ? 1 / stroke_scale : 1;
    const double within = deviation / largest_stretch(stroke.pen);
    const bool even = stroke.pen == Linear2{};
    std::vector<double> dashes = stroke.dashes;
    for (double& dash : dashes) dash *= frame_length;
    OutlineWriter writer(stroke, frame_length * stroke.width, within);
    for (const Path& path : paths) {
        for (const StrokeLine& line : stroke_lines(even ? path : transformed(path, inverse(pen)), fineness * within)) {
            if (dashes.empty()) {
                writer.add(line);
            } else {
                for (const StrokeLine& dash : dashed(line, dashes, frame_length * stroke.dash_offset, max_dashes))
                    writer.add(dash);
            }
        }
    }
    return even ? writer.take() : transformed(writer.take(), pen);
}

}  // namespace rinceau

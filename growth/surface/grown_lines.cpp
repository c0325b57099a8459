// Li et al. 2010, section 4.4.2. The new line is clipped at the first meeting as in the paper; it then ends on the older
// line itself, not at the nearest point of its own way, so that no gap is left on a curved surface.
#include "growth/surface/grown_lines.h"

#include <algorithm>
#include <array>
#include <limits>

namespace rinceau {

namespace {

constexpr double same_place = 1e-9;  // of the diagonal
constexpr double own_reach = 3;      // widths behind its end within which a line does not meet itself

/// The point of a face that is nearest to the foot of p's perpendicular.
SurfacePoint foot_in_face(const SurfaceMesh& surface, int face, SpacePoint p) {
    const auto& frame = surface.frame[static_cast<std::size_t>(face)];
    const SurfacePoint corner{face, surface.flat[static_cast<std::size_t>(face)][0]};
    const SpacePoint from = p - position_in_space(surface, corner);
    const SurfacePoint foot{face, corner.at + Complex{dot(from, frame[0]), dot(from, frame[1])}};
    std::array<double, 3> weights = barycentric(surface, foot);
    double sum = 0;
    for (double& weight : weights) sum += weight = std::max(weight, 0.0);
    for (double& weight : weights) weight /= sum;
    return from_barycentric(surface, face, weights);
}

/// Where p, on a piece between two points of a walk, lies on the surface.
SurfacePoint between(const SurfaceMesh& surface, SurfacePoint a, SurfacePoint b, SpacePoint p) {
    const SurfacePoint in_a = foot_in_face(surface, a.face, p), in_b = foot_in_face(surface, b.face, p);
    return abs(position_in_space(surface, in_a) - p) <= abs(position_in_space(surface, in_b) - p) ? in_a : in_b;
}

}  // namespace

void GrownLines::append(PatternLine& line, SurfacePoint at, SpacePoint point, double width) {
    line.points.push_back(point);
    line.normals.push_back(normal_at(*surface_, at));
    line.widths.push_back(width);
    line.at.push_back(at);
    ++points_;
}

bool GrownLines::stands_at_end(const ShapeScope& scope, SpacePoint position) const {
    if (scope.line < 0) return false;
    const PatternLine& line = lines_[static_cast<std::size_t>(scope.line)];
    return scope.line_points == static_cast<int>(line.points.size()) &&
           abs(line.points.back() - position) <= same_place * surface_->diagonal;
}

PatternLine& GrownLines::line_of(ShapeScope& scope, SurfacePoint start, const LinePen& pen) {
    const SpacePoint position = position_in_space(*surface_, start);
    if (!stands_at_end(scope, position)) {
        scope.line = static_cast<int>(lines_.size());
        lines_.push_back({});
        lines_.back().color = pen.color;
        append(lines_.back(), start, position, pen.width);
    }
    PatternLine& line = lines_[static_cast<std::size_t>(scope.line)];
    remember(scope.line);
    return line;
}

int GrownLines::own_neighbours(const PatternLine& line, double width) const {
    double way = 0;
    int pieces = 1;
    for (std::size_t i = line.points.size(); i-- > 1 && way < own_reach * width; ++pieces)
        way += abs(line.points[i] - line.points[i - 1]);
    return pieces;
}

bool GrownLines::draw(ShapeScope& scope, const std::vector<SurfacePoint>& path, const LinePen& pen) {
    if (path.size() < 2) return false;
    PatternLine& line = line_of(scope, path.front(), pen);
    ++line.segments;
    for (std::size_t i = 1; i < path.size() && !line.merged; ++i) {
        const SpacePoint from = line.points.back();
        SpacePoint to = position_in_space(*surface_, path[i]);
        if (from == to) continue;
        SurfacePoint at = path[i];
        if (pen.merge) {
            const auto meeting = space_.first_meeting(from, to, pen.width, scope.line, own_neighbours(line, pen.width));
            if (meeting) {
                line.merged = true;
                to = meeting->point;
                const std::vector<SurfacePoint>& older = lines_[static_cast<std::size_t>(meeting->line)].at;
                const auto piece = static_cast<std::size_t>(meeting->piece);
                at = between(*surface_, older[piece], older[piece + 1], to);
            }
        }
        append(line, at, to, pen.width);
        if (in_set_) {
            waiting_.push_back({from, to, pen.width, scope.line});
        } else {
            space_.add(from, to, pen.width, scope.line);
        }
    }
    scope.line_points = static_cast<int>(line.points.size());
    if (!line.merged) return false;
    scope.at = line.at.back();
    scope.line = -1;
    return true;
}

void GrownLines::remember(int index) {
    const bool from_before = in_set_ && static_cast<std::size_t>(index) < lines_before_;
    if (!from_before || std::ranges::find(changed_, index, &SetLine::line) != changed_.end()) return;
    const PatternLine& line = lines_[static_cast<std::size_t>(index)];
    changed_.push_back({index, line.points.size(), line.segments, line.at.back()});
}

void GrownLines::move_end(PatternLine& line, SurfacePoint place) {
    line.points.back() = position_in_space(*surface_, place);
    line.normals.back() = normal_at(*surface_, place);
    line.at.back() = place;
}

void GrownLines::end_at(const ShapeScope& scope, SurfacePoint place) {
    if (!stands_at_end(scope, position_in_space(*surface_, scope.at))) return;
    remember(scope.line);
    move_end(lines_[static_cast<std::size_t>(scope.line)], place);
}

void GrownLines::begin_set() {
    in_set_ = true;
    lines_before_ = lines_.size();
}

void GrownLines::keep_set() {
    for (const Piece& piece : waiting_) space_.add(piece.from, piece.to, piece.width, piece.line);
    in_set_ = false;
    waiting_.clear();
    changed_.clear();
}

void GrownLines::drop_set() {
    for (; lines_.size() > lines_before_; lines_.pop_back()) points_ -= static_cast<long>(lines_.back().points.size());
    for (const SetLine& before : changed_) {
        PatternLine& line = lines_[static_cast<std::size_t>(before.line)];
        points_ -= static_cast<long>(line.points.size() - before.points);
        line.points.resize(before.points);
        line.normals.resize(before.points);
        line.widths.resize(before.points);
        line.at.resize(before.points);
        line.segments = before.segments;
        line.merged = false;
        move_end(line, before.last);
    }
    in_set_ = false;
    waiting_.clear();
    changed_.clear();
}

}  // namespace rinceau

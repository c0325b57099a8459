// Li et al. 2010, section 4.3.1: hyperstreamlines at a constant angle through the flat frames of the faces.
//
// The eigenvector that the walk follows is `axis_`, the walk's angle to it `relative_`: direction = axis * relative, and
// relative stays. Of the n directions of the field that one is taken which is nearest to the last, hence no sign jumps.
// The paper steps by Euler's or Runge-Kutta's rule; we by the midpoint rule, which is second order as the field itself is.
//
// Deviations:
// - A jump over a singular point (figure 9) goes straight on over the edges around it, where the paper clamps to the face.
// - The step shrinks to a quarter of the distance from a singular point, and where the field turns much.

#include "growth/surface/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/angle.h"
#include "geometry/index.h"
#include "growth/surface/field_filled.h"

namespace rinceau {
namespace {

constexpr int most_halvings = 8;              // of a step that turns too much
constexpr double share_of_distance = 0.25;    // of a step near a singular point
constexpr double smallest_near_zero = 0.005;  // of the longest edge: steps at a singular point that is not jumped over
constexpr double edge_ends = 1e-12;     // of an edge: crossings stay so far from vertices, where the way out is not defined
constexpr double parallel = 1e-12;      // a way that leaves an edge by less, per length, runs along it
constexpr double longer_to_edge = 1.5;  // the piece that ends on an edge may be so much longer than foreseen
constexpr double no_way = 1e-9;         // a piece shorter than this share of the foreseen one makes no way
// bound of the work; usual walks have 3 to 5 pieces for each mean edge of their length
constexpr long least_budget = 2000;
constexpr double pieces_of_edge = 100, most_edges = 2000;
constexpr int least_substeps = 4;  // of a move that follows the field in part

/// The edge ahead of a point in its face.
struct EdgeAhead {
    double distance = std::numeric_limits<double>::infinity();
    int half_edge = -1;
};

EdgeAhead edge_ahead(const SurfaceMesh& surface, SurfacePoint p, Complex direction) {
    const auto& flat = surface.flat[at(p.face)];
    EdgeAhead ahead;
    for (int k = 0; k < 3; ++k) {
        const Complex start = flat[at(k)], edge = flat[at(k == 2 ? 0 : k + 1)] - start;
        const double rate = cross(direction, edge);
        if (rate <= parallel * (std::abs(edge.x) + std::abs(edge.y))) continue;
        const double distance = std::max(0.0, cross(edge, p.at - start)) / rate;
        if (distance < ahead.distance) ahead = {distance, 3 * p.face + k};
    }
    return ahead;
}

class Walk {
  public:
    Walk(const SurfaceMesh& surface, const FieldOnSurface* field, SurfacePoint start, Complex direction, double length,
         const TraceOptions& options)
        : surface_(surface),
          field_(field),
          options_(options),
          at_(start),
          direction_(direction),
          rest_(length),
          most_turn_(std::cos(radians(options.turn))) {
        budget_ = least_budget + static_cast<long>(pieces_of_edge * std::min(length / surface.mean_edge, most_edges));
        cautious_until_ = budget_ / 2;
        keep(start);
    }

    void go_straight();
    void go_along_field();
    void follow_in_part();
    SurfaceTrace result() const;

  private:
    bool more() { return rest_ > 0 && !walk_.at_border && --budget_ > 0; }
    bool cautious() const { return budget_ > cautious_until_; }
    void keep(SurfacePoint p) {
        if (options_.keep_path) walk_.path.push_back(p);
    }
    void advance(double distance, Complex direction);
    void cross_edge(int half_edge);
    bool leaves_over(int half_edge) const;
    void walk_straight(double length);
    Complex axis_at(SurfacePoint p, Complex near) const { return root_near(field_->at(p), field_->n(), near); }
    void step_along_field(double most);
    double slide(int half_edge, double distance, Complex& direction);
    void leave_vertex(int half_edge);
    void end_piece(Complex piece, Complex axis);
    double step_near_zero(double most);
    void jump(Complex to_zero);

    const SurfaceMesh& surface_;
    const FieldOnSurface* field_;
    const TraceOptions& options_;
    SurfaceTrace walk_;
    SurfacePoint at_;
    Complex direction_;
    Complex axis_, relative_;  ///< with a field
    double rest_;
    double most_turn_;         ///< cosine
    long budget_ = 0;          ///< of pieces
    long cautious_until_ = 0;  ///< with less left, steps do not shrink any more
};

void Walk::advance(double distance, Complex direction) {
    at_.at += distance * direction;
    walk_.length += distance;
    rest_ -= distance;
}

bool Walk::leaves_over(int half_edge) const { return cross(direction_, edge_vector(surface_, half_edge)) > 0; }

/// The point lies on the edge.
void Walk::cross_edge(int h) {
    const int twin = surface_.twin[at(h)];
    if (twin < 0) {
        walk_.at_border = true;
        return;
    }
    const Complex edge = edge_vector(surface_, h), turn = surface_.across[at(h)];
    const double share = dot(at_.at - surface_.flat[at(at_.face)][at(h % 3)], edge) / norm(edge);
    at_.face = face_of(twin);
    at_.at = surface_.flat[at(at_.face)][at(twin % 3)] +
             (1 - std::clamp(share, edge_ends, 1 - edge_ends)) * edge_vector(surface_, twin);
    direction_ = direction_ * turn;
    axis_ = axis_ * turn;
    keep(at_);
}

void Walk::walk_straight(double length) {
    double left = length;
    while (left > 0 && !walk_.at_border && --budget_ > 0) {
        const EdgeAhead ahead = edge_ahead(surface_, at_, direction_);
        const bool crosses = ahead.distance <= left;
        const double distance = crosses ? ahead.distance : left;
        advance(distance, direction_);
        left -= distance;
        if (crosses) cross_edge(ahead.half_edge);
    }
}

void Walk::go_straight() { walk_straight(rest_); }

/// Along an edge that the field leads back over at once; gives what was walked, and the direction.
double Walk::slide(int h, double distance, Complex& direction) {
    const Complex edge = edge_vector(surface_, h), start = surface_.flat[at(at_.face)][at(h % 3)];
    const double length = abs(edge), before = dot(at_.at - start, edge) / length;
    direction = dot(direction, edge) >= 0 ? edge / length : -edge / length;
    const double after = std::clamp(before + (dot(direction, edge) >= 0 ? distance : -distance), edge_ends * length,
                                    (1 - edge_ends) * length);
    return std::abs(after - before);
}

/// From the end of an edge that the walk has slid along, out into the face that lies ahead by the angles of the vertex's
/// frame, which are the field's.
void Walk::leave_vertex(int h) {
    const Complex edge = edge_vector(surface_, h);
    const bool at_start = norm(at_.at - surface_.flat[at(at_.face)][at(h % 3)]) < norm(edge) / 4;
    const double ahead = at_start ? surface_.angle[at(h)] + arg(direction_ * conj(edge))
                                  : surface_.angle_back[at(h)] + arg(direction_ * conj(-edge));
    const int v = at_start ? start_of(surface_, h) : end_of(surface_, h), first = surface_.outgoing[at(v)];
    int out = first;
    do {
        const double scale = surface_.angle_scale[at(v)], beyond = wrap_angle(ahead - surface_.angle[at(out)]);
        const double turn = (beyond < 0 ? beyond + two_pi : beyond) / scale;
        if (turn <= corner_angle(surface_, out)) {
            const Complex side = edge_vector(surface_, out), ray = side / abs(side) * polar(1, turn);
            at_.face = face_of(out);
            at_.at = surface_.flat[at(at_.face)][at(out % 3)] + edge_ends * abs(side) * ray;
            direction_ = ray;
            axis_ = ray * conj(relative_);
            keep(at_);
            return;
        }
        out = next_about_start(surface_, out);
    } while (out >= 0 && out != first);
    walk_.at_border = true;
}

/// Direction and error at the end of a straight piece; `axis` is that in its middle.
void Walk::end_piece(Complex piece, Complex axis) {
    const Complex before = direction_;
    axis_ = axis_at(at_, axis);
    direction_ = axis_ * relative_;
    const Complex mean = before + direction_;
    const double error = std::atan2(std::abs(cross(piece, mean)), dot(piece, mean));
    walk_.angle_error = std::max(walk_.angle_error, error);
    walk_.angle_error_sum += error;
    ++walk_.angle_samples;
}

void Walk::step_along_field(double most) {
    const EdgeAhead foreseen = edge_ahead(surface_, at_, direction_);
    if (foreseen.distance <= 0) return cross_edge(foreseen.half_edge);
    bool to_edge = foreseen.distance <= most;
    double reach = to_edge ? foreseen.distance : most;
    Complex axis, piece;
    for (int halvings = 0;; ++halvings) {
        axis = axis_at({at_.face, at_.at + reach / 2 * direction_}, axis_);
        piece = axis * relative_;
        if (dot(piece, direction_) >= most_turn_ || halvings == most_halvings || !cautious()) break;
        reach /= 2;
        to_edge = false;
    }
    if (to_edge) reach = std::min(most, longer_to_edge * reach);
    EdgeAhead ahead = edge_ahead(surface_, at_, piece);
    if (ahead.distance <= no_way * reach && !leaves_over(ahead.half_edge)) {
        reach = slide(ahead.half_edge, reach, piece);
        if (reach <= edge_ends * surface_.longest_edge) return leave_vertex(ahead.half_edge);
        ahead.distance = std::numeric_limits<double>::infinity();
    }
    const bool arrives = ahead.distance <= reach;
    advance(arrives ? ahead.distance : reach, piece);
    end_piece(piece, axis);
    if (arrives && leaves_over(ahead.half_edge))
        cross_edge(ahead.half_edge);
    else
        keep(at_);
}

/// Straight over a singular point to the other side, as far from it as before. At a negative index the walk goes on in its
/// direction, at a positive one mirrored at the way over the point.
void Walk::jump(Complex to_zero) {
    const bool mirrored = field_->index(at_.face) > 0;
    const double distance = abs(to_zero);
    const Complex over = to_zero / distance, turn = direction_ * conj(over);
    keep(at_);
    direction_ = over;
    walk_straight(std::min(rest_, 2 * distance));
    direction_ = direction_ * (mirrored ? conj(turn) : turn);
    axis_ = axis_at(at_, direction_ * conj(relative_));
    relative_ = direction_ * conj(axis_);
    ++walk_.jumps;
    keep(at_);
}

/// How far the next step may go in a face with a singular point; 0 = a jump was made instead.
double Walk::step_near_zero(double most) {
    const Complex to_zero = field_->zero(at_.face) - at_.at;
    const double distance = abs(to_zero);
    if (distance > 0 && distance < options_.jump * surface_.longest_edge && dot(to_zero, direction_) > 0) {
        jump(to_zero);
        return 0;
    }
    if (!cautious()) return most;
    return std::min(most, std::max(share_of_distance * distance, smallest_near_zero * surface_.longest_edge));
}

void Walk::go_along_field() {
    axis_ = axis_at(at_, direction_);
    relative_ = direction_ * conj(axis_);
    while (more()) {
        double most = std::min(rest_, options_.step * surface_.longest_edge);
        if (field_->index(at_.face) != 0) most = step_near_zero(most);
        if (most > 0) step_along_field(most);
    }
}

/// Straight for a while, then turned by a share of what the field has turned against the walk.
void Walk::follow_in_part() {
    const int n = field_->n();
    const double substeps = std::max<double>(least_substeps, std::ceil(rest_ / surface_.longest_edge));
    const double most = rest_ / substeps;
    while (more()) {
        const Complex before = power(direction_, n) * conj(field_->at(at_));
        walk_straight(std::min(rest_, most));
        const Complex after = power(direction_, n) * conj(field_->at(at_));
        direction_ = direction_ * polar(1, options_.follow / n * arg(before * conj(after)));
        keep(at_);
    }
}

SurfaceTrace Walk::result() const {
    SurfaceTrace walk = walk_;
    walk.end = at_;
    walk.direction = direction_;
    if (options_.keep_path && !(walk.path.back().face == at_.face && walk.path.back().at == at_.at))
        walk.path.push_back(at_);
    return walk;
}

}  // namespace

SurfaceTrace trace(const SurfaceMesh& surface, const FieldOnSurface* field, SurfacePoint start, Complex direction,
                   double length, const TraceOptions& options) {
    Walk walk(surface, field, start, direction, length, options);
    if (!field || options.follow <= 0)
        walk.go_straight();
    else if (options.follow >= 1)
        walk.go_along_field();
    else
        walk.follow_in_part();
    return walk.result();
}

}  // namespace rinceau

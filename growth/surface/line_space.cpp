// Li et al. 2010, section 4.4.2: a new piece is clipped at its first intersection with the pieces about it. In space two
// lines on a bent surface are skew: they meet where their axes pass each other, between the ends of both, nearer than the
// width. Deviation: lines that run into each other end to end do not cross; such pieces meet where the new one comes as near
// as a quarter of both widths.

#include "growth/surface/line_space.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "growth/surface/sphere_grid.h"

namespace rinceau {
namespace {

constexpr double passing_share = 0.6;  // of both widths: axes that pass nearer meet
constexpr double end_share = 0.25;     // of both widths: a piece that comes as near to a parallel one meets it
constexpr double parallel = 0.1;       // sine of the angle between pieces that count as parallel
constexpr double joint_share = 0.125;  // of the width: old pieces reach over their ends, so that bends leave no gap
constexpr double just_begun = 1e-9;    // of the new piece: a line that begins on another one does not meet it there

struct Piece {
    SpacePoint from, to;
    double width = 0;
    int line = 0;
};

struct Passing {
    double share = 0;  ///< of the new piece
    SpacePoint point;  ///< on the other one
};

SpacePoint at(const Piece& piece, double share) { return piece.from + share * (piece.to - piece.from); }

SpacePoint nearest_on(const Piece& piece, SpacePoint p) {
    const SpacePoint along = piece.to - piece.from;
    const double length = dot(along, along);
    return at(piece, length > 0 ? std::clamp(dot(p - piece.from, along) / length, 0.0, 1.0) : 0);
}

/// Where the axes of two pieces that are not parallel pass each other.
std::optional<Passing> crossing(const Piece& piece, const Piece& other) {
    const SpacePoint d = piece.to - piece.from, e = other.to - other.from, r = piece.from - other.from;
    const double dd = dot(d, d), ee = dot(e, e), de = dot(d, e), rd = dot(r, d), re = dot(r, e);
    const double determinant = dd * ee - de * de;
    if (!(determinant > parallel * parallel * dd * ee)) return std::nullopt;
    const double s = (de * re - ee * rd) / determinant, t = (dd * re - de * rd) / determinant;
    const double over = joint_share * other.width / std::sqrt(ee);
    if (s <= just_begun || s > 1 || t < -over || t > 1 + over) return std::nullopt;
    const SpacePoint point = at(other, std::clamp(t, 0.0, 1.0));
    if (abs(at(piece, s) - at(other, t)) >= passing_share * (piece.width + other.width)) return std::nullopt;
    return Passing{s, point};
}

/// Where a piece that begins outside comes near a parallel one.
std::optional<Passing> running_into(const Piece& piece, const Piece& other) {
    const SpacePoint d = piece.to - piece.from, e = other.to - other.from;
    const SpacePoint normal = cross(d, e);
    if (dot(normal, normal) > parallel * parallel * dot(d, d) * dot(e, e)) return std::nullopt;
    const double reach = end_share * (piece.width + other.width);
    const auto distance = [&](double share) { return abs(at(piece, share) - nearest_on(other, at(piece, share))); };
    if (distance(0) <= reach || distance(1) > reach) return std::nullopt;
    double outside = 0, inside = 1;
    constexpr int halvings = 30;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (outside + inside);
        (distance(middle) <= reach ? inside : outside) = middle;
    }
    return Passing{inside, nearest_on(other, at(piece, inside))};
}

/// Of a ball that holds the piece with all that it may meet.
double reach_of(const Piece& piece) { return 0.5 * abs(piece.to - piece.from) + passing_share * piece.width; }
SpacePoint middle_of(const Piece& piece) { return 0.5 * (piece.from + piece.to); }

}  // namespace

struct LineSpace::Pieces {
    SphereGrid grid;
    std::vector<Piece> pieces;
    std::vector<int> number_in_line;  ///< by piece
    std::vector<int> count_of_line;   ///< by line
};

LineSpace::LineSpace() : pieces_(std::make_unique<Pieces>()) {}
LineSpace::~LineSpace() = default;
LineSpace::LineSpace(LineSpace&&) noexcept = default;
LineSpace& LineSpace::operator=(LineSpace&&) noexcept = default;

std::optional<LineMeeting> LineSpace::first_meeting(SpacePoint from, SpacePoint to, double width, int line, int skip) const {
    const Piece piece{from, to, width, line};
    const auto own = static_cast<std::size_t>(line);
    const int own_pieces = own < pieces_->count_of_line.size() ? pieces_->count_of_line[own] : 0;
    std::optional<LineMeeting> first;
    int met = 0;
    pieces_->grid.visit(middle_of(piece), reach_of(piece), [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const Piece& other = pieces_->pieces[index];
        if (other.line == line && pieces_->number_in_line[index] >= own_pieces - skip) return;
        std::optional<Passing> passing = crossing(piece, other);
        if (!passing) passing = running_into(piece, other);
        if (!passing) return;
        if (first && (passing->share > first->share || (passing->share == first->share && i > met))) return;
        first = LineMeeting{other.line, pieces_->number_in_line[index], passing->share, passing->point};
        met = i;
    });
    return first;
}

void LineSpace::add(SpacePoint from, SpacePoint to, double width, int line) {
    const Piece piece{from, to, width, line};
    const auto own = static_cast<std::size_t>(line);
    if (own >= pieces_->count_of_line.size()) pieces_->count_of_line.resize(own + 1, 0);
    pieces_->number_in_line.push_back(pieces_->count_of_line[own]++);
    pieces_->pieces.push_back(piece);
    pieces_->grid.add(middle_of(piece), reach_of(piece));
}

}  // namespace rinceau

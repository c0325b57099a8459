// Li et al. 2010, section 4.2: values at the vertices, interpolated so that the field is continuous over edges (after Zhang,
// Mischaikow & Turk 2006: a corner's value is carried along the ray from the corner to the point).
//
// Seen along the edge from i to j the value of corner i is A_i = z_i exp(i n (way of the edge - angle of the edge)) in the
// face's frame; along the edge from i to k it is B_i = A_i exp(i n (1 - scale_i) corner_i). Between them it is blended by
// u = b_k / (b_j + b_k), which costs no angle functions, where it turns little, and turned by the ray's own angle where it
// turns much (spikes), as a blend of opposite values would be 0. Both agree on the edges, hence faces of both kinds join.
//
// Index of a face: (sum of the turns along its edges + n (sum of its scaled corners - pi)) / 2 pi. A turn is computed once
// for an edge and negated for its twin, so that a turn of exactly pi cannot count twice with the same sign.

#include "growth/surface/surface_field.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "growth/surface/field_filled.h"

namespace rinceau {
namespace {

constexpr double most_blended = pi / 4;  ///< turn of a corner's value; a blend is then weaker by 8 % at most

std::size_t index_of(int i) { return static_cast<std::size_t>(i); }

Point place_of(const SurfaceMesh& surface, SurfacePoint p) {
    const SpacePoint place = position_in_space(surface, p);
    return {place.x, place.y};
}

Complex unit_edge(const SurfaceMesh& surface, int h) {
    const Complex along = edge_vector(surface, h);
    return along / abs(along);
}

/// How much more than the flat face's the value of corner h turns from its first edge to its last.
double corner_turn(const SurfaceMesh& surface, int h, int n) {
    return n * (1 - surface.angle_scale[index_of(start_of(surface, h))]) * corner_angle(surface, h);
}

/// By half-edge: the angle by which the field turns along it.
std::vector<double> edge_turns(const SurfaceMesh& surface, const SurfaceField& field) {
    std::vector<double> turns(surface.twin.size(), 0);
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        const int twin = surface.twin[index_of(h)];
        if (twin >= 0 && twin < h) continue;
        const Complex start = field.values[index_of(start_of(surface, h))], end = field.values[index_of(end_of(surface, h))];
        turns[index_of(h)] = arg(end / abs(end) * conj(start / abs(start) * power(transport_along(surface, h), field.n)));
        if (twin >= 0) turns[index_of(twin)] = -turns[index_of(h)];
    }
    return turns;
}

std::vector<signed char> indices(const SurfaceMesh& surface, const SurfaceField& field) {
    const std::vector<double> turns = edge_turns(surface, field);
    std::vector<signed char> index;
    for (int f = 0; f < surface.faces(); ++f) {
        double turn = -pi * field.n;
        for (int h = 3 * f; h < 3 * f + 3; ++h) {
            const double scaled_corner = surface.angle_scale[index_of(start_of(surface, h))] * corner_angle(surface, h);
            turn += turns[index_of(h)] + field.n * scaled_corner;
        }
        index.push_back(static_cast<signed char>(std::lround(turn / two_pi)));
    }
    return index;
}

/// Best of a grid over the face, then Newton's steps while they help.
Complex find_zero(const FieldOnSurface& field, int face) {
    constexpr int cells = 12, most_steps = 30;
    constexpr double difference = 1e-6;  // of an edge, in weights
    const SurfaceMesh& surface = field.surface();
    const auto value = [&](double b1, double b2) {
        return field.at(from_barycentric(surface, face, {1 - b1 - b2, b1, b2}));
    };
    double b1 = 1.0 / 3, b2 = 1.0 / 3, best = abs(value(b1, b2));
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; i + j <= cells; ++j) {
            const double c1 = (i + 0.0) / cells, c2 = (j + 0.0) / cells, size = abs(value(c1, c2));
            if (size < best) b1 = c1, b2 = c2, best = size;
        }
    for (int step = 0; step < most_steps; ++step) {
        // the differences look inwards, so that they stay in the face
        const double d1 = b1 > 0.5 ? -difference : difference, d2 = b2 > 0.5 ? -difference : difference;
        const Complex z = value(b1, b2), by1 = (value(b1 + d1, b2) - z) / d1, by2 = (value(b1, b2 + d2) - z) / d2;
        const double area = cross(by1, by2);
        if (!(std::abs(area) > 0)) break;
        double c1 = std::max(0.0, b1 - cross(z, by2) / area), c2 = std::max(0.0, b2 - cross(by1, z) / area);
        if (const double sum = c1 + c2; sum > 1) c1 /= sum, c2 /= sum;
        const double size = abs(value(c1, c2));
        if (!(size < best)) break;
        b1 = c1, b2 = c2, best = size;
    }
    return from_barycentric(surface, face, {1 - b1 - b2, b1, b2}).at;
}

/// The closed form's centre in a face's frame, pulled into the face.
Complex centre_in(const SurfaceMesh& surface, const PlaneForm& form, int face) {
    const SpacePoint origin = surface.mesh.positions[index_of(surface.mesh.triangles[index_of(face)][0])];
    const auto& frame = surface.frame[index_of(face)];
    const SpacePoint away{form.centre.x - origin.x, form.centre.y - origin.y, 0};
    auto weights = barycentric(surface, {face, {dot(away, frame[0]), dot(away, frame[1])}});
    double sum = 0;
    for (double& weight : weights) sum += weight = std::max(weight, 0.0);
    for (double& weight : weights) weight /= sum;
    return from_barycentric(surface, face, weights).at;
}

/// Of a number of length 1; the half that does not cancel is computed first.
Complex square_root(Complex z) {
    if (z.x >= 0) {
        const double x = std::sqrt((1 + z.x) / 2);
        return {x, z.y / (2 * x)};
    }
    const double y = std::copysign(std::sqrt((1 - z.x) / 2), z.y);
    return {z.y / (2 * y), y};
}

}  // namespace

FieldOnSurface::FieldOnSurface(const SurfaceMesh& surface, SurfaceField field)
    : surface_(&surface), field_(filled_field(surface, std::move(field))) {
    const int n = field_.n;
    for (int f = 0; f < surface.faces(); ++f) {
        std::array<Complex, 6> corners;
        bool sharp = false;
        for (int k = 0; k < 3; ++k) {
            const int h = 3 * f + k;
            const Complex axis = unit_edge(surface, h) * polar(1, -surface.angle[index_of(h)]);
            const double turn = corner_turn(surface, h, n);
            corners[index_of(k)] = field_.values[index_of(start_of(surface, h))] * power(axis, n);
            corners[index_of(k + 3)] = corners[index_of(k)] * polar(1, turn);
            sharp = sharp || std::abs(turn) > most_blended;
        }
        corners_.push_back(corners);
        sharp_.push_back(sharp);
    }
    index_ = indices(surface, field_);
    for (int f = 0; f < surface.faces(); ++f)
        if (index(f) != 0) singular_.push_back(f);
    for (const int f : singular_)
        zeros_.push_back(field_.exact && field_.exact->about_centre ? centre_in(surface, *field_.exact, f)
                                                                    : find_zero(*this, f));
}

Complex FieldOnSurface::at(SurfacePoint p) const {
    const auto face = static_cast<std::size_t>(p.face);
    if (of_plane(field_)) {
        const SpacePoint x = surface_->frame[face][0];
        return plane_value(field_, place_of(*surface_, p)) * conj(power({x.x, x.y}, field_.n));
    }
    const auto& corners = corners_[face];
    const auto weights = barycentric(*surface_, p);
    Complex sum;
    if (sharp_[face]) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int h = 3 * p.face + static_cast<int>(i);
            const Complex ray = p.at - surface_->flat[face][i], along = edge_vector(*surface_, h);
            const double angle = std::max(0.0, std::atan2(cross(along, ray), dot(along, ray)));
            const double scale = surface_->angle_scale[index_of(start_of(*surface_, h))];
            sum += std::max(0.0, weights[i]) * (corners[i] * polar(1, field_.n * (1 - scale) * angle));
        }
        return sum;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double to_next = weights[(i + 1) % 3], to_last = weights[(i + 2) % 3], both = to_next + to_last;
        const double u = both > 0 ? std::clamp(to_last / both, 0.0, 1.0) : 0;
        sum += weights[i] * (corners[i] + u * (corners[i + 3] - corners[i]));
    }
    return sum;
}

double FieldOnSurface::isotropic_at(SurfacePoint p) const {
    if (field_.isotropic.empty()) return 0;
    const auto weights = barycentric(*surface_, p);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += weights[i] * field_.isotropic[index_of(surface_->mesh.triangles[index_of(p.face)][i])];
    return sum;
}

double FieldOnSurface::scalar_at(SurfacePoint p) const {
    if (field_.scalar.empty()) return field_.picture ? brightness_at(*field_.picture, place_of(*surface_, p)) : abs(at(p));
    const auto weights = barycentric(*surface_, p);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += weights[i] * field_.scalar[index_of(surface_->mesh.triangles[index_of(p.face)][i])];
    return sum;
}

std::optional<std::array<double, 3>> FieldOnSurface::colour_at(SurfacePoint p) const {
    if (!field_.picture) return std::nullopt;
    return rinceau::colour_at(*field_.picture, place_of(*surface_, p));
}

double FieldOnSurface::plane_step() const {
    constexpr double step_of_form = 1e-5;  // diagonals
    if (field_.exact) return step_of_form * surface_->diagonal;
    return field_.along_picture ? pixel_side(*field_.picture) : 0;
}

Complex FieldOnSurface::zero(int face) const {
    const auto found = std::ranges::lower_bound(singular_, face);
    return zeros_[static_cast<std::size_t>(found - singular_.begin())];
}

long FieldOnSurface::index_sum() const {
    long sum = 0;
    for (const int face : singular_) sum += index(face);
    return sum;
}

Complex root_near(Complex z, int n, Complex near) {
    const double length = abs(z);
    if (!(length > 0)) return near / abs(near);
    Complex root = z / length;
    for (int order = 1; order < n; order *= 2) root = square_root(root);
    if (n == 4 && std::abs(cross(root, near)) > std::abs(dot(root, near))) root = Complex{-root.y, root.x};
    if (n > 1 && dot(root, near) < 0) root = -root;
    return root;
}

}  // namespace rinceau

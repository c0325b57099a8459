#include "growth/surface/scope_queries.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "growth/surface/field_gradient.h"
#include "growth/surface/plane_picture.h"

namespace rinceau {

namespace {

double component(SpacePoint p, int index) { return index == 0 ? p.x : index == 1 ? p.y : p.z; }

/// Signs of lines and crosses are free: the nearest to X. A field that is 0 here has the direction of X.
Complex direction_one(const FieldOnSurface& field, SurfacePoint p, Complex x) {
    const Complex z = field.at(p);
    return abs(z) > 0 ? root_near(z, field.n(), x) : x;
}

constexpr Complex quarter_turn{0, 1};

/// Of a line field the sign of the second direction is free too.
Complex direction_two(const FieldOnSurface& field, Complex one, Complex x) {
    const Complex two = one * quarter_turn;
    return field.n() % 2 == 0 && dot(two, x) < 0 ? -two : two;
}

/// From X, degrees in (-180, 180]; of a line in (-90, 90]; of a cross in (-45, 45].
double angle_from(Complex x, Complex direction, int n) {
    const double angle = degrees(arg(direction * conj(x))), most = 180.0 / n;
    return angle <= -most + 1e-12 * most && n > 1 ? most : angle;
}

double length_one(const FieldOnSurface& field, SurfacePoint p) {
    return (field.n() == 2 ? field.isotropic_at(p) : 0) + abs(field.at(p));
}
double length_two(const FieldOnSurface& field, SurfacePoint p) {
    return field.n() == 2 ? field.isotropic_at(p) - abs(field.at(p)) : abs(field.at(p));
}

/// Of numbers by vertex, linear within the face.
Complex gradient_of(const std::vector<double>& numbers, const SurfaceMesh& surface, int face) {
    if (numbers.empty()) return {};
    const auto& corners = surface.mesh.triangles[static_cast<std::size_t>(face)];
    const auto& flat = surface.flat[static_cast<std::size_t>(face)];
    const double twice_area = cross(flat[1] - flat[0], flat[2] - flat[0]);
    Complex sum;
    for (std::size_t k = 0; k < 3; ++k) {
        const Complex opposite = flat[(k + 2) % 3] - flat[(k + 1) % 3];
        sum += numbers[static_cast<std::size_t>(corners[k])] / twice_area * (quarter_turn * opposite);
    }
    return sum;
}

/// Of length1, in the face's frame: the strength abs(z) changes as z does along its own direction.
Complex gradient_of_length(const FieldOnSurface& field, SurfacePoint p) {
    if (!field.field().scalar.empty()) return scalar_gradient(field, p);
    const Complex z = field.at(p);
    if (abs(z) == 0) return {};
    const VectorGradient change = value_gradient(field, p);
    const Complex strength{dot(z, change.by_x) / abs(z), dot(z, change.by_y) / abs(z)};
    return field.n() == 2 ? strength + gradient_of(field.field().isotropic, field.surface(), p.face) : strength;
}

/// Of the field line, for vectors of any length.
double line_curvature(const FieldOnSurface& field, SurfacePoint p, Complex one) {
    const double curvature = streamline_curvature(vector_gradient(field, p, one), one);
    const double strength = field.n() == 1 ? abs(field.at(p)) : 1;
    return strength > 0 ? curvature / strength : 0;
}

}  // namespace

double ScopeQueries::from_picture(const FieldOnSurface& field, FieldQuantity quantity) {
    if (!field.field().picture) return quantity == FieldQuantity::brightness ? field.scalar_at(scope_->at) : 0;
    const PlanePicture& picture = *field.field().picture;
    const SpacePoint p = frame().position;
    if (quantity == FieldQuantity::brightness) return brightness_at(picture, {p.x, p.y});
    return colour_at(picture, {p.x, p.y})[quantity == FieldQuantity::red ? 0 : quantity == FieldQuantity::green ? 1 : 2];
}

/// In space, to the nearest singular point.
double ScopeQueries::to_singular_point(int number, const FieldOnSurface& field) {
    const auto [known, is_new] = singular_.try_emplace(number);
    if (is_new)
        for (const int face : field.singular_faces())
            known->second.add(position_in_space(field.surface(), {face, field.zero(face)}));
    const auto nearest = known->second.nearest(position_in_space(field.surface(), scope_->at));
    return nearest ? nearest->distance : field.surface().diagonal;
}

const ScopeFrame& ScopeQueries::frame() {
    if (!frame_) frame_ = frame_in_space(*world_->surface, *scope_);
    return *frame_;
}

double ScopeQueries::near(int shape) {
    const std::vector<int> own = kin_->last(scope_->kin, 1);
    return std::min(placed_->distance(shape, frame().position, own.empty() ? -1 : own.front()), world_->surface->diagonal);
}

double ScopeQueries::of_field(const ShapeQuery& query) {
    const FieldOnSurface& field =
        *world_->fields[static_cast<std::size_t>(fields_[static_cast<std::size_t>(query.field)])].field;
    const SurfacePoint p = scope_->at;
    const Complex one = direction_one(field, p, scope_->x), two = direction_two(field, one, scope_->x);
    const auto in_space = [&](Complex direction) {
        return component(direction_in_space(*world_->surface, p.face, direction), query.component);
    };
    switch (query.quantity) {
        case FieldQuantity::angle1:
            return angle_from(scope_->x, one, field.n());
        case FieldQuantity::angle2:
            return angle_from(scope_->x, two, std::min(field.n(), 2));
        case FieldQuantity::length1:
        case FieldQuantity::maxcurv:
            return length_one(field, p);
        case FieldQuantity::length2:
        case FieldQuantity::mincurv:
            return length_two(field, p);
        case FieldQuantity::mean:
            return (length_one(field, p) + length_two(field, p)) / 2;
        case FieldQuantity::gauss:
            return length_one(field, p) * length_two(field, p);
        case FieldQuantity::vector1:
            return in_space(length_one(field, p) * one);
        case FieldQuantity::vector2:
            return in_space(length_two(field, p) * two);
        case FieldQuantity::direction1:
            return in_space(one);
        case FieldQuantity::direction2:
            return in_space(two);
        case FieldQuantity::divergence:
            return divergence(vector_gradient(field, p, one));
        case FieldQuantity::curl:
            return curl(vector_gradient(field, p, one));
        case FieldQuantity::curvature:
            return line_curvature(field, p, one);
        case FieldQuantity::gradient:
            return in_space(gradient_of_length(field, p));
        case FieldQuantity::index:
            return field.index(p.face);
        case FieldQuantity::distance:
            return to_singular_point(query.field, field);
        case FieldQuantity::red:
        case FieldQuantity::green:
        case FieldQuantity::blue:
        case FieldQuantity::brightness:
            return from_picture(field, query.quantity);
        case FieldQuantity::value:
            return field.scalar_at(p);
    }
    return 0;
}

double ScopeQueries::answer(const ShapeQuery& query) {
    using About = ShapeQuery::About;
    switch (query.about) {
        case About::field:
            return of_field(query);
        case About::size:
            return component(scope_->size, query.component);
        case About::position:
            return component(frame().position, query.component);
        case About::normal:
            return component(frame().normal, query.component);
        case About::depth:
            return depth_;
        case About::count:
            return static_cast<double>(placed_->count(shapes_[static_cast<std::size_t>(query.shape)]));
        case About::near:
            return near(shapes_[static_cast<std::size_t>(query.shape)]);
    }
    return 0;
}

}  // namespace rinceau

#include "growth/surface/scope_queries.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

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

}  // namespace

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
        case FieldQuantity::index:
            return field.index(p.face);
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

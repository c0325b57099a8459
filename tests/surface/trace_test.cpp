#include "growth/surface/trace.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "surface_directions.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

/// The place of the plane or the sphere nearest to a point in space.
SurfacePoint nearest_place(const SurfaceMesh& surface, SpacePoint p) {
    SurfacePoint best;
    double nearest = 1e300;
    for (int f = 0; f < surface.faces(); ++f) {
        const SpacePoint way =
            p - surface.mesh.positions[static_cast<std::size_t>(surface.mesh.triangles[static_cast<std::size_t>(f)][0])];
        const auto& frame = surface.frame[static_cast<std::size_t>(f)];
        const SurfacePoint here{f, {dot(way, frame[0]), dot(way, frame[1])}};
        const auto weights = barycentric(surface, here);
        const double away = std::abs(dot(way, frame[2]));
        if (*std::ranges::min_element(weights) > -1e-12 && away < nearest) nearest = away, best = here;
    }
    return best;
}

double smallest_weight(const SurfaceMesh& surface, SurfacePoint p) {
    const auto weights = barycentric(surface, p);
    return *std::ranges::min_element(weights);
}

/// The eigenvector at a place, turned by an angle.
Complex at_angle(const FieldOnSurface& field, SurfacePoint p, Complex near, double angle) {
    return root_near(field.at(p), field.n(), near) * polar(1, angle);
}

SpacePoint in_space(const SurfaceMesh& surface, SurfacePoint p, Complex direction) {
    return direction_in_space(surface, p.face, direction);
}

/// How far a walk of 0.8 at a constant angle to the east ends from where it ends on the sphere; the worst of some angles.
double loxodrome_error(int levels) {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(levels));
    const FieldOnSurface field(surface, field_of_directions(surface, 1, eastward));
    const double latitude = 0.1, longitude = 0.3, length = 0.8;
    const SpacePoint start{std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                           std::sin(latitude)};
    const SurfacePoint from = nearest_place(surface, start);
    double worst = 0;
    for (const double angle : {0.3, 0.7, 1.1, 2.0, -0.9}) {
        const Complex east = in_face(surface, from.face, eastward(start).direction);
        const SurfaceTrace walk = trace(surface, &field, from, at_angle(field, from, east, angle), length);
        CHECK(walk.length == Approx(length).epsilon(1e-12));
        const double end = latitude + length * std::sin(angle);
        const double far = longitude + (std::asinh(std::tan(end)) - std::asinh(std::tan(latitude))) / std::tan(angle);
        const SpacePoint exact{std::cos(end) * std::cos(far), std::cos(end) * std::sin(far), std::sin(end)};
        worst = std::max(worst, abs(unit(position_in_space(surface, walk.end)) - exact));
    }
    return worst;
}

}  // namespace

TEST_CASE("along a constant field of the plane a walk ends where its vector points") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(30, 30, 1, 0.3));
    for (const int n : {1, 2, 4}) {
        const FieldOnSurface field(surface, field_of_angles(surface, n, [](double, double) { return 0.4; }));
        const FieldOnSurface closed_form(surface, {.n = n, .exact = PlaneForm{.angle = 0.4}});
        for (const FieldOnSurface* each : {&field, &closed_form, static_cast<const FieldOnSurface*>(nullptr)})
            for (int i = 0; i < 20; ++i) {
                const double angle = 0.31 * i;
                const SurfacePoint from = nearest_place(surface, {15.2, 14.9, 0});
                const SpacePoint way{std::cos(angle), std::sin(angle), 0};
                const double length = 0.1 + 0.6 * i;
                const SurfaceTrace walk = trace(surface, each, from, in_face(surface, from.face, way), length);
                const SpacePoint end = position_in_space(surface, from) + length * way;
                CHECK(abs(position_in_space(surface, walk.end) - end) < 1e-12 * 30);
                CHECK(abs(in_space(surface, walk.end, walk.direction) - way) < 1e-12);
                CHECK(walk.length == Approx(length).epsilon(1e-14));
                CHECK(walk.jumps == 0);
                CHECK_FALSE(walk.at_border);
            }
    }
}

TEST_CASE("at an angle to a radial field a walk is a logarithmic spiral") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(70, 70, 1, 0.2));  // 9,800 faces
    const double centre = 35.3;
    const auto radial = [&](double x, double y) { return std::atan2(y - centre, x - centre); };
    const FieldOnSurface field(surface, field_of_angles(surface, 1, radial));
    const FieldOnSurface closed_form(surface,
                                     {.n = 1, .exact = PlaneForm{.about_centre = true, .centre = {centre, centre}}});
    for (const FieldOnSurface* each : {&field, &closed_form})
        for (const double angle : {0.5, 1.2, -1.0}) {
            const double r0 = 20, length = 12;
            const SurfacePoint from = nearest_place(surface, {centre + r0, centre, 0});
            const SpacePoint way{std::cos(angle), std::sin(angle), 0};
            const SurfaceTrace walk = trace(surface, each, from, in_face(surface, from.face, way), length);
            const double r = r0 + length * std::cos(angle), phi = std::tan(angle) * std::log(r / r0);
            CAPTURE(angle, each == &field);
            const SpacePoint exact{centre + r * std::cos(phi), centre + r * std::sin(phi), 0};
            CHECK(abs(position_in_space(surface, walk.end) - exact) < 1e-3 * length);
        }
}

TEST_CASE("a walk round a cylinder is a helix, with a field and without") {
    const int around = 40;
    const SurfaceMesh surface = surface_mesh(cylinder_triangles(around, 30, 1, 4));
    SurfaceField ring{.n = 2};
    for (int v = 0; v < surface.vertices(); ++v) {
        int h = surface.outgoing[static_cast<std::size_t>(v)];
        const auto height = [&](int w) { return surface.mesh.positions[static_cast<std::size_t>(w)].z; };
        // an edge of the ring; at a border it may be the one that ends the fan
        while (std::abs(height(end_of(surface, h)) - height(v)) > 1e-9 && next_about_start(surface, h) >= 0)
            h = next_about_start(surface, h);
        const bool level = std::abs(height(end_of(surface, h)) - height(v)) < 1e-9;
        const double angle = level ? surface.angle[static_cast<std::size_t>(h)]
                                   : surface.angle_back[static_cast<std::size_t>(previous_in_face(h))];
        ring.values.push_back(polar(1, 2 * angle));
    }
    const FieldOnSurface field(surface, ring);
    const double side = 2 * std::sin(pi / around), total = side * around;
    for (const FieldOnSurface* each : {&field, static_cast<const FieldOnSurface*>(nullptr)})
        for (const double angle : {0.05, 0.15, -0.2}) {
            const int face = 2 * (15 * around + 3);  // its first edge runs round the cylinder
            const SurfacePoint from = from_barycentric(surface, face, {0.3, 0.4, 0.3});
            const double length = 1.5 * total;
            const SurfaceTrace walk = trace(surface, each, from, polar(1, angle), length);
            const SpacePoint start = position_in_space(surface, from), end = position_in_space(surface, walk.end);
            CHECK(end.z - start.z == Approx(length * std::sin(angle)).margin(1e-12));
            // unrolled: the corner where the face begins, and the place beyond it
            const auto along = [&](SurfacePoint p) {
                const int column = p.face / 2 % around;
                const SpacePoint here = position_in_space(surface, p);
                const double turn = two_pi * column / around, middle = turn + pi / around;
                const double x =
                    -std::sin(middle) * (here.x - std::cos(turn)) + std::cos(middle) * (here.y - std::sin(turn));
                return column * side + x;
            };
            const double way = length * std::cos(angle) - (along(walk.end) - along(from));
            CHECK(way / total == Approx(std::round(way / total)).margin(1e-12));
            CHECK(walk.length == Approx(length).epsilon(1e-13));
        }
}

TEST_CASE("a loxodrome on the sphere ends in its place, with an error of second order") {
    const double coarse = loxodrome_error(4), fine = loxodrome_error(5);
    CHECK(fine < 3e-4);
    CHECK(coarse / fine > 3.5);
}

TEST_CASE("a straight walk on the sphere follows a great circle") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(5));
    Random random(11);
    double sum = 0;
    const int walks = 100;
    for (int i = 0; i < walks; ++i) {
        const SurfacePoint from = random_surface_point(surface, random);
        const Complex direction = polar(1, random.uniform(-pi, pi));
        const SpacePoint start = unit(position_in_space(surface, from)), way = in_space(surface, from, direction);
        const SpacePoint along = unit(way - dot(way, start) * start);
        const SurfaceTrace walk = trace(surface, nullptr, from, direction, 1);
        const SpacePoint exact = std::cos(1.0) * start + std::sin(1.0) * along;
        sum += std::pow(abs(unit(position_in_space(surface, walk.end)) - exact), 2);
    }
    CHECK(std::sqrt(sum / walks) < 2e-3);  // every vertex is a cone
}

TEST_CASE("a walk keeps its length and its angle to any field, and ends in its face") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(4));
    Random random(3);
    for (const int n : {1, 2, 4}) {
        // smooth but with many singular points
        const FieldOnSurface field(surface, field_of_directions(surface, n, [](SpacePoint p) {
                                       const SpacePoint away{std::sin(3 * p.y), std::cos(2 * p.z + p.x), std::sin(2 * p.x)};
                                       return DirectionAndNormal{unit(away - dot(away, p) * p), p};
                                   }));
        double sum = 0;
        long samples = 0;
        int steep = 0;
        for (int i = 0; i < 300; ++i) {
            const SurfacePoint from = random_surface_point(surface, random);
            const double angle = random.uniform(-pi, pi), length = random.uniform(0.01, 1.5);
            const Complex direction = at_angle(field, from, {1, 0}, angle);
            const SurfaceTrace walk = trace(surface, &field, from, direction, length, {.keep_path = true});
            CHECK(walk.length == Approx(length).epsilon(1e-12));
            CHECK(smallest_weight(surface, walk.end) >= -1e-12);
            CHECK(abs(walk.direction) == Approx(1).epsilon(1e-12));
            double way = 0;
            for (std::size_t k = 1; k < walk.path.size(); ++k) {
                way += abs(position_in_space(surface, walk.path[k]) - position_in_space(surface, walk.path[k - 1]));
                CHECK(smallest_weight(surface, walk.path[k]) >= -1e-12);
            }
            CHECK(way == Approx(length).epsilon(1e-9));
            if (walk.jumps > 0) continue;
            // a multiple of a whole symmetry
            const double kept =
                std::remainder(arg(walk.direction * conj(root_near(field.at(walk.end), n, {1, 0}))) - angle, two_pi / n);
            CHECK(std::abs(kept) < 1e-9);
            steep += walk.angle_error > radians(2);
            sum += walk.angle_error_sum, samples += walk.angle_samples;
        }
        CHECK(sum / static_cast<double>(samples) < radians(0.1));
        CHECK(steep < 20);  // of 300 walks, past singular points too
    }
}

TEST_CASE("a field line aimed at a wedge turns back without the jump and passes with it") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(40, 40, 1.0 / 40, 0.15));
    const double x0 = 0.513, y0 = 0.487;
    const FieldOnSurface field(
        surface, field_of_angles(surface, 2, [&](double x, double y) { return std::atan2(y - y0, x - x0) / 2; }));
    REQUIRE(field.singular_faces().size() == 1);
    const int face = field.singular_faces().front();
    const SpacePoint zero = position_in_space(surface, {face, field.zero(face)});
    int back = 0, passed = 0;
    for (int i = -40; i <= 40; ++i) {
        const SurfacePoint from = nearest_place(surface, {zero.x + 0.3, zero.y + 0.002 * i / 40, 0});
        const Complex way = in_face(surface, from.face, {-1, 0, 0});
        // onto the line of the field through the start
        const Complex direction = root_near(field.at(from), 2, way);
        const SurfaceTrace plain = trace(surface, &field, from, direction, 0.5, {.jump = 0});
        const SurfaceTrace jumped = trace(surface, &field, from, direction, 0.5);
        CHECK(plain.jumps == 0);
        back += position_in_space(surface, plain.end).x > zero.x;
        passed += position_in_space(surface, jumped.end).x < zero.x;
    }
    CHECK(back == 81);
    CHECK(passed == 81);
}

TEST_CASE("a walk passes a trisector with few jumps") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(40, 40, 1.0 / 40, 0.15));
    const FieldOnSurface field(
        surface, field_of_angles(surface, 2, [](double x, double y) { return -std::atan2(y - 0.487, x - 0.513) / 2; }));
    REQUIRE(field.singular_faces().size() == 1);
    const int face = field.singular_faces().front();
    const SpacePoint zero = position_in_space(surface, {face, field.zero(face)});
    int jumps = 0;
    for (int i = -40; i <= 40; ++i) {
        const SurfacePoint from = nearest_place(surface, {zero.x + 0.3, zero.y + 0.002 * i / 40 + 0.0001, 0});
        const Complex direction = root_near(field.at(from), 2, in_face(surface, from.face, {-1, 0, 0}));
        const SurfaceTrace walk = trace(surface, &field, from, direction, 0.5);
        jumps += walk.jumps;
        CHECK(abs(position_in_space(surface, walk.end) - zero) > 0.1);
    }
    CHECK(jumps < 20);
}

TEST_CASE("a walk stops at the border and says so") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(10, 10, 1));
    const FieldOnSurface field(surface, {.n = 2, .exact = PlaneForm{.angle = 0.3}});
    for (const FieldOnSurface* each : {&field, static_cast<const FieldOnSurface*>(nullptr)}) {
        const SurfacePoint from = nearest_place(surface, {5.1, 5.2, 0});
        const SurfaceTrace walk = trace(surface, each, from, in_face(surface, from.face, {1, 0, 0}), 20);
        CHECK(walk.at_border);
        CHECK(walk.length == Approx(4.9));
        CHECK(abs(position_in_space(surface, walk.end) - SpacePoint{10, 5.2, 0}) < 1e-11);
        // from the border inwards, and along it
        const SurfaceTrace in = trace(surface, each, walk.end, in_face(surface, walk.end.face, {-1, 0, 0}), 3);
        CHECK_FALSE(in.at_border);
        const SurfaceTrace along = trace(surface, each, walk.end, in_face(surface, walk.end.face, {0, 1, 0}), 3);
        CHECK(along.length == Approx(3));
    }
}

TEST_CASE("a walk may begin at a vertex in any direction of its frame") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(3));
    const FieldOnSurface field(surface, field_of_directions(surface, 2, eastward));
    for (const int v : {0, 5, 100, 333}) {
        const double first = arg(field.field().values[static_cast<std::size_t>(v)]) / 2;
        for (int i = 0; i < 24; ++i) {
            const Complex turn = polar(1, first + two_pi * i / 24);
            const SurfacePoint from = at_vertex(surface, v);
            const SurfaceTrace walk =
                trace(surface, &field, from, from_vertex_frame(surface, v, turn), surface.mean_edge / 100);
            CHECK(walk.length == Approx(surface.mean_edge / 100));
            const SpacePoint way =
                position_in_space(surface, walk.end) - surface.mesh.positions[static_cast<std::size_t>(v)];
            const SpacePoint normal = surface.vertex_normal[static_cast<std::size_t>(v)];
            const double went = angle_in_vertex_frame(surface, v, way, normal);
            if (walk.jumps == 0) CHECK(std::abs(wrap_angle(went - arg(turn))) < 0.01);
        }
    }
}

TEST_CASE("a walk gets past sharp corners, and round them with a field that runs into them") {
    TriangleMesh spikes;  // five of them, on a sphere; and as deep dents
    spikes = sphere_triangles(1);
    for (std::size_t i = 0; i < spikes.positions.size(); i += 4)
        spikes.positions[i] = (i % 8 == 0 ? 2.5 : 0.4) * spikes.positions[i];
    const SurfaceMesh surface = surface_mesh(spikes);
    Random random(12);
    for (const int n : {1, 2, 4})
        for (int fields = 0; fields < 4; ++fields) {
            SurfaceField values{.n = n};
            for (int v = 0; v < surface.vertices(); ++v) values.values.push_back(polar(1, random.uniform(-pi, pi)));
            const FieldOnSurface field(surface, values);
            for (int i = 0; i < 50; ++i) {
                const SurfacePoint from = random_surface_point(surface, random);
                const Complex direction = polar(1, random.uniform(-pi, pi));
                const SurfaceTrace walk = trace(surface, &field, from, direction, 4);
                CHECK(walk.length == Approx(4).epsilon(1e-12));
                CHECK(smallest_weight(surface, walk.end) >= -1e-12);
            }
        }
    for (int i = 0; i < 300; ++i) {
        const SurfaceTrace walk =
            trace(surface, nullptr, random_surface_point(surface, random), polar(1, random.uniform(-pi, pi)), 4);
        CHECK(walk.length == Approx(4).epsilon(1e-12));
    }
}

TEST_CASE("a walk that is aimed at a vertex goes on behind it") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(3));
    const FieldOnSurface field(surface, field_of_directions(surface, 2, eastward));
    for (const FieldOnSurface* each : {&field, static_cast<const FieldOnSurface*>(nullptr)})
        for (int h = 0; h < 3 * surface.faces(); h += 7) {
            const Complex edge = edge_vector(surface, h);
            const SurfacePoint middle{
                face_of(h), surface.flat[static_cast<std::size_t>(face_of(h))][static_cast<std::size_t>(h % 3)] + edge / 2};
            const SurfaceTrace walk = trace(surface, each, middle, edge / abs(edge), 3 * abs(edge));
            CHECK(walk.length == Approx(3 * abs(edge)).epsilon(1e-9));
            if (!each) CHECK(abs(position_in_space(surface, walk.end) - position_in_space(surface, middle)) > 2 * abs(edge));
        }
}

TEST_CASE("work is bounded, however long a walk is wished") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(8, 6, 2, 0.7));
    const FieldOnSurface field(surface, field_of_directions(surface, 1, eastward));
    const SurfaceTrace walk =
        trace(surface, &field, from_barycentric(surface, 3, {0.3, 0.3, 0.4}), {0.6, 0.8}, 1e300, {.keep_path = true});
    CHECK(walk.length < 1e300);
    CHECK(walk.length > 1000);
    CHECK(walk.path.size() < 1'000'000);
}

TEST_CASE("a walk that follows the field in part lies between straight and along the field") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(60, 60, 1.0 / 60, 0.2));
    const auto ring = [](double x, double y) { return std::atan2(y + 0.2, x + 0.2) + pi / 2; };
    const FieldOnSurface field(surface, field_of_angles(surface, 1, ring));
    const SurfacePoint from = nearest_place(surface, {0.6, 0.1, 0});
    const Complex direction = at_angle(field, from, {1, 0}, 0);
    const double whole = std::remainder(0.5 / std::hypot(0.8, 0.3), two_pi);  // the turn of the circle after 0.5
    for (const double follow : {0.25, 0.5, 0.75}) {
        const SurfaceTrace walk = trace(surface, &field, from, direction, 0.5, {.follow = follow});
        const SpacePoint before = in_space(surface, from, direction), after = in_space(surface, walk.end, walk.direction);
        const double turned = std::atan2(before.x * after.y - before.y * after.x, dot(before, after));
        CHECK(turned == Approx(follow * whole).epsilon(0.15));
        CHECK(walk.length == Approx(0.5).epsilon(1e-12));
    }
}

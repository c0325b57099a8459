#include "growth/surface/polar_map.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <limits>

#include "surface_shapes.h"

using namespace rinceau;

namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

struct MapErrors {
    double distance_rms = 0, distance_max = 0, position_rms = 0;
    std::size_t count = 0;
};

/// Against the flat place (distance and direction from the source) that `exact` gives for a vertex.
MapErrors errors_of(const SurfaceMesh& surface, const PolarMap& map, const std::function<Complex(SpacePoint)>& exact) {
    MapErrors errors;
    errors.count = map.vertices.size();
    for (std::size_t i = 0; i < errors.count; ++i) {
        const Complex place = exact(surface.mesh.positions[static_cast<std::size_t>(map.vertices[i])]);
        const double off = map.distance[i] - abs(place);
        errors.distance_rms += off * off;
        errors.distance_max = std::max(errors.distance_max, std::abs(off));
        errors.position_rms += norm(polar(map.distance[i], map.angle[i]) - place);
    }
    errors.distance_rms = std::sqrt(errors.distance_rms / static_cast<double>(errors.count));
    errors.position_rms = std::sqrt(errors.position_rms / static_cast<double>(errors.count));
    return errors;
}

/// The place in the frame of the face of `source` of a point of the plane z = 0.
Complex in_plane(const SurfaceMesh& surface, SurfacePoint source, SpacePoint p) {
    const SpacePoint way = p - position_in_space(surface, source);
    const auto& frame = surface.frame[static_cast<std::size_t>(source.face)];
    return {dot(way, frame[0]), dot(way, frame[1])};
}

/// On the sphere of radius 1: as far along the great circle to p as p is.
Complex on_sphere(const SurfaceMesh& surface, SurfacePoint source, SpacePoint p) {
    const SpacePoint centre = unit(position_in_space(surface, source));
    const SpacePoint way = p - dot(p, centre) * centre;
    const auto& frame = surface.frame[static_cast<std::size_t>(source.face)];
    const Complex direction{dot(way, frame[0]), dot(way, frame[1])};
    return std::atan2(abs(way), dot(p, centre)) / abs(direction) * direction;
}

int nearest_vertex(const SurfaceMesh& surface, SpacePoint p) {
    int best = 0;
    for (int v = 0; v < surface.vertices(); ++v)
        if (abs(surface.mesh.positions[static_cast<std::size_t>(v)] - p) <
            abs(surface.mesh.positions[static_cast<std::size_t>(best)] - p))
            best = v;
    return best;
}

double distance_to(const PolarMap& map, int vertex) {
    const auto place = std::ranges::find(map.vertices, vertex);
    REQUIRE(place != map.vertices.end());
    return map.distance[static_cast<std::size_t>(place - map.vertices.begin())];
}

}  // namespace

TEST_CASE("a polar map of the plane is exact on an even grid, from inside a face, from an edge and from a vertex") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(24, 20, 0.5));
    const SurfacePoint in_face = from_barycentric(surface, 417, {0.5, 0.2, 0.3});
    const SurfacePoint on_edge = from_barycentric(surface, 417, {0.4, 0.6, 0});
    const SurfacePoint on_corner = from_barycentric(surface, 417, {0, 1, 0});
    for (const SurfacePoint source : {in_face, on_edge, on_corner}) {
        const PolarMap map = polar_map(surface, source, everywhere);
        REQUIRE(map.vertices.size() == static_cast<std::size_t>(surface.vertices()));
        const MapErrors errors = errors_of(surface, map, [&](SpacePoint p) { return in_plane(surface, source, p); });
        // a root of a difference keeps half of the digits
        CHECK(errors.distance_max < 1e-9);
        CHECK(errors.position_rms < 1e-8);
    }
}

TEST_CASE("a polar map of an uneven plane is exact too: corners of 177 degrees cost nothing") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(70, 70, 1, 0.3));
    const SurfacePoint source = from_barycentric(surface, 4970, {0.3, 0.3, 0.4});
    const MapErrors errors =
        errors_of(surface, polar_map(surface, source, 35), [&](SpacePoint p) { return in_plane(surface, source, p); });
    CHECK(errors.distance_max < 1e-8);
    CHECK(errors.position_rms < 1e-6);
}

TEST_CASE("a polar map of a cylinder is the plane rolled up") {
    const int around = 100;
    const SurfaceMesh surface = surface_mesh(cylinder_triangles(around, 100, 1, two_pi));
    const SurfacePoint source = from_barycentric(surface, 10 * around * 10 + 30, {0.2, 0.3, 0.5});
    const SpacePoint here = position_in_space(surface, source);
    // the x axis of the face runs along the first edge: to the side, in both triangles of a square
    const double side = abs(edge_vector(surface, 3 * source.face)) / (two_pi / around);
    const MapErrors errors = errors_of(surface, polar_map(surface, source, 2), [&](SpacePoint p) {
        const double turn = std::atan2(here.x * p.y - here.y * p.x, here.x * p.x + here.y * p.y);
        const Complex place{turn * side, p.z - here.z};
        const int k = source.face % 2;  // the second triangle of a square begins with its diagonal
        const Complex axis = k == 0 ? Complex{1, 0} : conj(Complex{side * two_pi / around, two_pi / 100});
        return place * axis / abs(axis);
    });
    CHECK(errors.count > 900);
    CHECK(errors.distance_rms < 2 * 1e-4);
    CHECK(errors.position_rms < 2 * 2e-4);
}

TEST_CASE("a polar map of the sphere gives great circles, from a face and from a vertex") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(5));
    const double radius = 2;
    SECTION("from a face") {
        const SurfacePoint source = from_barycentric(surface, 1234, {0.3, 0.45, 0.25});
        const MapErrors errors = errors_of(surface, polar_map(surface, source, radius),
                                           [&](SpacePoint p) { return on_sphere(surface, source, p); });
        CHECK(errors.distance_rms / radius < 1.5e-3);
        CHECK(errors.position_rms / radius < 5e-3);
    }
    SECTION("from a vertex") {
        const int v = 777;
        const PolarMap map = polar_map_of_vertex(surface, v, radius);
        const SpacePoint centre = surface.mesh.positions[777];
        double worst = 0, sum = 0;
        for (std::size_t i = 0; i < map.vertices.size(); ++i) {
            const double off =
                map.distance[i] -
                std::acos(
                    std::clamp(dot(centre, surface.mesh.positions[static_cast<std::size_t>(map.vertices[i])]), -1.0, 1.0));
            worst = std::max(worst, std::abs(off));
            sum += off * off;
        }
        CHECK(std::sqrt(sum / static_cast<double>(map.vertices.size())) / radius < 1.5e-3);
        CHECK(worst / radius < 6e-3);
    }
}

TEST_CASE("a vertex's map counts angles as its frame does") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(40, 20, 2, 0.7));
    const PolarMap map = polar_map_of_vertex(surface, 5, 0.5);
    int h = surface.outgoing[5];
    do {
        const auto place = std::ranges::find(map.vertices, end_of(surface, h)) - map.vertices.begin();
        CHECK(std::abs(wrap_angle(map.angle[static_cast<std::size_t>(place)] - surface.angle[static_cast<std::size_t>(h)])) <
              1e-12);
        h = next_about_start(surface, h);
    } while (h != surface.outgoing[5]);
}

TEST_CASE("distances on a torus: along a meridian, along the outer equator, and as on a finer one") {
    const double large = 2, small = 0.7;
    const int around = 80, along = 40;
    const SurfaceMesh surface = surface_mesh(torus_triangles(around, along, large, small));
    const PolarMap map = polar_map_of_vertex(surface, 0, everywhere);
    // meridians are geodesics; so is the outer equator, and it is the shortest way for pi sqrt(r (R + r))
    for (const double turn : {0.5, 1.0, 2.0, 3.0}) {
        const double v = two_pi * std::round(turn / two_pi * along) / along;
        const int there = nearest_vertex(surface, {large + small * std::cos(v), 0, small * std::sin(v)});
        CHECK(distance_to(map, there) == Approx(small * v).epsilon(5e-3));
    }
    for (const double way : {0.5, 1.0, 2.0, 4.0}) {
        const double u = two_pi * std::round(way / (large + small) / two_pi * around) / around;
        const int there = nearest_vertex(surface, {(large + small) * std::cos(u), (large + small) * std::sin(u), 0});
        CHECK(distance_to(map, there) == Approx((large + small) * u).epsilon(5e-3));
    }
    const SurfaceMesh finer = surface_mesh(torus_triangles(4 * around, 4 * along, large, small));
    const PolarMap reference = polar_map_of_vertex(finer, 0, everywhere);
    double sum = 0;
    std::vector<double> exact(static_cast<std::size_t>(finer.vertices()));
    for (std::size_t i = 0; i < reference.vertices.size(); ++i)
        exact[static_cast<std::size_t>(reference.vertices[i])] = reference.distance[i];
    for (std::size_t i = 0; i < map.vertices.size(); ++i) {
        const int row = map.vertices[i] / around, column = map.vertices[i] % around;
        const double off = map.distance[i] - exact[static_cast<std::size_t>(16 * row * around + 4 * column)];
        sum += off * off;
    }
    CHECK(std::sqrt(sum / static_cast<double>(map.vertices.size())) < 1e-2);
}

TEST_CASE("it is as far from a to b as from b to a") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(60, 30, 2, 0.7));
    for (const auto& [a, b] : {std::array{0, 931}, std::array{17, 1200}, std::array{400, 1555}, std::array{3, 66}}) {
        const double there = distance_to(polar_map_of_vertex(surface, a, everywhere), b);
        const double back = distance_to(polar_map_of_vertex(surface, b, everywhere), a);
        CHECK(there == Approx(back).epsilon(0.01));
    }
}

TEST_CASE("a mapper used again gives what a fresh one gives, and reaches no farther than asked") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(4));
    PolarMapper mapper(surface);
    Random random(5);
    for (int i = 0; i < 30; ++i) {
        const SurfacePoint source = random_surface_point(surface, random);
        const double radius = random.uniform(0.01, 1);
        mapper.map(source, radius);
        const PolarMap fresh = polar_map(surface, source, radius);
        const PolarMap all = polar_map(surface, source, everywhere);
        REQUIRE(mapper.reached().size() >= fresh.vertices.size());
        for (std::size_t k = 0; k < fresh.vertices.size(); ++k) {
            CHECK(mapper.reached()[k] == fresh.vertices[k]);
            CHECK(mapper.distance(fresh.vertices[k]) == fresh.distance[k]);
            CHECK(fresh.distance[k] <= radius);
            CHECK(fresh.distance[k] == Approx(all.distance[k]).epsilon(2e-3));
        }
        // corners of faces partly within, and no others
        for (const int v : mapper.reached()) CHECK(mapper.distance(v) < radius + 2 * surface.longest_edge);
    }
}

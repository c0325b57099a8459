#include "growth/surface/surface_mesh.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/index.h"

namespace rinceau {
namespace {

SpacePoint corner(const SurfaceMesh& surface, int h) { return surface.mesh.positions[at(start_of(surface, h))]; }

/// Half-edges of one undirected edge stand side by side when sorted.
std::vector<int> twins(const SurfaceMesh& surface) {
    struct Key {
        int low, high, h;
    };
    std::vector<Key> keys;
    const int count = 3 * surface.faces();
    keys.reserve(at(count));
    for (int h = 0; h < count; ++h) {
        const int a = start_of(surface, h), b = end_of(surface, h);
        keys.push_back({std::min(a, b), std::max(a, b), h});
    }
    std::ranges::sort(keys, [](const Key& a, const Key& b) {
        return std::array{a.low, a.high, a.h} < std::array{b.low, b.high, b.h};
    });
    std::vector<int> twin(at(count), -1);
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        if (keys[i].low != keys[i + 1].low || keys[i].high != keys[i + 1].high) continue;
        twin[at(keys[i].h)] = keys[i + 1].h;
        twin[at(keys[i + 1].h)] = keys[i].h;
    }
    return twin;
}

void lay_faces_flat(SurfaceMesh& surface) {
    for (int f = 0; f < surface.faces(); ++f) {
        const SpacePoint a = corner(surface, 3 * f), b = corner(surface, 3 * f + 1), c = corner(surface, 3 * f + 2);
        const SpacePoint x = unit(b - a), normal = unit(cross(b - a, c - a)), y = cross(normal, x);
        surface.frame.push_back({x, y, normal});
        surface.flat.push_back({Complex{0, 0}, Complex{abs(b - a), 0}, Complex{dot(c - a, x), dot(c - a, y)}});
    }
}

/// Walks about every vertex, counter-clockwise from its border if it has one.
void lay_vertex_frames(SurfaceMesh& surface) {
    const int count = 3 * surface.faces();
    surface.outgoing.assign(surface.mesh.positions.size(), -1);
    for (int h = 0; h < count; ++h) {
        int& out = surface.outgoing[at(start_of(surface, h))];
        if (out < 0 || surface.twin[at(h)] < 0) out = h;
    }
    surface.angle.assign(at(count), 0);
    surface.angle_back.assign(at(count), 0);
    surface.angle_scale.assign(surface.outgoing.size(), 1);
    for (std::size_t v = 0; v < surface.outgoing.size(); ++v) {
        const int first = surface.outgoing[v];
        double sum = 0;
        int h = first;
        do {
            sum += corner_angle(surface, h);
            h = next_about_start(surface, h);
        } while (h >= 0 && h != first);
        const double scale = h < 0 ? 1 : two_pi / sum;
        surface.angle_scale[v] = scale;
        double angle = 0;
        h = first;
        do {
            surface.angle[at(h)] = angle;
            if (const int twin = surface.twin[at(h)]; twin >= 0) surface.angle_back[at(twin)] = angle;
            angle += scale * corner_angle(surface, h);
            const int before = previous_in_face(h);
            h = surface.twin[at(before)];
            if (h < 0) surface.angle_back[at(before)] = angle;
        } while (h >= 0 && h != first);
    }
}

void join_frames(SurfaceMesh& surface) {
    surface.across.assign(surface.twin.size(), Complex{1, 0});
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        const int twin = surface.twin[at(h)];
        if (twin < 0) continue;
        const Complex here = edge_vector(surface, h), there = edge_vector(surface, twin);
        surface.across[at(h)] = -(there / abs(there)) * conj(here / abs(here));
    }
}

void measure(SurfaceMesh& surface) {
    const auto [low, high] = bounds(surface.mesh);
    surface.diagonal = abs(high - low);
    double sum = 0;
    int edges = 0;
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        const int twin = surface.twin[at(h)];
        if (twin < 0) ++surface.border_edges;
        if (twin > h) continue;  // each edge once
        const double length = abs(edge_vector(surface, h));
        sum += length;
        ++edges;
        surface.longest_edge = std::max(surface.longest_edge, length);
    }
    surface.mean_edge = sum / edges;
    for (const auto& flat : surface.flat) surface.area += cross(flat[1], flat[2]) / 2;
    surface.vertex_normal.assign(surface.mesh.positions.size(), SpacePoint{});
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        SpacePoint& normal = surface.vertex_normal[at(start_of(surface, h))];
        normal = normal + corner_angle(surface, h) * surface.frame[at(face_of(h))][2];
    }
    for (SpacePoint& normal : surface.vertex_normal) normal = unit(normal);
}

}  // namespace

int start_of(const SurfaceMesh& surface, int h) { return surface.mesh.triangles[at(h / 3)][at(h % 3)]; }

int end_of(const SurfaceMesh& surface, int h) { return start_of(surface, next_in_face(h)); }

Complex edge_vector(const SurfaceMesh& surface, int h) {
    const auto& flat = surface.flat[at(face_of(h))];
    return flat[at(next_in_face(h) % 3)] - flat[at(h % 3)];
}

int next_about_start(const SurfaceMesh& surface, int h) { return surface.twin[at(previous_in_face(h))]; }

double corner_angle(const SurfaceMesh& surface, int h) {
    const Complex along = edge_vector(surface, h), back = -edge_vector(surface, previous_in_face(h));
    return std::atan2(cross(along, back), dot(along, back));
}

Complex transport_along(const SurfaceMesh& surface, int h) {
    return polar(1, surface.angle_back[at(h)] + pi - surface.angle[at(h)]);
}

int euler_characteristic(const SurfaceMesh& surface) {
    const int half_edges = 3 * surface.faces();
    const int edges = (half_edges + surface.border_edges) / 2;
    return surface.vertices() - edges + surface.faces();
}

SurfaceMesh surface_mesh(TriangleMesh mesh) {
    SurfaceMesh surface;
    surface.mesh = std::move(mesh);
    surface.twin = twins(surface);
    lay_faces_flat(surface);
    lay_vertex_frames(surface);
    join_frames(surface);
    measure(surface);
    return surface;
}

}  // namespace rinceau

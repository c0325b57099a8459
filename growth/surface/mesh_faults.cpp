#include "growth/surface/mesh_faults.h"

#include <algorithm>
#include <charconv>

#include "geometry/index.h"
#include "growth/joined_sets.h"

namespace rinceau {
namespace {

SpacePoint middle_of(const TriangleMesh& mesh, const std::vector<int>& vertices) {
    SpacePoint sum;
    for (const int v : vertices) sum = sum + mesh.positions[at(v)];
    return (1.0 / static_cast<double>(vertices.size())) * sum;
}

class FaultFinder {
  public:
    FaultFinder(const TriangleMesh& mesh, std::size_t most) : mesh_(mesh), most_(most) {}

    MeshFaults find() {
        if (mesh_.triangles.empty()) {
            ++found_.count[0];
            found_.list.push_back({});
            return std::move(found_);
        }
        left_out_.assign(mesh_.triangles.size(), 0);
        find_unused();
        find_bad_faces();
        find_repeated_faces();
        find_edges();
        find_parted_fans();
        std::ranges::stable_sort(found_.list, {}, &MeshFault::kind);
        return std::move(found_);
    }

  private:
    const TriangleMesh& mesh_;
    std::size_t most_;
    MeshFaults found_;
    std::vector<char> left_out_;  ///< by face: of no use for edges and vertices

    void add(MeshFaultKind kind, std::vector<int> vertices, std::vector<int> faces) {
        if (found_.count[static_cast<std::size_t>(kind)]++ >= most_) return;
        std::ranges::sort(faces);
        const SpacePoint place = middle_of(mesh_, vertices);
        found_.list.push_back({kind, std::move(vertices), std::move(faces), place});
    }
    std::vector<int> corners(int face) const {
        const auto& triangle = mesh_.triangles[at(face)];
        return {triangle.begin(), triangle.end()};
    }

    void find_unused() {
        std::vector<char> used(mesh_.positions.size(), 0);
        for (const auto& triangle : mesh_.triangles)
            for (const int v : triangle) used[at(v)] = 1;
        for (std::size_t v = 0; v < used.size(); ++v)
            if (used[v] == 0) add(MeshFaultKind::unused_vertex, {static_cast<int>(v)}, {});
    }

    void find_bad_faces() {
        for (int f = 0; f < static_cast<int>(mesh_.triangles.size()); ++f) {
            const auto& [a, b, c] = mesh_.triangles[at(f)];
            if (a == b || b == c || c == a) {
                add(MeshFaultKind::repeated_corner, corners(f), {f});
            } else if (has_no_area(mesh_, mesh_.triangles[at(f)])) {
                add(MeshFaultKind::no_area, corners(f), {f});
            } else {
                continue;
            }
            left_out_[at(f)] = 1;
        }
    }

    void find_repeated_faces() {
        std::vector<std::pair<std::array<int, 3>, int>> turned;  // the lowest corner first
        for (int f = 0; f < static_cast<int>(mesh_.triangles.size()); ++f) {
            if (left_out_[at(f)] != 0) continue;
            std::array<int, 3> face = mesh_.triangles[at(f)];
            std::rotate(face.begin(), std::ranges::min_element(face), face.end());
            turned.push_back({face, f});
        }
        std::ranges::sort(turned);
        for (std::size_t i = 1; i < turned.size(); ++i) {
            if (turned[i].first != turned[i - 1].first) continue;
            left_out_[at(turned[i].second)] = 1;
            add(MeshFaultKind::repeated_face, corners(turned[i].second), {turned[i - 1].second, turned[i].second});
        }
    }

    void find_edges() {
        const std::vector<FaceSide> sides = sides_by_edge(mesh_, left_out_);
        for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
            const FaceSide& edge = sides[first];
            while (end < sides.size() && sides[end].low == edge.low && sides[end].high == edge.high) ++end;
            const auto begins_low = [&](std::size_t i) {
                return mesh_.triangles[at(sides[i].side / 3)][at(sides[i].side % 3)] == edge.low;
            };
            const std::size_t count = end - first;
            const bool opposed = count == 2 && begins_low(first) == begins_low(first + 1);
            if (count <= 2 && !opposed) continue;
            std::vector<int> faces;
            for (std::size_t i = first; i < end; ++i) faces.push_back(sides[i].side / 3);
            add(opposed ? MeshFaultKind::opposed_faces : MeshFaultKind::crowded_edge, {edge.low, edge.high},
                std::move(faces));
        }
    }

    /// Corners are joined over the edges that they lie at; a vertex whose corners are not all one set has a parted fan.
    void find_parted_fans() {
        JoinedSets joined(3 * mesh_.triangles.size());
        const std::vector<FaceSide> sides = sides_by_edge(mesh_, left_out_);
        for (std::size_t i = 1; i < sides.size(); ++i)
            if (sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high)
                for (const int v : {sides[i].low, sides[i].high})
                    joined.join(corner_at(mesh_, sides[i].side / 3, v), corner_at(mesh_, sides[i - 1].side / 3, v));
        std::vector<std::pair<int, int>> sets;  // vertex, set
        for (int c = 0; c < static_cast<int>(3 * mesh_.triangles.size()); ++c)
            if (left_out_[at(c / 3)] == 0) sets.push_back({mesh_.triangles[at(c / 3)][at(c % 3)], joined.root(c)});
        std::ranges::sort(sets);
        sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
        for (std::size_t first = 0, end = 0; first < sets.size(); first = end) {
            while (end < sets.size() && sets[end].first == sets[first].first) ++end;
            if (end - first < 2) continue;
            std::vector<int> faces;  // one of each part
            for (std::size_t i = first; i < end; ++i) faces.push_back(sets[i].second / 3);
            add(MeshFaultKind::parted_fan, {sets[first].first}, std::move(faces));
        }
    }
};

std::string number_text(double value) {
    constexpr int digits = 6;
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
    return {text.data(), end};
}

std::string joined_text(const std::vector<int>& numbers, const std::string& between) {
    constexpr std::size_t most = 6;  // more say no more
    std::string text;
    for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
        text += (i == 0 ? "" : between) + std::to_string(numbers[i]);
    return numbers.size() > most ? text + between + "..." : text;
}

struct FaultWords {
    std::string one, many;
};

FaultWords words_of(MeshFaultKind kind) {
    switch (kind) {
        case MeshFaultKind::no_face:
            return {"mesh without a face", "meshes without a face"};
        case MeshFaultKind::unused_vertex:
            return {"vertex in no face", "vertices in no face"};
        case MeshFaultKind::repeated_corner:
            return {"face with one vertex twice", "faces with one vertex twice"};
        case MeshFaultKind::no_area:
            return {"face without area", "faces without area"};
        case MeshFaultKind::repeated_face:
            return {"face that is there twice", "faces that are there twice"};
        case MeshFaultKind::crowded_edge:
            return {"edge of three or more faces", "edges of three or more faces"};
        case MeshFaultKind::opposed_faces:
            return {"edge between faces that turn against each other", "edges between faces that turn against each other"};
        default:
            return {"vertex at which parts of the surface only touch", "vertices at which parts of the surface only touch"};
    }
}

}  // namespace

bool has_no_area(const TriangleMesh& mesh, const std::array<int, 3>& face) {
    constexpr double thinnest = 1e-9;  // below, angles of the face are noise
    const SpacePoint a = mesh.positions[at(face[0])], b = mesh.positions[at(face[1])], c = mesh.positions[at(face[2])];
    const double longest = std::max({abs(b - a), abs(c - b), abs(a - c)});
    return abs(cross(b - a, c - a)) <= thinnest * longest * longest;
}

int corner_at(const TriangleMesh& mesh, int face, int vertex) {
    const auto& triangle = mesh.triangles[at(face)];
    return 3 * face + static_cast<int>(std::ranges::find(triangle, vertex) - triangle.begin());
}

std::vector<FaceSide> sides_by_edge(const TriangleMesh& mesh, const std::vector<char>& left_out) {
    std::vector<FaceSide> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        if (!left_out.empty() && left_out[f] != 0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = mesh.triangles[f][k], b = mesh.triangles[f][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(3 * f + k)});
        }
    }
    std::ranges::sort(sides);
    return sides;
}

MeshFaults mesh_faults(const TriangleMesh& mesh, std::size_t most) { return FaultFinder(mesh, most).find(); }

std::string fault_count_text(MeshFaultKind kind, std::size_t count) {
    const FaultWords words = words_of(kind);
    return std::to_string(count) + " " + (count == 1 ? words.one : words.many);
}

std::string fault_place_text(const MeshFault& fault) {
    if (fault.vertices.empty()) return "nowhere";
    std::string text;
    if (fault.vertices.size() == 3) {
        text = "face " + std::to_string(fault.faces.back()) + " (vertices " + joined_text(fault.vertices, ", ") + ")";
    } else {
        text = (fault.vertices.size() == 2 ? "edge " : "vertex ") + joined_text(fault.vertices, "-");
        if (!fault.faces.empty()) text += " of faces " + joined_text(fault.faces, ", ");
    }
    return text + " at (" + number_text(fault.place.x) + ", " + number_text(fault.place.y) + ", " +
           number_text(fault.place.z) + ")";
}

}  // namespace rinceau

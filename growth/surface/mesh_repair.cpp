// Cutting: corners of faces are joined over every edge that is not cut; each set of joined corners is a vertex. Two faces
// that meet at a cut edge and are joined about both of its ends share it again: the rest of the fan has gone to other
// copies.

#include "growth/surface/mesh_repair.h"

#include <algorithm>
#include <array>
#include <map>

#include "geometry/index.h"
#include "growth/joined_sets.h"
#include "growth/surface/mesh_faults.h"

namespace rinceau {
namespace {

bool repeats_a_corner(const std::array<int, 3>& face) {
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

double length_of_side(const TriangleMesh& mesh, const std::array<int, 3>& face, std::size_t k) {
    return abs(mesh.positions[at(face[(k + 1) % 3])] - mesh.positions[at(face[k])]);
}

/// Gives the corners of faces without area to their neighbours: the longest edge of such a face is turned.
class ThinFaces {
  public:
    explicit ThinFaces(TriangleMesh& mesh) : mesh_(mesh) {
        for (int f = 0; f < static_cast<int>(mesh_.triangles.size()); ++f)
            if (has_no_area(mesh_, mesh_.triangles[at(f)])) thin_.push_back(f);
        if (thin_.empty()) return;
        for (const FaceSide& side : sides_by_edge(mesh_, {})) faces_[{side.low, side.high}].push_back(side.side / 3);
    }

    std::size_t count() const { return thin_.size(); }

    /// A turned edge may make a neighbour thin, or a thin one's neighbour whole: rounds, until nothing changes.
    void turn_edges() {
        bool changed = !thin_.empty();
        for (std::size_t round = 0; changed && round < thin_.size(); ++round) {
            changed = false;
            for (const int f : thin_)
                if (has_no_area(mesh_, mesh_.triangles[at(f)])) changed = turn_longest_edge(f) || changed;
        }
    }

  private:
    using Edge = std::pair<int, int>;
    TriangleMesh& mesh_;
    std::vector<int> thin_;
    std::map<Edge, std::vector<int>> faces_;

    static Edge edge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

    bool turn_longest_edge(int f) {
        std::array<int, 3> face = mesh_.triangles[at(f)];
        std::size_t longest = 0;
        for (const std::size_t k : {std::size_t{1}, std::size_t{2}})
            if (length_of_side(mesh_, face, k) > length_of_side(mesh_, face, longest)) longest = k;
        std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(longest), face.end());
        const auto [a, c, b] = face;
        const auto found = faces_.find(edge(a, c));
        if (found == faces_.end() || found->second.size() != 2) return false;
        const int g = found->second[0] == f ? found->second[1] : found->second[0];
        std::array<int, 3> other = mesh_.triangles[at(g)];
        std::rotate(other.begin(), std::ranges::find(other, c), other.end());
        const int d = other[2];
        if (other[1] != a || d == b || faces_.contains(edge(b, d))) return false;
        const std::array<int, 3> first{b, a, d}, second{d, c, b};
        if (has_no_area(mesh_, first) || has_no_area(mesh_, second)) return false;
        faces_.erase(found);
        faces_[edge(b, d)] = {f, g};
        std::ranges::replace(faces_[edge(c, b)], f, g);
        std::ranges::replace(faces_[edge(a, d)], g, f);
        mesh_.triangles[at(f)] = first;
        mesh_.triangles[at(g)] = second;
        return true;
    }
};

/// Two faces that follow each other over an edge.
struct FacePair {
    int f = 0, g = 0;
    int low = 0, high = 0;
    bool agree = true;  ///< they turn alike
};

struct EdgePairs {
    std::vector<FacePair> pairs;
    std::size_t crowded = 0;  ///< edges of three or more faces
};

EdgePairs pairs_of(const TriangleMesh& mesh) {
    EdgePairs result;
    const std::vector<FaceSide> sides = sides_by_edge(mesh, {});
    const auto begins_low = [&](const FaceSide& s) { return mesh.triangles[at(s.side / 3)][at(s.side % 3)] == s.low; };
    for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
        while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high) ++end;
        if (end - first > 2) ++result.crowded;
        if (end - first != 2) continue;
        const FaceSide &a = sides[first], &b = sides[first + 1];
        result.pairs.push_back({a.side / 3, b.side / 3, a.low, a.high, begins_low(a) != begins_low(b)});
    }
    return result;
}

/// By face: is it to be turned?
class Turning {
  public:
    Turning(const TriangleMesh& mesh, const std::vector<FacePair>& pairs) : mesh_(mesh), pairs_(pairs) {
        about_.resize(mesh.triangles.size());
        for (int p = 0; p < static_cast<int>(pairs.size()); ++p) {
            about_[at(pairs[at(p)].f)].push_back(p);
            about_[at(pairs[at(p)].g)].push_back(p);
        }
        turned_.assign(mesh.triangles.size(), unknown);
    }

    std::vector<char> find() {
        for (int f = 0; f < static_cast<int>(turned_.size()); ++f)
            if (turned_[at(f)] == unknown) spread_from(f);
        return std::move(turned_);
    }

  private:
    static constexpr char unknown = 2;
    const TriangleMesh& mesh_;
    const std::vector<FacePair>& pairs_;
    std::vector<std::vector<int>> about_;  ///< by face: pairs
    std::vector<char> turned_;

    double doubled_area(int f) const {
        const auto& [a, b, c] = mesh_.triangles[at(f)];
        return abs(cross(mesh_.positions[at(b)] - mesh_.positions[at(a)], mesh_.positions[at(c)] - mesh_.positions[at(a)]));
    }
    void spread_from(int first) {
        std::vector<int> part{first};
        std::array<double, 2> area{};
        turned_[at(first)] = 0;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const int f = part[i];
            area[static_cast<std::size_t>(turned_[at(f)] != 0)] += doubled_area(f);
            for (const int p : about_[at(f)]) {
                const FacePair& pair = pairs_[at(p)];
                const int g = pair.f == f ? pair.g : pair.f;
                if (turned_[at(g)] != unknown) continue;
                turned_[at(g)] = static_cast<char>(pair.agree ? turned_[at(f)] : 1 - turned_[at(f)]);
                part.push_back(g);
            }
        }
        if (area[1] <= area[0]) return;
        for (const int f : part) turned_[at(f)] = static_cast<char>(1 - turned_[at(f)]);
    }
};

TriangleMesh without_repeated_faces(const TriangleMesh& mesh) {
    const MeshFaults faults = mesh_faults(mesh, mesh.triangles.size());
    TriangleMesh result{mesh.positions, {}};
    std::vector<char> drop(mesh.triangles.size(), 0);
    for (const MeshFault& fault : faults.list)
        if (fault.kind == MeshFaultKind::repeated_face) drop[at(fault.faces.back())] = 1;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        if (drop[f] == 0) result.triangles.push_back(mesh.triangles[f]);
    return result;
}

/// Every set of joined corners becomes a vertex; the first set of each vertex keeps its number.
void part_vertices(TriangleMesh& mesh, JoinedSets& joined) {
    constexpr int none = -1;
    const int corners = static_cast<int>(3 * mesh.triangles.size());
    std::vector<int> owner(mesh.positions.size(), none);  // by vertex: the set that keeps it
    std::vector<int> number(at(corners), none);           // by set: its vertex
    for (int c = 0; c < corners; ++c) {
        const int set = joined.root(c);
        int& vertex = mesh.triangles[at(c / 3)][at(c % 3)];
        if (number[at(set)] == none) {
            number[at(set)] = vertex;
            if (owner[at(vertex)] != none) {
                number[at(set)] = static_cast<int>(mesh.positions.size());
                mesh.positions.push_back(mesh.positions[at(vertex)]);
            } else {
                owner[at(vertex)] = set;
            }
        }
        vertex = number[at(set)];
    }
}

}  // namespace

TidyMesh tidy_mesh(const TriangleMesh& mesh) {
    TidyMesh tidy;
    TriangleMesh work{mesh.positions, {}};
    std::vector<int> face_number;
    for (int f = 0; f < static_cast<int>(mesh.triangles.size()); ++f) {
        if (repeats_a_corner(mesh.triangles[at(f)])) continue;
        work.triangles.push_back(mesh.triangles[at(f)]);
        face_number.push_back(f);
    }
    tidy.repeated_corners = mesh.triangles.size() - work.triangles.size();
    ThinFaces thin(work);
    tidy.without_area = thin.count();
    thin.turn_edges();

    std::vector<int> place(mesh.positions.size(), -1);
    for (std::size_t f = 0; f < work.triangles.size(); ++f) {
        if (has_no_area(work, work.triangles[f])) {
            ++tidy.slits;
            continue;
        }
        for (const int v : work.triangles[f]) place[at(v)] = 0;
        tidy.mesh.triangles.push_back(work.triangles[f]);
        tidy.face_number.push_back(face_number[f]);
    }
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (place[v] < 0) continue;
        place[v] = static_cast<int>(tidy.mesh.positions.size());
        tidy.mesh.positions.push_back(mesh.positions[v]);
        tidy.vertex_number.push_back(static_cast<int>(v));
    }
    tidy.unused_vertices = mesh.positions.size() - tidy.mesh.positions.size();
    for (auto& triangle : tidy.mesh.triangles)
        for (int& v : triangle) v = place[at(v)];
    return tidy;
}

MeshRepair repaired_mesh(const TriangleMesh& mesh) {
    MeshRepair repair;
    repair.mesh = without_repeated_faces(mesh);
    repair.repeated_faces = mesh.triangles.size() - repair.mesh.triangles.size();
    const EdgePairs edges = pairs_of(repair.mesh);
    repair.cut_edges = edges.crowded;
    const std::vector<char> turned = Turning(repair.mesh, edges.pairs).find();
    JoinedSets joined(3 * repair.mesh.triangles.size());
    for (const FacePair& pair : edges.pairs) {
        if ((turned[at(pair.f)] == turned[at(pair.g)]) != pair.agree) {
            ++repair.cut_edges;  // of a one-sided part
            continue;
        }
        for (const int v : {pair.low, pair.high})
            joined.join(corner_at(repair.mesh, pair.f, v), corner_at(repair.mesh, pair.g, v));
    }
    part_vertices(repair.mesh, joined);
    repair.copied_vertices = repair.mesh.positions.size() - mesh.positions.size();
    for (std::size_t f = 0; f < turned.size(); ++f)
        if (turned[f] != 0) std::swap(repair.mesh.triangles[f][1], repair.mesh.triangles[f][2]);
    repair.turned_faces = static_cast<std::size_t>(std::ranges::count(turned, char{1}));
    return repair;
}

}  // namespace rinceau

#include "growth/arrangement/arrangement_mesh.h"

#include <algorithm>

#include "growth/arrangement/node_links.h"

namespace rinceau {

namespace {

// Of the exemplar's longest edge: what is farther apart stands at both sides of a notch in what was painted.
constexpr double longest_edge = 1.5;
constexpr double covered = 0.5;  // of the least distance

bool is_torn(const GrowthGround& ground, const std::vector<Point>& points, const std::vector<int>& face) {
    const bool bounded = ground.around.boundary != nullptr && !ground.around.boundary->is_empty();
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Point a = points[static_cast<std::size_t>(face[i])];
        const Point b = points[static_cast<std::size_t>(face[i + 1 < face.size() ? i + 1 : 0])];
        if (abs(b - a) > longest_edge * ground.exemplar.longest_edge || (bounded && is_barred(ground, a, b))) return true;
    }
    return false;
}

}  // namespace

ArrangementMesh mesh_of(const ElementArrangement& arrangement, const GrowthGround& ground) {
    ArrangementMesh mesh;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i) {
        if (arrangement.nodes[i].dead) continue;
        mesh.nodes.push_back(static_cast<int>(i));
        mesh.points.push_back(arrangement.nodes[i].position);
    }
    mesh.connectivity = connectivity_of(mesh.points);
    const auto torn = [&](const std::vector<int>& face) { return is_torn(ground, mesh.points, face); };
    std::vector<std::vector<int>> faces = mesh.connectivity.faces;
    if (std::erase_if(faces, torn) > 0) mesh.connectivity = connectivity_from_faces(mesh.points, std::move(faces));
    return mesh;
}

void move_points(ArrangementMesh& mesh, const ElementArrangement& arrangement) {
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        mesh.points[i] = arrangement.nodes[static_cast<std::size_t>(mesh.nodes[i])].position;
}

void drop_covered_seeds(ElementArrangement& arrangement, const GrowthGround& ground) {
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i) {
        if (!is_seed(arrangement.nodes[i])) continue;
        const ArrangementNode& seed = arrangement.nodes[i];
        bool is_covered = false;
        arrangement.grid.visit(
            seed.position, covered * std::max(ground.reach, ground.exemplar.shortest_edge), [&](int node, Point at) {
                const ArrangementNode& other = arrangement.nodes[static_cast<std::size_t>(node)];
                // Of two seeds the one that was born later goes.
                if (is_seed(other) && node >= static_cast<int>(i)) return;
                is_covered |= abs(at - seed.position) < covered * least_distance(ground, seed.symbol, other.symbol);
            });
        if (is_covered) remove_node(arrangement, static_cast<int>(i));
    }
}

}  // namespace rinceau

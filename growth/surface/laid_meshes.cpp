// Corners of a face have the normals that a smoothly shaded surface has there (creases stay sharp), so that what is laid
// looks painted on. Each piece has corners of its own on its face; pieces of one face share them.

#include "growth/surface/laid_meshes.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "geometry/angle.h"
#include "geometry/index.h"

namespace rinceau {
namespace {

constexpr double crease = 40 * pi / 180;  // as in pictures and files of meshes

class MeshWriter {
  public:
    MeshWriter(const SurfaceMesh& surface, const LaidMeshOptions& options)
        : surface_(&surface), options_(&options), normals_(corner_normals(surface.mesh, crease)) {}

    void add(NamedMesh& mesh, const LaidLayer& layer, double lift) const {
        const double top = lift + options_->height;
        for (const LaidPiece& piece : layer.area.pieces) {
            const int first = static_cast<int>(mesh.mesh.positions.size());
            for (int k = 0; k < piece.count; ++k) {
                const SurfacePoint p{piece.face, layer.area.corners[at(piece.first + k)]};
                mesh.mesh.positions.push_back(position_in_space(*surface_, p) + top * normal_at(*surface_, p));
                mesh.normals.push_back(shown_normal(p));
            }
            for (int k = 1; k + 1 < piece.count; ++k) mesh.mesh.triangles.push_back({first, first + k, first + k + 1});
        }
        if (options_->height > 0)
            for (const LaidPiece& piece : layer.rim.pieces) add_wall(mesh, layer.rim, piece, lift, top);
    }

  private:
    const SurfaceMesh* surface_;
    const LaidMeshOptions* options_;
    std::vector<std::array<SpacePoint, 3>> normals_;

    SpacePoint shown_normal(SurfacePoint p) const {
        const auto weights = barycentric(*surface_, p);
        SpacePoint sum;
        for (std::size_t k = 0; k < 3; ++k) sum = sum + weights[k] * normals_[at(p.face)][k];
        return unit(sum);
    }

    void add_wall(NamedMesh& mesh, const LaidPieces& rim, const LaidPiece& piece, double low, double high) const {
        const SurfacePoint a{piece.face, rim.corners[at(piece.first)]}, b{piece.face, rim.corners[at(piece.first + 1)]};
        const SpacePoint p = position_in_space(*surface_, a), q = position_in_space(*surface_, b);
        const SpacePoint up_a = normal_at(*surface_, a), up_b = normal_at(*surface_, b);
        const SpacePoint out = unit(cross(q - p, up_a));
        const int first = static_cast<int>(mesh.mesh.positions.size());
        for (const SpacePoint& corner : {p + low * up_a, q + low * up_b, q + high * up_b, p + high * up_a}) {
            mesh.mesh.positions.push_back(corner);
            mesh.normals.push_back(out);
        }
        mesh.mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.mesh.triangles.push_back({first, first + 2, first + 3});
    }
};

}  // namespace

std::vector<int> paint_ranks(const std::vector<int>& order, const std::vector<std::vector<int>>& covers) {
    std::vector<int> ranks(order.size(), -1);  // -1: not painted yet
    for (const int shape : order) {
        int rank = 0;
        for (const int other : covers[at(shape)])
            if (ranks[at(other)] >= 0) rank = std::max(rank, ranks[at(other)] + 1);
        ranks[at(shape)] = rank;
    }
    return ranks;
}

std::vector<NamedMesh> laid_meshes(const SurfaceMesh& surface, const std::vector<LaidShape>& shapes,
                                   const std::vector<int>& ranks, const std::vector<int>& layers,
                                   const LaidMeshOptions& options) {
    const int highest = ranks.empty() ? 0 : *std::ranges::max_element(ranks);
    const double step = std::min(options.rank_lift, options.most_lift / std::max(highest, 1));
    std::map<std::tuple<int, int, int, int>, std::size_t> known;  // layer and colour -> mesh
    std::vector<std::pair<int, NamedMesh>> meshes;
    const MeshWriter writer(surface, options);
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (const LaidLayer& layer : shapes[i].layers) {
            const Color c = layer.color;
            const auto [found, is_new] = known.try_emplace({layers[i], c.red, c.green, c.blue}, meshes.size());
            if (is_new) meshes.push_back({layers[i], NamedMesh{"laid_" + std::to_string(meshes.size() + 1), {}, c, {}}});
            const double lift = options.lift + step * (ranks[i] + 0.5 * layer.level);
            writer.add(meshes[found->second].second, layer, lift * surface.diagonal);
        }
    std::ranges::stable_sort(meshes, {}, [](const auto& mesh) { return mesh.first; });
    std::vector<NamedMesh> result;
    for (auto& [layer, mesh] : meshes) result.push_back(std::move(mesh));
    return result;
}

}  // namespace rinceau

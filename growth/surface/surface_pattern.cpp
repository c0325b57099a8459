#include "growth/surface/surface_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "growth/surface/line_tube.h"

namespace rinceau {
namespace {

/// The turn that takes x, y, z to the axes, as a quaternion: from its largest component, so that nothing cancels out.
std::array<double, 4> rotation_to(const std::array<SpacePoint, 3>& axes) {
    const auto& [x, y, z] = axes;
    const std::array<double, 4> squares{1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z, 1 + x.x + y.y + z.z};
    const auto largest = static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
    std::array<double, 4> q{};
    switch (largest) {
        case 0:
            q = {squares[0], x.y + y.x, z.x + x.z, y.z - z.y};
            break;
        case 1:
            q = {x.y + y.x, squares[1], y.z + z.y, z.x - x.z};
            break;
        case 2:
            q = {z.x + x.z, y.z + z.y, squares[2], x.y - y.x};
            break;
        default:
            q = {y.z - z.y, z.x - x.z, x.y - y.x, squares[3]};
    }
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& component : q) component /= length;
    return q;
}

std::string hex_text(Color color) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const unsigned channel : {color.red, color.green, color.blue}) {
        text += digits[channel / 16];
        text += digits[channel % 16];
    }
    return text;
}

constexpr std::array<std::uint8_t, 3> key_of(Color color) { return {color.red, color.green, color.blue}; }

class AssemblyMaker {
  public:
    explicit AssemblyMaker(const SurfacePattern& pattern) : pattern_(pattern) {}

    void add_ground(const SurfaceMesh& surface, Color color) { add_whole({"surface", surface.mesh, color, {}}); }

    void add_shapes() {
        for (const PatternShape& placed : pattern_.placed) {
            const MeshPose pose{.translation = placed.position, .rotation = rotation_to(placed.axes), .scale = placed.size};
            assembly_.instances.push_back({mesh_of(placed.shape, placed.color), pose});
        }
        name_shapes();
    }

    /// One mesh for each colour, in order of their first lines.
    void add_lines(int sides) {
        std::map<std::array<std::uint8_t, 3>, std::size_t> place;
        std::vector<NamedMesh> tubes;
        for (const PatternLine& line : pattern_.lines) {
            const NamedMesh tube = line_tube(line, sides);
            if (tube.mesh.triangles.empty()) continue;
            const auto [found, is_new] = place.try_emplace(key_of(line.color), tubes.size());
            if (is_new) tubes.push_back({.color = line.color});
            append(tubes[found->second], tube);
        }
        for (NamedMesh& tube : tubes) {
            tube.name = tubes.size() > 1 ? "line_" + hex_text(tube.color) : "line";
            add_whole(std::move(tube));
        }
    }

    void add_laid() {
        for (const NamedMesh& mesh : pattern_.laid)
            if (!mesh.mesh.triangles.empty()) add_whole(mesh);
    }

    MeshAssembly take() { return std::move(assembly_); }

  private:
    const SurfacePattern& pattern_;
    MeshAssembly assembly_;
    std::map<std::pair<int, std::array<std::uint8_t, 3>>, int> known_;  ///< by shape and colour

    void add_whole(NamedMesh mesh) {
        assembly_.instances.push_back({static_cast<int>(assembly_.meshes.size()), {}});
        assembly_.meshes.push_back(std::move(mesh));
    }
    int mesh_of(int shape, Color color) {
        const auto [found, is_new] = known_.try_emplace({shape, key_of(color)}, static_cast<int>(assembly_.meshes.size()));
        if (is_new) assembly_.meshes.push_back({{}, pattern_.shapes[static_cast<std::size_t>(shape)].mesh, color, {}});
        return found->second;
    }
    /// A shape of several colours: each with its colour in the name.
    void name_shapes() {
        std::vector<int> colors(pattern_.shapes.size(), 0);
        for (const auto& [key, mesh] : known_) ++colors[static_cast<std::size_t>(key.first)];
        for (const auto& [key, mesh] : known_) {
            NamedMesh& named = assembly_.meshes[static_cast<std::size_t>(mesh)];
            named.name = pattern_.shapes[static_cast<std::size_t>(key.first)].name;
            if (colors[static_cast<std::size_t>(key.first)] > 1) named.name += "_" + hex_text(named.color);
        }
    }
};

}  // namespace

MeshAssembly assembly_of(const SurfacePattern& pattern, const SurfaceMesh& surface, const AssemblyOptions& options) {
    AssemblyMaker maker(pattern);
    if (options.with_surface) maker.add_ground(surface, options.surface_color);
    maker.add_shapes();
    maker.add_lines(options.line_sides);
    maker.add_laid();
    return maker.take();
}

long faces_out(const MeshAssembly& assembly) {
    long sum = 0;
    for (const MeshInstance& instance : assembly.instances)
        sum += static_cast<long>(assembly.meshes[static_cast<std::size_t>(instance.mesh)].mesh.triangles.size());
    return sum;
}

}  // namespace rinceau

#include "growth/mesh/mesh_ply_write.h"

#include <bit>
#include <cstdint>
#include <limits>

#include "scene/input_error.h"

namespace rinceau {
namespace {

/// The lowest byte first, whatever the machine's order.
template <class Bits>
void append_bits(std::string& text, Bits bits) {
    for (std::size_t i = 0; i < sizeof(Bits); ++i) text += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
}

struct PlyCounts {
    std::size_t vertices = 0, faces = 0;
};

PlyCounts counts_of(const MeshAssembly& assembly) {
    PlyCounts counts;
    for (const MeshInstance& instance : assembly.instances) {
        const TriangleMesh& mesh = assembly.meshes[static_cast<std::size_t>(instance.mesh)].mesh;
        counts.vertices += mesh.positions.size();
        counts.faces += mesh.triangles.size();
    }
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (counts.vertices > most || counts.faces > most)
        throw LimitError({}, "the .ply would have more than 2^31 vertices or faces; write .glb, which has instances");
    return counts;
}

std::string header_text(const PlyCounts& counts) {
    return "ply\nformat binary_little_endian 1.0\ncomment rinceau\nelement vertex " + std::to_string(counts.vertices) +
           "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
           "property uchar blue\nelement face " +
           std::to_string(counts.faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

void add_vertices(const NamedMesh& named, const MeshPose& pose, TextPieces& pieces) {
    for (const SpacePoint p : named.mesh.positions) {
        const SpacePoint q = apply(pose, p);
        for (const double coordinate : {q.x, q.y, q.z}) append_bits(pieces.text(), std::bit_cast<std::uint64_t>(coordinate));
        for (const std::uint8_t channel : {named.color.red, named.color.green, named.color.blue})
            append_bits(pieces.text(), channel);
        pieces.pass_on_if_large();
    }
}

void add_faces(const NamedMesh& named, bool mirrored, std::size_t first, TextPieces& pieces) {
    for (const auto& [a, b, c] : named.mesh.triangles) {
        pieces.text() += '\3';
        for (const int v : mirrored ? std::array{a, c, b} : std::array{a, b, c})
            append_bits(pieces.text(), static_cast<std::uint32_t>(first + static_cast<std::size_t>(v)));
        pieces.pass_on_if_large();
    }
}

}  // namespace

void write_ply(const MeshAssembly& assembly, const TextSink& sink) {
    TextPieces pieces(sink);
    pieces.text() += header_text(counts_of(assembly));
    const auto mesh_of = [&](const MeshInstance& instance) -> const NamedMesh& {
        return assembly.meshes[static_cast<std::size_t>(instance.mesh)];
    };
    for (const MeshInstance& instance : assembly.instances) add_vertices(mesh_of(instance), instance.pose, pieces);
    std::size_t first = 0;
    for (const MeshInstance& instance : assembly.instances) {
        add_faces(mesh_of(instance), is_mirrored(instance.pose), first, pieces);
        first += mesh_of(instance).mesh.positions.size();
    }
    pieces.pass_on();
}

}  // namespace rinceau

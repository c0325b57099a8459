#include "growth/mesh/mesh_obj_write.h"

#include <array>
#include <charconv>

namespace rinceau {
namespace {

template <class Number>
void append(std::string& text, Number value) {
    constexpr std::size_t longest = 32;  // of a double in shortest form: 24
    std::array<char, longest> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text += ' ';
    text.append(digits.data(), end);
}

}  // namespace

void write_obj(const MeshAssembly& assembly, const TextSink& sink) {
    TextPieces pieces(sink);
    std::vector<int> copies(assembly.meshes.size(), 0);
    std::size_t first = 1;  // as OBJ counts
    for (const MeshInstance& instance : assembly.instances) {
        const auto which = static_cast<std::size_t>(instance.mesh);
        const NamedMesh& named = assembly.meshes[which];
        pieces.text() += "g " + named.name + "_" + std::to_string(++copies[which]) + "\n";
        for (const SpacePoint p : named.mesh.positions) {
            const SpacePoint q = apply(instance.pose, p);
            pieces.text() += 'v';
            for (const double coordinate : {q.x, q.y, q.z}) append(pieces.text(), coordinate);
            pieces.text() += '\n';
            pieces.pass_on_if_large();
        }
        for (const auto& triangle : named.mesh.triangles) {
            pieces.text() += 'f';
            for (const int v : triangle) append(pieces.text(), first + static_cast<std::size_t>(v));
            pieces.text() += '\n';
            pieces.pass_on_if_large();
        }
        first += named.mesh.positions.size();
    }
    pieces.pass_on();
}

}  // namespace rinceau

#include "growth/mesh/mesh_obj_write.h"

#include <array>
#include <charconv>

#include "geometry/angle.h"

namespace rinceau {
namespace {

constexpr double crease = 40 * pi / 180;
constexpr std::size_t longest_number = 32;  // of a double in shortest form: 24

template <class Number>
void append(std::string& text, Number value) {
    std::array<char, longest_number> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text += ' ';
    text.append(digits.data(), end);
}

void append_short(std::string& text, double value) {
    constexpr int places = 4;  // a normal to a hundredth of a degree
    std::array<char, longest_number> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, places).ptr;
    text += ' ';
    text.append(digits.data(), end);
}

/// A mesh's normals, each once for each vertex that has it.
struct NormalList {
    std::vector<SpacePoint> normals;
    std::vector<std::array<std::size_t, 3>> corners;  ///< by triangle: indices of normals
};

NormalList normals_of(const NamedMesh& named) {
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    NormalList list;
    std::vector<std::size_t> latest(named.mesh.positions.size(), none), before;
    for (const auto& normals : corner_normals(named, crease)) {
        const auto& triangle = named.mesh.triangles[list.corners.size()];
        std::array<std::size_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            std::size_t& newest = latest[static_cast<std::size_t>(triangle[k])];
            std::size_t i = newest;
            while (i != none && list.normals[i] != normals[k]) i = before[i];
            if (i == none) {
                i = list.normals.size();
                list.normals.push_back(normals[k]);
                before.push_back(newest);
                newest = i;
            }
            corners[k] = i;
        }
        list.corners.push_back(corners);
    }
    return list;
}

class ObjWriter {
  public:
    ObjWriter(const MeshAssembly& assembly, const TextSink& sink, const ObjOptions& options)
        : assembly_(assembly), options_(options), pieces_(sink), copies_(assembly.meshes.size(), 0) {
        if (!options.normals) return;
        for (const NamedMesh& named : assembly.meshes) normals_.push_back(normals_of(named));
    }

    void write() {
        for (const MeshInstance& instance : assembly_.instances) {
            const auto which = static_cast<std::size_t>(instance.mesh);
            const NamedMesh& named = assembly_.meshes[which];
            pieces_.text() += "g " + named.name + "_" + std::to_string(++copies_[which]) + "\n";
            add_positions(named, instance.pose);
            if (options_.normals) add_normals(normals_[which], instance.pose);
            add_faces(which, is_mirrored(instance.pose));
            first_ += named.mesh.positions.size();
            if (options_.normals) first_normal_ += normals_[which].normals.size();
        }
        pieces_.pass_on();
    }

  private:
    const MeshAssembly& assembly_;
    const ObjOptions& options_;
    TextPieces pieces_;
    std::vector<int> copies_;
    std::vector<NormalList> normals_;           ///< by mesh
    std::size_t first_ = 1, first_normal_ = 1;  // as OBJ counts

    void add_positions(const NamedMesh& named, const MeshPose& pose) {
        constexpr double brightest = 255;
        for (const SpacePoint p : named.mesh.positions) {
            const SpacePoint q = apply(pose, p);
            pieces_.text() += 'v';
            for (const double coordinate : {q.x, q.y, q.z}) append(pieces_.text(), coordinate);
            if (options_.colors)
                for (const int channel : {named.color.red, named.color.green, named.color.blue})
                    append_short(pieces_.text(), channel / brightest);
            pieces_.text() += '\n';
            pieces_.pass_on_if_large();
        }
    }
    void add_normals(const NormalList& list, const MeshPose& pose) {
        for (const SpacePoint n : list.normals) {
            const SpacePoint q = apply_to_normal(pose, n);
            pieces_.text() += "vn";
            for (const double coordinate : {q.x, q.y, q.z}) append_short(pieces_.text(), coordinate);
            pieces_.text() += '\n';
            pieces_.pass_on_if_large();
        }
    }
    void add_faces(std::size_t which, bool mirrored) {
        const TriangleMesh& mesh = assembly_.meshes[which].mesh;
        const std::array<std::size_t, 3> order =
            mirrored ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2};
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            pieces_.text() += 'f';
            for (const std::size_t k : order) {
                append(pieces_.text(), first_ + static_cast<std::size_t>(mesh.triangles[t][k]));
                if (!options_.normals) continue;
                pieces_.text() += "//" + std::to_string(first_normal_ + normals_[which].corners[t][k]);
            }
            pieces_.text() += '\n';
            pieces_.pass_on_if_large();
        }
    }
};

}  // namespace

void write_obj(const MeshAssembly& assembly, const TextSink& sink, const ObjOptions& options) {
    ObjWriter(assembly, sink, options).write();
}

}  // namespace rinceau

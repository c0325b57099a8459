// The glTF 2.0 specification, through TinyGLTF. All numbers of a mesh lie in one buffer: positions, normals, indices.

#include "growth/mesh/mesh_glb_write.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>

#include "geometry/angle.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr double crease = 40 * pi / 180;

/// A vertex of glTF: a position with a normal.
using Vertex = std::array<float, 6>;

struct VertexList {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// Corners that share position and normal share a vertex.
VertexList vertices_of(const TriangleMesh& mesh) {
    const std::vector<std::array<SpacePoint, 3>> normals = corner_normals(mesh, crease);
    VertexList list;
    std::map<std::pair<int, std::array<float, 3>>, std::uint32_t> known;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = mesh.triangles[t][k];
            const SpacePoint p = mesh.positions[static_cast<std::size_t>(v)], n = normals[t][k];
            if (abs(n) == 0) break;  // without area: nothing to be seen, and no normal
            const std::array<float, 3> normal{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
            const auto [place, is_new] = known.try_emplace({v, normal}, static_cast<std::uint32_t>(list.vertices.size()));
            if (is_new)
                list.vertices.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                                         normal[0], normal[1], normal[2]});
            list.indices.push_back(place->second);
        }
    return list;
}

/// A model that grows by meshes and nodes.
class Glb {
  public:
    explicit Glb(UpAxis up) {
        model_.asset.version = "2.0";
        model_.asset.generator = "rinceau";
        model_.buffers.emplace_back();
        model_.scenes.emplace_back();
        model_.defaultScene = 0;
        if (up == UpAxis::z) add_turned_root();
    }

    int add_mesh(const NamedMesh& named) {
        const VertexList list = vertices_of(named.mesh);
        tinygltf::Primitive primitive;
        primitive.attributes["POSITION"] = add_vectors(list, 0);
        primitive.attributes["NORMAL"] = add_vectors(list, 3);
        primitive.indices = add_indices(list.indices);
        primitive.material = add_material(named.color);
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        tinygltf::Mesh mesh;
        mesh.name = named.name;
        mesh.primitives.push_back(primitive);
        model_.meshes.push_back(mesh);
        return static_cast<int>(model_.meshes.size()) - 1;
    }

    void add_node(int mesh, const MeshPose& pose) {
        tinygltf::Node node;
        node.mesh = mesh;
        const auto list = [](SpacePoint p) { return std::vector<double>{p.x, p.y, p.z}; };
        node.translation = list(pose.translation);
        node.rotation.assign(pose.rotation.begin(), pose.rotation.end());
        if (pose.scale != SpacePoint{1, 1, 1}) node.scale = list(pose.scale);
        const int index = static_cast<int>(model_.nodes.size());
        (root_ < 0 ? model_.scenes[0].nodes : model_.nodes[static_cast<std::size_t>(root_)].children).push_back(index);
        model_.nodes.push_back(node);
    }

    std::string bytes() {
        std::ostringstream stream;
        tinygltf::TinyGLTF writer;
        if (!writer.WriteGltfSceneToStream(&model_, stream, false, true)) throw LimitError({}, "the .glb could not be made");
        return std::move(stream).str();
    }

  private:
    tinygltf::Model model_;
    int root_ = -1;  ///< the node above all, -1 = none

    void add_turned_root() {
        tinygltf::Node node;
        const auto rotation = rotation_about({1, 0, 0}, -pi / 2);
        node.name = "z up";
        node.rotation.assign(rotation.begin(), rotation.end());
        model_.nodes.push_back(node);
        model_.scenes[0].nodes.push_back(0);
        root_ = 0;
    }

    template <class Number>
    int add_view(const std::vector<Number>& numbers, int target) {
        auto& buffer = model_.buffers[0].data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = buffer.size();
        view.byteLength = sizeof(Number) * numbers.size();
        view.target = target;
        buffer.resize(buffer.size() + view.byteLength);
        std::memcpy(buffer.data() + view.byteOffset, numbers.data(), view.byteLength);
        model_.bufferViews.push_back(view);
        return static_cast<int>(model_.bufferViews.size()) - 1;
    }

    int add_accessor(tinygltf::Accessor accessor) {
        model_.accessors.push_back(std::move(accessor));
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    /// Positions (from 0) or normals (from 3) of the vertices.
    int add_vectors(const VertexList& list, std::size_t from) {
        std::vector<float> numbers;
        numbers.reserve(3 * list.vertices.size());
        tinygltf::Accessor accessor;
        accessor.minValues.assign(3, HUGE_VAL);
        accessor.maxValues.assign(3, -HUGE_VAL);
        for (const Vertex& vertex : list.vertices)
            for (std::size_t k = 0; k < 3; ++k) {
                const float value = vertex[from + k];
                numbers.push_back(value);
                accessor.minValues[k] = std::min<double>(accessor.minValues[k], value);
                accessor.maxValues[k] = std::max<double>(accessor.maxValues[k], value);
            }
        accessor.bufferView = add_view(numbers, TINYGLTF_TARGET_ARRAY_BUFFER);
        accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
        accessor.type = TINYGLTF_TYPE_VEC3;
        accessor.count = list.vertices.size();
        return add_accessor(accessor);
    }

    int add_indices(const std::vector<std::uint32_t>& indices) {
        tinygltf::Accessor accessor;
        accessor.bufferView = add_view(indices, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        accessor.type = TINYGLTF_TYPE_SCALAR;
        accessor.count = indices.size();
        return add_accessor(accessor);
    }

    int add_material(const Color& color) {
        // glTF's colours are linear, a picture's are sRGB (IEC 61966-2-1).
        const auto linear = [](std::uint8_t byte) {
            const double v = byte / 255.0;
            return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        };
        tinygltf::Material material;
        material.pbrMetallicRoughness.baseColorFactor = {linear(color.red), linear(color.green), linear(color.blue), 1};
        material.pbrMetallicRoughness.metallicFactor = 0;
        material.pbrMetallicRoughness.roughnessFactor = 0.6;  // neither a mirror nor chalk
        model_.materials.push_back(material);
        return static_cast<int>(model_.materials.size()) - 1;
    }
};

}  // namespace

std::string glb_bytes(const MeshAssembly& assembly, UpAxis up) {
    Glb glb(up);
    std::vector<int> place(assembly.meshes.size(), -1);
    for (const MeshInstance& instance : assembly.instances) {
        int& mesh = place[static_cast<std::size_t>(instance.mesh)];
        if (mesh < 0) mesh = glb.add_mesh(assembly.meshes[static_cast<std::size_t>(instance.mesh)]);
        glb.add_node(mesh, instance.pose);
    }
    return glb.bytes();
}

}  // namespace rinceau

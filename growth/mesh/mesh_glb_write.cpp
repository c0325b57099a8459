// The glTF 2.0 specification, through TinyGLTF. All numbers of a mesh lie in one buffer: positions, normals, indices; then,
// with the extension EXT_mesh_gpu_instancing, what its instances are moved, turned and scaled by.

#include "growth/mesh/mesh_glb_write.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
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
class VertexMaker {
  public:
    explicit VertexMaker(const NamedMesh& named) : named_(named), latest_(named.mesh.positions.size(), none) {}

    VertexList make() {
        const std::vector<std::array<SpacePoint, 3>> normals = corner_normals(named_, crease);
        for (std::size_t t = 0; t < named_.mesh.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const SpacePoint n = normals[t][k];
                if (abs(n) == 0) break;  // without area: nothing to be seen, and no normal
                list_.indices.push_back(vertex(static_cast<std::size_t>(named_.mesh.triangles[t][k]), n));
            }
        return std::move(list_);
    }

  private:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    const NamedMesh& named_;
    VertexList list_;
    std::vector<std::uint32_t> latest_;  ///< by position: the vertex made last
    std::vector<std::uint32_t> before_;  ///< by vertex: the one at its position that was made before it

    std::uint32_t vertex(std::size_t v, SpacePoint n) {
        const SpacePoint p = named_.mesh.positions[v];
        const Vertex wanted{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                            static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
        for (std::uint32_t i = latest_[v]; i != none; i = before_[i])
            if (list_.vertices[i] == wanted) return i;
        const auto made = static_cast<std::uint32_t>(list_.vertices.size());
        list_.vertices.push_back(wanted);
        before_.push_back(latest_[v]);
        return latest_[v] = made;
    }
};

/// A model that grows by meshes and nodes.
class Glb {
  public:
    explicit Glb(const GlbOptions& options) : two_sided_(options.two_sided) {
        model_.asset.version = "2.0";
        model_.asset.generator = "rinceau";
        model_.buffers.emplace_back();
        model_.scenes.emplace_back();
        model_.defaultScene = 0;
        if (options.up == UpAxis::z) add_turned_root();
    }

    int add_mesh(const NamedMesh& named) {
        const VertexList list = VertexMaker(named).make();
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
        add(std::move(node));
    }

    /// One node for all poses (EXT_mesh_gpu_instancing).
    void add_instances(int mesh, const std::vector<MeshPose>& poses) {
        std::vector<float> moves, turns, scales;
        const auto append = [](std::vector<float>& list, SpacePoint p) {
            for (const double value : {p.x, p.y, p.z}) list.push_back(static_cast<float>(value));
        };
        for (const MeshPose& pose : poses) {
            append(moves, pose.translation);
            for (const double value : pose.rotation) turns.push_back(static_cast<float>(value));
            append(scales, pose.scale);
        }
        tinygltf::Value::Object attributes;
        attributes["TRANSLATION"] = tinygltf::Value(add_numbers(moves, TINYGLTF_TYPE_VEC3, poses.size()));
        attributes["ROTATION"] = tinygltf::Value(add_numbers(turns, TINYGLTF_TYPE_VEC4, poses.size()));
        attributes["SCALE"] = tinygltf::Value(add_numbers(scales, TINYGLTF_TYPE_VEC3, poses.size()));
        tinygltf::Value::Object extension;
        extension["attributes"] = tinygltf::Value(std::move(attributes));
        tinygltf::Node node;
        node.mesh = mesh;
        node.extensions[gpu_instancing] = tinygltf::Value(std::move(extension));
        if (model_.extensionsUsed.empty()) {
            model_.extensionsUsed.emplace_back(gpu_instancing);
            model_.extensionsRequired.emplace_back(gpu_instancing);  // without it only one of many would be seen
        }
        add(std::move(node));
    }

    std::string bytes() {
        std::ostringstream stream;
        stream.exceptions(std::ios::badbit);  // a lack of memory passes, instead of the end of the file
        tinygltf::TinyGLTF writer;
        if (!writer.WriteGltfSceneToStream(&model_, stream, false, true)) throw LimitError({}, "the .glb could not be made");
        return std::move(stream).str();
    }

  private:
    static constexpr const char* gpu_instancing = "EXT_mesh_gpu_instancing";
    tinygltf::Model model_;
    bool two_sided_ = false;
    int root_ = -1;  ///< the node above all, -1 = none

    void add(tinygltf::Node node) {
        const int index = static_cast<int>(model_.nodes.size());
        (root_ < 0 ? model_.scenes[0].nodes : model_.nodes[static_cast<std::size_t>(root_)].children).push_back(index);
        model_.nodes.push_back(std::move(node));
    }

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
        constexpr std::size_t most_bytes = std::size_t{1} << 31U;  // the file counts them in 32 bits
        if (view.byteLength > most_bytes - buffer.size())
            throw LimitError({}, "the .glb would have more than 2 GB; write instances, or fewer shapes");
        buffer.resize(buffer.size() + view.byteLength);
        std::memcpy(buffer.data() + view.byteOffset, numbers.data(), view.byteLength);
        model_.bufferViews.push_back(view);
        return static_cast<int>(model_.bufferViews.size()) - 1;
    }

    int add_numbers(const std::vector<float>& numbers, int type, std::size_t count) {
        constexpr int no_target = 0;  // numbers of no mesh
        tinygltf::Accessor accessor;
        accessor.bufferView = add_view(numbers, no_target);
        accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
        accessor.type = type;
        accessor.count = count;
        return add_accessor(accessor);
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
        material.doubleSided = two_sided_;
        model_.materials.push_back(material);
        return static_cast<int>(model_.materials.size()) - 1;
    }
};

/// By mesh, in order of their first instances: the poses of those that are no mirror images, and of those that are.
struct MeshPoses {
    int mesh = 0;
    std::vector<MeshPose> straight, mirrored;
};

std::vector<MeshPoses> poses_by_mesh(const MeshAssembly& assembly) {
    std::vector<MeshPoses> list;
    std::vector<int> place(assembly.meshes.size(), -1);
    for (const MeshInstance& instance : assembly.instances) {
        int& at = place[static_cast<std::size_t>(instance.mesh)];
        if (at < 0) {
            at = static_cast<int>(list.size());
            list.push_back({instance.mesh, {}, {}});
        }
        MeshPoses& poses = list[static_cast<std::size_t>(at)];
        (is_mirrored(instance.pose) ? poses.mirrored : poses.straight).push_back(instance.pose);
    }
    return list;
}

constexpr MeshPose mirror{.scale = {-1, 1, 1}};

void add_gpu_instances(Glb& glb, const MeshAssembly& assembly) {
    for (MeshPoses& poses : poses_by_mesh(assembly)) {
        const NamedMesh& named = assembly.meshes[static_cast<std::size_t>(poses.mesh)];
        if (!poses.straight.empty()) {
            const int mesh = glb.add_mesh(named);
            // A node is smaller than a list of one, and needs no extension.
            poses.straight.size() == 1 ? glb.add_node(mesh, poses.straight[0]) : glb.add_instances(mesh, poses.straight);
        }
        if (poses.mirrored.empty()) continue;
        for (MeshPose& pose : poses.mirrored) pose.scale.x = -pose.scale.x;
        glb.add_instances(glb.add_mesh(standing(named, mirror)), poses.mirrored);
    }
}

void add_nodes(Glb& glb, const MeshAssembly& assembly) {
    std::vector<int> place(assembly.meshes.size(), -1);
    for (const MeshInstance& instance : assembly.instances) {
        int& mesh = place[static_cast<std::size_t>(instance.mesh)];
        if (mesh < 0) mesh = glb.add_mesh(assembly.meshes[static_cast<std::size_t>(instance.mesh)]);
        glb.add_node(mesh, instance.pose);
    }
}

void add_merged(Glb& glb, const MeshAssembly& assembly) {
    for (const MeshPoses& poses : poses_by_mesh(assembly)) {
        const NamedMesh& named = assembly.meshes[static_cast<std::size_t>(poses.mesh)];
        NamedMesh all{.name = named.name, .color = named.color};
        for (const auto* list : {&poses.straight, &poses.mirrored})
            for (const MeshPose& pose : *list) append(all, standing(named, pose));
        glb.add_node(glb.add_mesh(all), {});
    }
}

}  // namespace

std::string glb_bytes(const MeshAssembly& assembly, const GlbOptions& options) {
    Glb glb(options);
    switch (options.instancing) {
        case GlbInstancing::gpu:
            add_gpu_instances(glb, assembly);
            break;
        case GlbInstancing::nodes:
            add_nodes(glb, assembly);
            break;
        case GlbInstancing::merge:
            add_merged(glb, assembly);
            break;
    }
    return glb.bytes();
}

std::string glb_bytes(const MeshAssembly& assembly, UpAxis up) { return glb_bytes(assembly, GlbOptions{.up = up}); }

}  // namespace rinceau

// Instances out: the three ways of GLB, PLY and OBJ all hold the same triangles.

#include <tiny_gltf.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "geometry/angle.h"
#include "growth/mesh/mesh_glb_write.h"
#include "growth/mesh/mesh_obj_read.h"
#include "growth/mesh/mesh_obj_write.h"
#include "growth/mesh/mesh_ply_read.h"
#include "growth/mesh/mesh_ply_write.h"

namespace rinceau {
namespace {

/// A skew pyramid, which no mirror image of it equals.
TriangleMesh pyramid() {
    return {{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0.25, 0.25, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

double signed_volume(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const auto corner = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(t[k])]; };
        sum += dot(corner(0), cross(corner(1), corner(2))) / 6;
    }
    return sum;
}

MeshAssembly turned_pyramids(int count) {
    MeshAssembly assembly{.meshes = {{"ground", pyramid(), {10, 20, 30}}, {"leaf", pyramid(), {200, 100, 0}}}};
    assembly.instances.push_back({0, {}});
    for (int i = 0; i < count; ++i)
        assembly.instances.push_back({1,
                                      {.translation = {3.0 * i, 1, -2},
                                       .rotation = rotation_about(unit({1, 2, 0.5}), 0.3 + i),
                                       .scale = {i % 3 == 2 ? -0.5 : 0.5, 1, 2}}});
    return assembly;
}

/// All triangles of the file, where its nodes and instances put them.
TriangleMesh unfolded(const std::string& bytes) {
    tinygltf::Model model;
    tinygltf::TinyGLTF reader;
    std::string error, warning;
    REQUIRE(reader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                        static_cast<unsigned int>(bytes.size())));
    CHECK(error.empty());
    CHECK(warning.empty());
    const auto bytes_of = [&](int accessor) {
        const auto& a = model.accessors[static_cast<std::size_t>(accessor)];
        const auto& view = model.bufferViews[static_cast<std::size_t>(a.bufferView)];
        return std::pair{model.buffers[0].data.data() + view.byteOffset, a.count};
    };
    const auto floats = [&](int accessor, std::size_t width) {
        const auto [data, count] = bytes_of(accessor);
        std::vector<float> numbers(width * count);
        std::memcpy(numbers.data(), data, sizeof(float) * numbers.size());
        return numbers;
    };
    NamedMesh all;
    for (const tinygltf::Node& node : model.nodes) {
        const auto& primitive = model.meshes[static_cast<std::size_t>(node.mesh)].primitives[0];
        NamedMesh named;
        const auto positions = floats(primitive.attributes.at("POSITION"), 3);
        for (std::size_t i = 0; i < positions.size(); i += 3)
            named.mesh.positions.push_back({positions[i], positions[i + 1], positions[i + 2]});
        const auto [data, count] = bytes_of(primitive.indices);
        std::vector<std::uint32_t> indices(count);
        std::memcpy(indices.data(), data, sizeof(std::uint32_t) * count);
        for (std::size_t i = 0; i < count; i += 3)
            named.mesh.triangles.push_back(
                {static_cast<int>(indices[i]), static_cast<int>(indices[i + 1]), static_cast<int>(indices[i + 2])});
        std::vector<MeshPose> poses;
        if (const auto found = node.extensions.find("EXT_mesh_gpu_instancing"); found != node.extensions.end()) {
            CHECK(model.extensionsRequired == std::vector<std::string>{"EXT_mesh_gpu_instancing"});
            const auto& attributes = found->second.Get("attributes");
            const auto moves = floats(attributes.Get("TRANSLATION").GetNumberAsInt(), 3);
            const auto turns = floats(attributes.Get("ROTATION").GetNumberAsInt(), 4);
            const auto scales = floats(attributes.Get("SCALE").GetNumberAsInt(), 3);
            for (std::size_t i = 0; 3 * i < moves.size(); ++i)
                poses.push_back({{moves[3 * i], moves[3 * i + 1], moves[3 * i + 2]},
                                 {turns[4 * i], turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]},
                                 {scales[3 * i], scales[3 * i + 1], scales[3 * i + 2]}});
            for (const MeshPose& pose : poses) CHECK(!is_mirrored(pose));
        } else {
            MeshPose pose;
            if (!node.translation.empty())
                pose.translation = {node.translation[0], node.translation[1], node.translation[2]};
            if (!node.rotation.empty()) std::ranges::copy(node.rotation, pose.rotation.begin());
            if (!node.scale.empty()) pose.scale = {node.scale[0], node.scale[1], node.scale[2]};
            poses.push_back(pose);
        }
        for (const MeshPose& pose : poses) append(all, standing(named, pose));
    }
    return all.mesh;
}

std::string ply_text(const MeshAssembly& assembly) {
    std::string text;
    write_ply(assembly, [&](std::string_view piece) { text += piece; });
    return text;
}

/// The middles of all triangles, sorted.
std::vector<std::array<double, 3>> middles(const TriangleMesh& mesh) {
    std::vector<std::array<double, 3>> list;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto at = [&](int v) { return mesh.positions[static_cast<std::size_t>(v)]; };
        const SpacePoint m = at(a) + at(b) + at(c);
        list.push_back({m.x, m.y, m.z});
    }
    std::ranges::sort(list);
    return list;
}

void check_same(const TriangleMesh& mesh, const TriangleMesh& wanted) {
    const auto a = middles(mesh), b = middles(wanted);
    REQUIRE(a.size() == b.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, std::abs(a[i][k] - b[i][k]));
    CHECK(worst < 1e-4);
}

}  // namespace

TEST_CASE("GLB by GPU instances, by nodes and merged, PLY and OBJ hold the same triangles, mirrored ones outward, too") {
    const MeshAssembly assembly = turned_pyramids(10);
    NamedMesh wanted;
    for (const MeshInstance& instance : assembly.instances)
        append(wanted, standing(assembly.meshes[static_cast<std::size_t>(instance.mesh)], instance.pose));
    CHECK(signed_volume(wanted.mesh) == Approx(11));  // each of them 1
    for (const GlbInstancing how : {GlbInstancing::gpu, GlbInstancing::nodes, GlbInstancing::merge}) {
        const TriangleMesh mesh = unfolded(glb_bytes(assembly, {.instancing = how}));
        check_same(mesh, wanted.mesh);
        CHECK(signed_volume(mesh) == Approx(11).epsilon(1e-5));
    }
    const TriangleMesh ply = read_ply(ply_text(assembly));
    CHECK(ply.positions == wanted.mesh.positions);
    CHECK(ply.triangles == wanted.mesh.triangles);
    std::string obj;
    write_obj(assembly, [&](std::string_view piece) { obj += piece; }, {.colors = true, .normals = true});
    const TriangleMesh read = read_obj(obj);
    check_same(read, wanted.mesh);
    CHECK(signed_volume(read) == Approx(11));
    CHECK(obj.find("v 0 0 0 0.03922 0.07843 0.1176\n") != std::string::npos);
    CHECK(std::count(obj.begin(), obj.end(), 'n') >= 11 * 12);
}

TEST_CASE("A million faces by GPU instances take 40 bytes an instance") {
    const std::size_t few = glb_bytes(turned_pyramids(3), {.instancing = GlbInstancing::gpu}).size();
    const std::size_t many = glb_bytes(turned_pyramids(3003), {.instancing = GlbInstancing::gpu}).size();
    CHECK(many - few >= 40 * 3000);
    CHECK(many - few < 40 * 3000 + 100);
}

TEST_CASE("Normals stand at right angles on a stretched and mirrored surface, and outward") {
    const TriangleMesh mesh = pyramid();
    const MeshPose pose{.translation = {1, 2, 3}, .rotation = rotation_about(unit({1, 1, 0}), 1), .scale = {-3, 0.5, 2}};
    const NamedMesh stood = standing({.name = "p", .mesh = mesh}, pose);
    const auto before = triangle_normals(mesh), after = triangle_normals(stood.mesh);
    for (std::size_t t = 0; t < before.size(); ++t) CHECK(abs(apply_to_normal(pose, before[t]) - after[t]) < 1e-12);
}

}  // namespace rinceau

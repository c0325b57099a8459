// Meshes in and out: OBJ there and back, GLB read by the library and by its numbers, what is seen from above.

#include <algorithm>
#include <cstring>

#include <tiny_gltf.h>
#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "growth/mesh/mesh_glb_write.h"
#include "growth/mesh/mesh_obj_read.h"
#include "growth/mesh/mesh_obj_write.h"
#include "growth/mesh/mesh_silhouette.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

// A box of 2 x 1 x 3 with quads, one of them with negative numbers, and a vertex that nothing uses.
const std::string box_text =
    "# a box\nv 9 9 9\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 3\nv 2 0 3 # in front\nv 2 1 3\nv 0 1 3\n"
    "vn 0 0 1\no box\nf 2 5 4 3\nf 6//1 7//1 8//1 9//1\ng sides\nf 2 3 7 6\nf 3 4 8 7\nf 4 5 9 8\nf -4 -1 -5 -8\n";

double volume(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const auto corner = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(t[k])]; };
        sum += dot(corner(0), cross(corner(1), corner(2))) / 6;
    }
    return sum;
}

std::string obj_text(const MeshAssembly& assembly) {
    std::string text;
    write_obj(assembly, [&](std::string_view piece) { text += piece; });
    return text;
}

std::string refusal(const std::string& text) {
    try {
        read_obj(text, {.file_name = "bad.obj", .max_corners = 100});
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

MeshAssembly three_boxes() {
    const TriangleMesh box = read_obj(box_text);
    MeshAssembly assembly{.meshes = {{"box", box}, {"unused", box}, {"other", box, {255, 0, 0}}}};
    assembly.instances = {{0, ground_pose({}, UpAxis::y)},
                          {2, ground_pose({polar(0.5, pi / 2), {10, 20}}, UpAxis::y)},
                          {0, ground_pose({polar(2, -1), {-3, 4}}, UpAxis::y)}};
    return assembly;
}

tinygltf::Model read_glb(const std::string& bytes) {
    tinygltf::Model model;
    tinygltf::TinyGLTF reader;
    std::string error, warning;
    REQUIRE(reader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                        static_cast<unsigned int>(bytes.size())));
    CHECK(error.empty());
    CHECK(warning.empty());
    return model;
}

template <class Number>
std::vector<Number> numbers_of(const tinygltf::Model& model, int accessor, std::size_t width) {
    const auto& a = model.accessors[static_cast<std::size_t>(accessor)];
    const auto& view = model.bufferViews[static_cast<std::size_t>(a.bufferView)];
    std::vector<Number> numbers(a.count * width);
    REQUIRE(view.byteLength == sizeof(Number) * numbers.size());
    REQUIRE(view.byteOffset % 4 == 0);
    std::memcpy(numbers.data(), model.buffers[0].data.data() + view.byteOffset, view.byteLength);
    return numbers;
}

}  // namespace

TEST_CASE("An OBJ with quads, negative numbers and comments is read as triangles, with outward sides") {
    const TriangleMesh mesh = read_obj(box_text);
    CHECK(mesh.positions.size() == 8);
    CHECK(mesh.triangles.size() == 12);
    CHECK(volume(mesh) == Approx(6));
    const auto [low, high] = bounds(mesh);
    CHECK(low == SpacePoint{0, 0, 0});
    CHECK(high == SpacePoint{2, 1, 3});
}

TEST_CASE("A written OBJ reads back as all its instances where they stand") {
    const MeshAssembly assembly = three_boxes();
    const std::string text = obj_text(assembly);
    const TriangleMesh mesh = read_obj(text);
    CHECK(mesh.triangles.size() == 36);
    CHECK(volume(mesh) == Approx(6 * (1 + 0.125 + 8)));
    CHECK(text.find("g box_1\n") < text.find("g other_1\n"));
    CHECK(text.find("g other_1\n") < text.find("g box_2\n"));
    // The library's own reading of numbers misses their last digit.
    const TriangleMesh again = read_obj(obj_text({.meshes = {{"all", mesh}}, .instances = {{0, {}}}}));
    REQUIRE(again.positions.size() == mesh.positions.size());
    double worst = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        worst = std::max(worst, abs(again.positions[i] - mesh.positions[i]));
    CHECK(worst < 1e-13);
}

TEST_CASE("A broken OBJ is refused with its line") {
    const std::vector<std::pair<std::string, std::string>> bad = {
        {"", "bad.obj: expected a mesh with vertices"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "bad.obj: expected a mesh with faces"},
        {"v 0 0 0\nv 1 zero 0\n", "bad.obj:2: expected three numbers after 'v', found 'zero'"},
        {"v 0 0\n", "bad.obj:1: expected three numbers after 'v', found ''"},
        {"v 0 0 inf\n", "bad.obj:1: expected three numbers after 'v', found 'inf'"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n", "bad.obj:5: the face has vertex 4, but up to here there are 3"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "bad.obj:4: the face has vertex -4, but up to here there are 3"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "bad.obj:4: expected the number of a vertex, found '0'"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "bad.obj:4: expected a face of at least three corners, found 2"},
        {"v 0 0 0\nf 1 1 1" + std::string(400, '1') + "\n", "bad.obj:2: expected the number of a vertex"},
        {"v 0 0 0\nf " +
             [] {
                 std::string many;
                 for (int i = 0; i < 101; ++i) many += "1 ";
                 return many;
             }() +
             "\n",
         "bad.obj:2: more than 100 corners in a face"}};
    for (const auto& [text, message] : bad) {
        CAPTURE(text, message);
        CHECK(refusal(text).starts_with(message));
    }
}

TEST_CASE(
    "A GLB holds each mesh once and a node for each instance, and the library reads it, and its numbers are the instances'") {
    const MeshAssembly assembly = three_boxes();
    const tinygltf::Model model = read_glb(glb_bytes(assembly));
    REQUIRE(model.meshes.size() == 2);
    REQUIRE(model.nodes.size() == 3);
    CHECK(model.scenes[0].nodes == std::vector<int>{0, 1, 2});
    CHECK(model.nodes[0].mesh == 0);
    CHECK(model.nodes[1].mesh == 1);
    CHECK(model.nodes[2].mesh == 0);
    const auto& primitive = model.meshes[0].primitives[0];
    const auto positions = numbers_of<float>(model, primitive.attributes.at("POSITION"), 3);
    const auto normals = numbers_of<float>(model, primitive.attributes.at("NORMAL"), 3);
    const auto indices = numbers_of<std::uint32_t>(model, primitive.indices, 1);
    // The edges of a box are sharp: a vertex for each corner of each side.
    CHECK(positions.size() == 3 * 24);
    CHECK(normals.size() == positions.size());
    CHECK(indices.size() == 36);
    CHECK(*std::ranges::max_element(indices) == 23);
    TriangleMesh mesh;
    for (std::size_t i = 0; i < positions.size(); i += 3)
        mesh.positions.push_back({positions[i], positions[i + 1], positions[i + 2]});
    for (std::size_t i = 0; i < indices.size(); i += 3)
        mesh.triangles.push_back(
            {static_cast<int>(indices[i]), static_cast<int>(indices[i + 1]), static_cast<int>(indices[i + 2])});
    CHECK(volume(mesh) == Approx(6));
    const std::vector<SpacePoint> flat = triangle_normals(mesh);
    for (std::size_t t = 0; t < flat.size(); ++t) {
        const auto v = 3 * static_cast<std::size_t>(mesh.triangles[t][0]);
        CHECK(dot(flat[t], {normals[v], normals[v + 1], normals[v + 2]}) == Approx(1));
    }
    const auto& accessor = model.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))];
    CHECK(accessor.minValues == std::vector<double>{0, 0, 0});
    CHECK(accessor.maxValues == std::vector<double>{2, 1, 3});
    // Turned by a quarter and halved, the front of the box lies to its right.
    const auto& node = model.nodes[1];
    CHECK(node.translation == std::vector<double>{10, 0, -20});
    CHECK(node.scale == std::vector<double>{0.5, 0.5, 0.5});
    const SpacePoint corner = apply(assembly.instances[1].pose, {2, 1, 3});
    CHECK(corner.x == Approx(10 + 1.5));
    CHECK(corner.y == Approx(0.5));
    CHECK(corner.z == Approx(-20 - 1));
    CHECK(model.materials[1].pbrMetallicRoughness.baseColorFactor == std::vector<double>{1, 0, 0, 1});
}

TEST_CASE("With z up a node above all turns a GLB to y up") {
    MeshAssembly assembly = three_boxes();
    const tinygltf::Model model = read_glb(glb_bytes(assembly, UpAxis::z));
    REQUIRE(model.nodes.size() == 4);
    CHECK(model.scenes[0].nodes == std::vector<int>{0});
    CHECK(model.nodes[0].children == std::vector<int>{1, 2, 3});
    const auto& q = model.nodes[0].rotation;
    const SpacePoint up = apply(MeshPose{.rotation = {q[0], q[1], q[2], q[3]}}, {0, 0, 1});
    CHECK(up.y == Approx(1));
    CHECK(up.z == Approx(0).margin(1e-12));
}

TEST_CASE("From above a mesh covers its silhouette: towers, overhangs and holes") {
    // Two boards crossed, a small box in the air over one of them.
    const auto board = [](double x0, double x1, double z0, double z1, double y) {
        TriangleMesh mesh;
        mesh.positions = {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
        mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
        return mesh;
    };
    TriangleMesh all;
    for (const TriangleMesh& part :
         {board(0, 10, 4, 6, 0), board(4, 6, 0, 10, 1), board(0, 2, 4, 5, 3), board(0, 10, 0, 1, 2)}) {
        const int first = static_cast<int>(all.positions.size());
        all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
        for (const auto& t : part.triangles) all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    const Region region = silhouette(all, UpAxis::y, "boards");
    CHECK(area(region) == Approx(20 + 20 - 4 + 10 - 2));
    const Box box = bounds(region);
    CHECK(box.low.y == Approx(-10));  // z points to the front, down in the plane
    CHECK(box.high.y == Approx(0).margin(1e-6));
    CHECK_THROWS_AS(silhouette(all, UpAxis::z, "edge on"), InputError);
}

}  // namespace rinceau

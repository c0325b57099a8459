// Meshes from OBJ, OFF and PLY: the same solid by every way, and refusals that tell where.

#include "growth/mesh/mesh_read.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cstring>

#include "growth/mesh/mesh_off_read.h"
#include "growth/mesh/mesh_ply_read.h"
#include "growth/mesh/split_polygon.h"
#include "scene/input_error.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

double volume_of(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const auto corner = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(t[k])]; };
        sum += dot(corner(0), cross(corner(1), corner(2))) / 6;
    }
    return sum;
}

/// A cube of side 2 as quads, but for its top, a triangle fan about a vertex in the middle.
const std::vector<std::array<double, 3>> cube_vertices{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1},
                                                       {1, -1, 1},   {1, 1, 1},   {-1, 1, 1}, {0, 0, 1}};
const std::vector<std::vector<int>> cube_faces{{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7},
                                               {4, 5, 8},    {5, 6, 8},    {6, 7, 8},    {7, 4, 8}};

void add_bytes(std::string& text, const void* value, std::size_t size, bool big) {
    std::array<char, 8> bytes{};
    std::memcpy(bytes.data(), value, size);
    if (big != (std::endian::native == std::endian::big))
        std::reverse(bytes.begin(), bytes.begin() + static_cast<long>(size));
    text.append(bytes.data(), size);
}

/// With a colour and a list for each vertex, a flag for each face, and an element that no one knows.
std::string binary_ply(bool big) {
    std::string text = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                       "_endian 1.0\ncomment made here\nelement vertex 9\nproperty uchar red\nproperty double x\n"
                       "property float y\nproperty list uchar short marks\nproperty short z\nelement note 2\n"
                       "property list uint int words\nelement face 9\nproperty int flag\n"
                       "property list ushort uint vertex_index\nend_header\n";
    for (const auto& [x, y, z] : cube_vertices) {
        const auto fy = static_cast<float>(y);
        const auto sz = static_cast<std::int16_t>(z);
        const std::int16_t mark = 77;
        text += '\xff';
        add_bytes(text, &x, 8, big);
        add_bytes(text, &fy, 4, big);
        text += '\2';
        add_bytes(text, &mark, 2, big);
        add_bytes(text, &mark, 2, big);
        add_bytes(text, &sz, 2, big);
    }
    for (const std::uint32_t words : {3U, 0U}) {
        add_bytes(text, &words, 4, big);
        for (std::uint32_t i = 0; i < words; ++i) add_bytes(text, &i, 4, big);
    }
    for (const std::vector<int>& face : cube_faces) {
        const std::int32_t flag = -1;
        const auto corners = static_cast<std::uint16_t>(face.size());
        add_bytes(text, &flag, 4, big);
        add_bytes(text, &corners, 2, big);
        for (const int v : face) add_bytes(text, &v, 4, big);
    }
    return text;
}

std::string ascii_ply() {
    std::string text =
        "ply\r\nformat ascii 1.0\r\nelement vertex 9\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
        "property uchar red\r\nelement face 9\r\nproperty list uchar int vertex_indices\r\nend_header\r\n";
    for (const auto& [x, y, z] : cube_vertices)
        text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + " 7\r\n";
    for (const std::vector<int>& face : cube_faces) {
        text += std::to_string(face.size());
        for (const int v : face) text += " " + std::to_string(v);
        text += "\r\n";
    }
    return text;
}

std::string cube_off(const std::string& magic) {
    std::string text = "# a cube\n" + magic + "\n\n9 9 0\n";
    for (const auto& [x, y, z] : cube_vertices)
        text += std::to_string(x) + " " + std::to_string(y) + "\t" + std::to_string(z) + " 255 0 0 # red\n";
    for (const std::vector<int>& face : cube_faces) {
        text += "  " + std::to_string(face.size());
        for (const int v : face) text += " " + std::to_string(v);
        text += " 0.5 0.5 0.5\n";
    }
    return text;
}

std::string refusal(const std::string& name, const std::string& text) {
    try {
        read_mesh(name, text, {.max_positions = 1000, .max_triangles = 1000, .max_corners = 50});
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("OFF, PLY as text and PLY as bytes of both orders give the same solid") {
    const TriangleMesh off = read_mesh("CUBE.OFF", cube_off("OFF"));
    CHECK(off.positions.size() == 9);
    CHECK(off.triangles.size() == 14);
    CHECK(volume_of(off) == Approx(8));
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{{"c.off", cube_off("COFF")},
                                                                                     {"c.ply", ascii_ply()},
                                                                                     {"c.ply", binary_ply(false)},
                                                                                     {"c.ply", binary_ply(true)}}) {
        const TriangleMesh mesh = read_mesh(name, text);
        CHECK(mesh.positions == off.positions);
        CHECK(mesh.triangles == off.triangles);
    }
}

TEST_CASE("A mesh keeps the vertex numbers of its OBJ, those that no face uses, too") {
    const std::string text = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 0 1 0\nf 5 2 3\n";
    const TriangleMesh mesh = read_mesh("m.obj", text);
    CHECK(mesh.positions.size() == 5);
    CHECK(mesh.triangles == std::vector<std::array<int, 3>>{{4, 1, 2}});
}

TEST_CASE("An OBJ's lines end at carriage returns too, and no corner leads out of its vertices") {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    CHECK(read_mesh("a.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").triangles.size() == 1);
    CHECK(read_mesh("a.obj", vertices + "f 1 2 3 # 99\n# f 1 2 99\nf 1 2 4\r\n").triangles.size() == 2);
    for (const char* const face : {"#\rf 1 2 90000000", "f 1 2 3\rf 1 2 90000000", "f 1 2 90000000", "f 1 2 -5",
                                   "f 1 2 -9223372036854775808", "f 1 2 4294967297"}) {
        INFO(face);
        CHECK_THROWS_AS(read_mesh("a.obj", vertices + face + "\n"), InputError);
    }
}

TEST_CASE("Polygons are split into triangles that fill them, convex or not") {
    Random random(5);
    for (int trial = 0; trial < 60; ++trial) {
        // A star-shaped polygon in a slanted plane.
        std::vector<SpacePoint> rim;
        const int corners = 4 + static_cast<int>(random.below(30));
        double area = 0;
        std::vector<Point> flat;
        for (int i = 0; i < corners; ++i) flat.push_back(polar(random.uniform(0.2, 1), two_pi * i / corners));
        for (std::size_t i = 0; i < flat.size(); ++i) area += cross(flat[i], flat[(i + 1) % flat.size()]) / 2;
        const SpacePoint normal = unit({random.normal(), random.normal(), random.normal()});
        const SpacePoint x = unit(cross(normal, {0.3, 0.4, -0.8})), y = cross(normal, x);
        std::vector<int> indices;
        for (const Point p : flat) {
            indices.push_back(static_cast<int>(rim.size()));
            rim.push_back(p.x * x + p.y * y);
        }
        double sum = 0;
        const auto triangles = split_polygon(rim, indices);
        REQUIRE(triangles.size() == flat.size() - 2);
        for (const auto& [a, b, c] : triangles) {
            const auto at = [&](int v) { return rim[static_cast<std::size_t>(v)]; };
            const double part = dot(cross(at(b) - at(a), at(c) - at(a)), normal) / 2;
            CHECK(part > -1e-12);
            sum += part;
        }
        CHECK(sum == Approx(area));
    }
}

TEST_CASE("Broken OFF and PLY are refused with their place") {
    const std::string ply = "ply\nformat ascii 1.0\n";
    const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string binary = "ply\nformat binary_little_endian 1.0\n";
    const std::vector<std::array<std::string, 3>> bad{
        {"m.stl", "solid", "m.stl: expected a mesh as .obj, .off or .ply"},
        {"m", "", "m: expected a mesh as .obj, .off or .ply"},
        {"m.off", "", "m.off: expected the word OFF, found the end of the file"},
        {"m.off", "4OFF\n1 2 3\n", "m.off:1: expected the word OFF"},
        {"m.off", "OFF BINARY\n", "m.off:1: expected OFF as text"},
        {"m.off", "OFF\n3 x 0\n", "m.off:2: expected the numbers of vertices and faces"},
        {"m.off", "OFF\n999999999999 1 0\n0 0 0\n", "m.off:2: more than 1000 vertices"},
        {"m.off", "OFF\n900 1 0\n0 0 0\n", "m.off:3: expected vertex 1, found the end of the file"},
        {"m.off", "OFF\n3 1 0\n0 0 0\n1 0\n", "m.off:4: expected three numbers for vertex 1, found ''"},
        {"m.off", "OFF 3 1 0\n0 0 0\n1 0 nan\n", "m.off:3: expected three numbers for vertex 1, found 'nan'"},
        {"m.off", "OFF\n3 1 0\n" + three + "3 0 1 3\n", "m.off:6: the face has vertex 3, but there are 3, counted from 0"},
        {"m.off", "OFF\n3 1 0\n" + three + "3 0 -1 2\n", "m.off:6: expected 3 vertices for face 0, found '-1'"},
        {"m.off", "OFF\n3 1 0\n" + three + "2 0 1\n", "m.off:6: expected a face of at least three corners, found 2"},
        {"m.off", "OFF\n3 1 0\n" + three + "900 0 1\n", "m.off:6: more than 50 corners in a face"},
        {"m.off", "OFF\n3 0 0\n" + three, "m.off: expected a mesh with faces, found none"},
        {"m.ply", "plx\n", "m.ply:1: expected a PLY file"},
        {"m.ply", ply + "element vertex -3\n", "m.ply:3: expected the number of elements 'vertex', found '-3'"},
        {"m.ply", ply + vertices, "m.ply:6: expected end_header, found the end of the file"},
        {"m.ply", ply + "property float x\n", "m.ply:3: a property before the first element"},
        {"m.ply", ply + "element vertex 1\nproperty flout x\n", "m.ply:4: expected a type such as float or uchar"},
        {"m.ply", "ply\nformat ascii 2.0\n", "m.ply:2: expected version 1.0"},
        {"m.ply", "ply\nend_header\n", "m.ply:2: expected a line 'format ascii 1.0'"},
        {"m.ply", ply + vertices + faces + three + "3 0 1 7\n", "m.ply:12: face 0 has vertex 7, but there are 3"},
        {"m.ply", ply + vertices + faces + three + "3 0 1.5 2\n", "m.ply:12: expected a vertex of face 0"},
        {"m.ply", ply + vertices + faces + "0 0 zero\n", "m.ply:9: expected a number, found 'zero'"},
        {"m.ply", ply + vertices + faces + "0 0 inf\n", "m.ply:9: expected finite coordinates of vertex 0"},
        {"m.ply", ply + vertices + faces + three, "m.ply:12: the file ends before all that its header promises"},
        {"m.ply", ply + faces + "3 0 1 2\n", "m.ply:5: expected the vertices before the faces"},
        {"m.ply", ply + vertices + "end_header\n" + three, "m.ply: expected a mesh with faces"},
        {"m.ply", ply + vertices + "element face 1\nproperty int a\nend_header\n" + three,
         "m.ply: expected faces with a list"},
        {"m.ply", ply + "element vertex 1\nproperty float x\nend_header\n1\n", "m.ply: expected vertices with x, y and z"},
        {"m.ply", binary + "element vertex 1000000000000\nproperty float x\n", "m.ply:4: expected end_header"},
        {"m.ply", binary + "element vertex 1000000000000\nproperty float x\nend_header\n", "m.ply: more than 1000 vertices"},
        {"m.ply", binary + "element note 1000000000000\nproperty float x\nend_header\nabcd", "m.ply: the file ends before"},
        {"m.ply", binary + "element note 1000000000000\nend_header\n", "m.ply: expected a mesh with faces"},
        {"m.ply", binary + "element note 1\nproperty list char int a\nend_header\n\xff",
         "m.ply: expected the length of list"}};
    for (const auto& [name, text, message] : bad) {
        CAPTURE(text, message);
        CHECK_THAT(refusal(name, text), Catch::StartsWith(message));
    }
}

TEST_CASE("Half a file never reads, and never more than it holds") {
    const std::string text = binary_ply(false);
    for (std::size_t bytes = 0; bytes < text.size(); ++bytes) CHECK(!refusal("m.ply", text.substr(0, bytes)).empty());
}

// tinyobjloader reads whatever it is given: a word in the place of a number becomes 0, a vertex that is missing a warning.
// The lines of vertices and faces are therefore looked through before it; it then splits the faces.

#include "growth/mesh/mesh_obj_read.h"

#include <tiny_obj_loader.h>

#include <cmath>

#include "scene/input_error.h"

namespace rinceau {
namespace {

class LineCheck {
  public:
    explicit LineCheck(const MeshReadOptions& options) : options_(options) {}

    /// A line, which tinyobjloader ends at a carriage return as well.
    void check(std::string_view line) {
        ++line_;
        for (std::size_t end = line.find('\r'); end != std::string_view::npos; end = line.find('\r')) {
            check_statement(line.substr(0, end));
            line.remove_prefix(end + 1);
        }
        check_statement(line);
    }
    void check_end() const {
        if (positions_ == 0) throw InputError({options_.file_name}, "expected a mesh with vertices ('v x y z'), found none");
        if (triangles_ == 0) throw InputError({options_.file_name}, "expected a mesh with faces ('f 1 2 3'), found none");
    }

  private:
    const MeshReadOptions& options_;
    int line_ = 0;
    std::size_t positions_ = 0;
    std::size_t triangles_ = 0;

    void check_statement(std::string_view line) {
        line = line.substr(0, line.find('#'));
        const std::string_view kind = take_word(line);
        if (kind == "v") check_vertex(line);
        if (kind == "f") check_face(line);
    }

    [[noreturn]] void fail(const std::string& message) const { throw InputError({options_.file_name, line_}, message); }
    [[noreturn]] void fail_limit(std::size_t most, const std::string& things) const {
        throw LimitError({options_.file_name, line_}, "more than " + std::to_string(most) + " " + things);
    }

    void check_vertex(std::string_view rest) {
        for (int k = 0; k < 3; ++k) {
            const std::string_view word = take_word(rest);
            double value = 0;
            if (!reads_whole(word, value) || !std::isfinite(value))
                fail("expected three numbers after 'v', found '" + std::string(word) + "'");
        }
        if (++positions_ > options_.max_positions) fail_limit(options_.max_positions, "vertices in a mesh");
    }

    /// A corner is "place", "place/texture", "place//normal" or all three; places count from 1, or from -1 backwards.
    void check_corner(std::string_view corner) const {
        const std::string_view word = corner.substr(0, corner.find('/'));
        long place = 0;
        if (!reads_whole(word, place) || place == 0)
            fail("expected the number of a vertex, found '" + std::string(word) + "'");
        const auto there = static_cast<long>(positions_);
        if (place > there || place < -there)
            fail("the face has vertex " + std::to_string(place) + ", but up to here there are " +
                 std::to_string(positions_));
    }

    void check_face(std::string_view rest) {
        std::size_t corners = 0;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            check_corner(word);
            if (++corners > options_.max_corners) fail_limit(options_.max_corners, "corners in a face");
        }
        if (corners < 3) fail("expected a face of at least three corners, found " + std::to_string(corners));
        triangles_ += corners - 2;
        if (triangles_ > options_.max_triangles) fail_limit(options_.max_triangles, "triangles in a mesh");
    }
};

void check_lines(std::string_view text, const MeshReadOptions& options) {
    LineCheck lines(options);
    while (!text.empty()) lines.check(take_line(text));
    lines.check_end();
}

/// tinyobjloader knows comments only where a line begins.
std::string without_comments(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    bool comment = false;
    for (const char c : text) {
        if (c == '#') comment = true;
        if (c == '\n' || c == '\r') comment = false;
        if (!comment) plain += c;
    }
    return plain;
}

/// `place`: by the file's number of a position its number in the mesh, -1 = not used yet.
TriangleMesh mesh_of(const tinyobj::ObjReader& reader, const MeshReadOptions& options) {
    TriangleMesh mesh;
    const std::vector<tinyobj::real_t>& numbers = reader.GetAttrib().vertices;
    std::vector<int> place(numbers.size() / 3, -1);
    const auto position_of = [&](int index) {
        const auto v = static_cast<std::size_t>(index);
        if (v >= place.size()) throw InputError({options.file_name}, "a face has a vertex that is not there");
        if (place[v] < 0) {
            place[v] = static_cast<int>(mesh.positions.size());
            mesh.positions.push_back({numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2]});
        }
        return place[v];
    };
    if (options.keep_numbers)
        for (std::size_t v = 0; v < place.size(); ++v) position_of(static_cast<int>(v));
    for (const tinyobj::shape_t& shape : reader.GetShapes())
        for (std::size_t i = 0; i + 2 < shape.mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return position_of(shape.mesh.indices[i + k].vertex_index); };
            const int a = corner(0), b = corner(1), c = corner(2);
            mesh.triangles.push_back({a, b, c});
        }
    return mesh;
}

}  // namespace

TriangleMesh read_obj(const std::string& text, const MeshReadOptions& options) {
    check_lines(text, options);
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig config;
    config.vertex_color = false;
    if (!reader.ParseFromString(without_comments(text), "", config)) throw InputError({options.file_name}, reader.Error());
    TriangleMesh mesh = mesh_of(reader, options);
    if (mesh.triangles.empty()) throw InputError({options.file_name}, "expected faces with an area, found none");
    return mesh;
}

}  // namespace rinceau

#include "growth/mesh/mesh_off_read.h"

#include <cmath>
#include <optional>

#include "growth/mesh/split_polygon.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// Lines with something in them, without comments.
class OffLines {
  public:
    OffLines(std::string_view text, const MeshReadOptions& options) : rest_(text), options_(options) {}

    std::string_view next(const std::string& expected) {
        while (!rest_.empty()) {
            std::string_view line = take_line(rest_);
            ++line_;
            line = line.substr(0, line.find('#'));
            std::string_view probe = line;
            if (!take_word(probe).empty()) return line;
        }
        fail("expected " + expected + ", found the end of the file");
    }
    [[noreturn]] void fail(const std::string& message) const { throw InputError({options_.file_name, line_}, message); }
    [[noreturn]] void fail_limit(std::size_t most, const std::string& things) const {
        throw LimitError({options_.file_name, line_}, "more than " + std::to_string(most) + " " + things);
    }
    /// Of `things`, of which each takes a line of some bytes: no more than can be there, whatever the header promises.
    std::size_t room(std::size_t promised) const {
        constexpr std::size_t least_bytes = 6;  // "0 0 0\n"
        return std::min(promised, rest_.size() / least_bytes + 1);
    }

  private:
    std::string_view rest_;
    const MeshReadOptions& options_;
    int line_ = 0;
};

struct OffCounts {
    std::size_t vertices = 0, faces = 0;
};

/// The line behind the word OFF may go on with the numbers, or they stand in the next one.
OffCounts read_header(OffLines& lines, const MeshReadOptions& options) {
    std::string_view line = lines.next("the word OFF");
    const std::string_view magic = take_word(line);
    if (!magic.ends_with("OFF") || magic.find_first_not_of("STCNOF") != std::string_view::npos)
        lines.fail("expected the word OFF (three coordinates a vertex), found '" + std::string(magic.substr(0, 40)) + "'");
    std::string_view word = take_word(line);
    if (word == "BINARY") lines.fail("expected OFF as text, found BINARY; save it as text or as PLY");
    if (word.empty()) {
        line = lines.next("the numbers of vertices and faces");
        word = take_word(line);
    }
    OffCounts counts;
    if (!reads_whole(word, counts.vertices) || !reads_whole(take_word(line), counts.faces))
        lines.fail("expected the numbers of vertices and faces after OFF");
    if (counts.vertices > options.max_positions) lines.fail_limit(options.max_positions, "vertices in a mesh");
    if (counts.faces > options.max_triangles) lines.fail_limit(options.max_triangles, "triangles in a mesh");
    return counts;
}

SpacePoint read_vertex(OffLines& lines, std::size_t number) {
    std::string_view line = lines.next("vertex " + std::to_string(number));
    std::array<double, 3> at{};
    for (double& coordinate : at) {
        const std::string_view word = take_word(line);
        if (!reads_whole(word, coordinate) || !std::isfinite(coordinate))
            lines.fail("expected three numbers for vertex " + std::to_string(number) + ", found '" +
                       std::string(word.substr(0, 40)) + "'");
    }
    return {at[0], at[1], at[2]};
}

std::vector<int> read_face(OffLines& lines, std::size_t number, std::size_t vertices, const MeshReadOptions& options) {
    std::string_view line = lines.next("face " + std::to_string(number));
    std::size_t count = 0;
    if (const std::string_view word = take_word(line); !reads_whole(word, count))
        lines.fail("expected the number of corners of face " + std::to_string(number) + ", found '" +
                   std::string(word.substr(0, 40)) + "'");
    if (count < 3) lines.fail("expected a face of at least three corners, found " + std::to_string(count));
    if (count > options.max_corners) lines.fail_limit(options.max_corners, "corners in a face");
    std::vector<int> corners;
    for (std::size_t k = 0; k < count; ++k) {
        const std::string_view word = take_word(line);
        std::size_t v = 0;
        if (!reads_whole(word, v))
            lines.fail("expected " + std::to_string(count) + " vertices for face " + std::to_string(number) + ", found '" +
                       std::string(word.substr(0, 40)) + "'");
        if (v >= vertices)
            lines.fail("the face has vertex " + std::to_string(v) + ", but there are " + std::to_string(vertices) +
                       ", counted from 0");
        corners.push_back(static_cast<int>(v));
    }
    return corners;
}

}  // namespace

TriangleMesh read_off(const std::string& text, const MeshReadOptions& options) {
    OffLines lines(text, options);
    const OffCounts counts = read_header(lines, options);
    TriangleMesh mesh;
    mesh.positions.reserve(lines.room(counts.vertices));
    for (std::size_t i = 0; i < counts.vertices; ++i) mesh.positions.push_back(read_vertex(lines, i));
    mesh.triangles.reserve(lines.room(counts.faces));
    for (std::size_t i = 0; i < counts.faces; ++i) {
        const std::vector<int> corners = read_face(lines, i, counts.vertices, options);
        for (const auto& triangle : split_polygon(mesh.positions, corners)) mesh.triangles.push_back(triangle);
        if (mesh.triangles.size() > options.max_triangles) lines.fail_limit(options.max_triangles, "triangles in a mesh");
    }
    if (mesh.triangles.empty()) throw InputError({options.file_name}, "expected a mesh with faces, found none");
    return mesh;
}

}  // namespace rinceau

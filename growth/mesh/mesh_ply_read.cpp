// One walk over the elements; where the next number comes from, text or bytes, is a PlyNumbers' matter.

#include "growth/mesh/mesh_ply_read.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "growth/mesh/ply_header.h"
#include "growth/mesh/split_polygon.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// The numbers behind the header, one after the other. Every type's values fit into a double.
class PlyNumbers {
  public:
    PlyNumbers(std::string_view text, const PlyHeader& header, const MeshReadOptions& options)
        : text_(text), options_(options), format_(header.format), at_(header.bytes), line_(header.lines) {}

    double next(PlyType type) { return format_ == PlyFormat::ascii ? next_word() : next_bytes(type); }
    std::size_t bytes_left() const { return text_.size() - at_; }
    /// Leaves out `count` numbers of a type, or as many as there are.
    void skip(PlyType type, std::size_t count) {
        if (format_ == PlyFormat::ascii) {
            for (std::size_t i = 0; i < count; ++i) take_text();
        } else {
            if (count > bytes_left() / bytes_of(type)) fail_end();
            at_ += count * bytes_of(type);
        }
    }
    [[noreturn]] void fail(const std::string& message) const {
        if (format_ == PlyFormat::ascii) throw InputError({options_.file_name, line_}, message);
        throw InputError({options_.file_name}, message + ", before byte " + std::to_string(at_));
    }
    [[noreturn]] void fail_limit(std::size_t most, const std::string& things) const {
        throw LimitError({options_.file_name}, "more than " + std::to_string(most) + " " + things);
    }

  private:
    std::string_view text_;
    const MeshReadOptions& options_;
    PlyFormat format_;
    std::size_t at_;  ///< of the next byte
    int line_;

    [[noreturn]] void fail_end() const { fail("the file ends before all that its header promises"); }

    std::string_view take_text() {
        constexpr std::string_view blanks = " \t\r\n\v\f";
        while (at_ < text_.size() && blanks.find(text_[at_]) != std::string_view::npos)
            line_ += text_[at_++] == '\n' ? 1 : 0;
        const std::size_t end = std::min(text_.find_first_of(blanks, at_), text_.size());
        const std::string_view word = text_.substr(at_, end - at_);
        at_ = end;
        if (word.empty()) fail_end();
        return word;
    }
    double next_word() {
        const std::string_view word = take_text();
        double value = 0;
        if (!reads_whole(word, value)) fail("expected a number, found '" + std::string(word.substr(0, 40)) + "'");
        return value;
    }
    template <class Number, class Bits>
    double number_of(std::uint64_t bits) const {
        return static_cast<double>(std::bit_cast<Number>(static_cast<Bits>(bits)));
    }
    double next_bytes(PlyType type) {
        const std::size_t size = bytes_of(type);
        if (bytes_left() < size) fail_end();
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t from = format_ == PlyFormat::big_endian ? i : size - 1 - i;
            bits = bits << 8U | static_cast<unsigned char>(text_[at_ + from]);
        }
        at_ += size;
        switch (type) {
            case PlyType::int8:
                return number_of<std::int8_t, std::uint8_t>(bits);
            case PlyType::uint8:
                return number_of<std::uint8_t, std::uint8_t>(bits);
            case PlyType::int16:
                return number_of<std::int16_t, std::uint16_t>(bits);
            case PlyType::uint16:
                return number_of<std::uint16_t, std::uint16_t>(bits);
            case PlyType::int32:
                return number_of<std::int32_t, std::uint32_t>(bits);
            case PlyType::uint32:
                return number_of<std::uint32_t, std::uint32_t>(bits);
            case PlyType::float32:
                return number_of<float, std::uint32_t>(bits);
            default:
                return number_of<double, std::uint64_t>(bits);
        }
    }
};

/// A whole number that counts something: never negative, no fraction.
std::size_t next_count(PlyNumbers& numbers, PlyType type, const std::string& what) {
    constexpr double largest = 4294967295;  // of the widest integer type
    const double value = numbers.next(type);
    if (!(value >= 0 && value <= largest && value == std::floor(value))) numbers.fail("expected " + what);
    return static_cast<std::size_t>(value);
}

void skip_property(PlyNumbers& numbers, const PlyProperty& property) {
    const std::size_t count =
        property.is_list ? next_count(numbers, property.count_type, "the length of list '" + property.name + "'") : 1;
    numbers.skip(property.type, count);
}

class PlyMeshReader {
  public:
    PlyMeshReader(std::string_view text, const MeshReadOptions& options)
        : header_(read_ply_header(text, options)), numbers_(text, header_, options), options_(options) {}

    TriangleMesh read() {
        bool has_vertices = false;
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                read_vertices(element);
                has_vertices = true;
            } else if (element.name == "face") {
                if (!has_vertices) numbers_.fail("expected the vertices before the faces");
                read_faces(element);
            } else {
                skip(element);
            }
        }
        if (mesh_.triangles.empty())
            throw InputError({options_.file_name}, "expected a mesh with faces (element face), found none");
        return std::move(mesh_);
    }

  private:
    PlyHeader header_;
    PlyNumbers numbers_;
    const MeshReadOptions& options_;
    TriangleMesh mesh_;

    void skip(const PlyElement& element) {
        if (element.properties.empty()) return;  // takes no bytes, however many there are
        for (std::size_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) skip_property(numbers_, property);
    }

    /// For each coordinate the place of its property.
    std::array<std::size_t, 3> coordinate_places(const PlyElement& element) const {
        constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
        std::array<std::size_t, 3> places{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto found = std::ranges::find(element.properties, names[k], &PlyProperty::name);
            if (found == element.properties.end() || found->is_list)
                throw InputError({options_.file_name},
                                 "expected vertices with x, y and z, found no property " + std::string(names[k]));
            places[k] = static_cast<std::size_t>(found - element.properties.begin());
        }
        return places;
    }

    void read_vertices(const PlyElement& element) {
        if (element.count > options_.max_positions) numbers_.fail_limit(options_.max_positions, "vertices in a mesh");
        const std::array<std::size_t, 3> places = coordinate_places(element);
        mesh_.positions.reserve(std::min(element.count, numbers_.bytes_left()));
        for (std::size_t i = 0; i < element.count; ++i) {
            std::array<double, 3> at{};
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const auto k = std::ranges::find(places, p);
                if (k == places.end()) {
                    skip_property(numbers_, element.properties[p]);
                    continue;
                }
                const double value = numbers_.next(element.properties[p].type);
                if (!std::isfinite(value)) numbers_.fail("expected finite coordinates of vertex " + std::to_string(i));
                at[static_cast<std::size_t>(k - places.begin())] = value;
            }
            mesh_.positions.push_back({at[0], at[1], at[2]});
        }
    }

    void read_faces(const PlyElement& element) {
        const auto is_corners = [](const PlyProperty& p) {
            return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
        };
        const auto corners = std::ranges::find_if(element.properties, is_corners);
        if (corners == element.properties.end())
            throw InputError({options_.file_name}, "expected faces with a list vertex_indices, found none");
        if (element.count > options_.max_triangles) numbers_.fail_limit(options_.max_triangles, "triangles in a mesh");
        mesh_.triangles.reserve(std::min(element.count, numbers_.bytes_left()));
        for (std::size_t i = 0; i < element.count; ++i)
            for (auto property = element.properties.begin(); property != element.properties.end(); ++property)
                property == corners ? add_face(*property, i) : skip_property(numbers_, *property);
    }

    void add_face(const PlyProperty& property, std::size_t number) {
        const std::size_t count =
            next_count(numbers_, property.count_type, "the number of corners of face " + std::to_string(number));
        if (count < 3)
            numbers_.fail("expected at least three corners of face " + std::to_string(number) + ", found " +
                          std::to_string(count));
        if (count > options_.max_corners) numbers_.fail_limit(options_.max_corners, "corners in a face");
        std::vector<int> corners(count);
        for (int& corner : corners) {
            const std::size_t v = next_count(numbers_, property.type, "a vertex of face " + std::to_string(number));
            if (v >= mesh_.positions.size())
                numbers_.fail("face " + std::to_string(number) + " has vertex " + std::to_string(v) + ", but there are " +
                              std::to_string(mesh_.positions.size()) + ", counted from 0");
            corner = static_cast<int>(v);
        }
        for (const auto& triangle : split_polygon(mesh_.positions, corners)) mesh_.triangles.push_back(triangle);
        if (mesh_.triangles.size() > options_.max_triangles)
            numbers_.fail_limit(options_.max_triangles, "triangles in a mesh");
    }
};

}  // namespace

TriangleMesh read_ply(const std::string& text, const MeshReadOptions& options) {
    return PlyMeshReader(text, options).read();
}

}  // namespace rinceau

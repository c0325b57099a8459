#include "growth/mesh/ply_header.h"

#include <array>
#include <optional>
#include <utility>

#include "scene/input_error.h"

namespace rinceau {
namespace {

std::optional<PlyType> type_named(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{{"char", PlyType::int8},
                                                                          {"int8", PlyType::int8},
                                                                          {"uchar", PlyType::uint8},
                                                                          {"uint8", PlyType::uint8},
                                                                          {"short", PlyType::int16},
                                                                          {"int16", PlyType::int16},
                                                                          {"ushort", PlyType::uint16},
                                                                          {"uint16", PlyType::uint16},
                                                                          {"int", PlyType::int32},
                                                                          {"int32", PlyType::int32},
                                                                          {"uint", PlyType::uint32},
                                                                          {"uint32", PlyType::uint32},
                                                                          {"float", PlyType::float32},
                                                                          {"float32", PlyType::float32},
                                                                          {"double", PlyType::float64},
                                                                          {"float64", PlyType::float64}}};
    for (const auto& [known, type] : names)
        if (known == name) return type;
    return std::nullopt;
}

class HeaderReader {
  public:
    HeaderReader(std::string_view text, const MeshReadOptions& options) : text_(text), options_(options) {}

    PlyHeader read() {
        std::string_view rest = text_;
        std::string_view line = next(rest);
        if (take_word(line) != "ply") fail("expected a PLY file, which begins with the word ply");
        bool has_format = false;
        while (true) {
            if (rest.empty()) fail("expected end_header, found the end of the file");
            line = next(rest);
            const std::string_view kind = take_word(line);
            if (kind == "end_header") break;
            if (kind == "format") {
                header_.format = read_format(line);
                has_format = true;
            } else if (kind == "element") {
                header_.elements.push_back(read_element(line));
            } else if (kind == "property") {
                if (header_.elements.empty()) fail("a property before the first element");
                header_.elements.back().properties.push_back(read_property(line));
            } else if (!kind.empty() && kind != "comment" && kind != "obj_info") {
                fail("expected format, element, property, comment or end_header, found '" + shown(kind) + "'");
            }
        }
        if (!has_format) fail("expected a line 'format ascii 1.0' or the like in the header, found none");
        header_.bytes = text_.size() - rest.size();
        return std::move(header_);
    }

  private:
    std::string_view text_;
    const MeshReadOptions& options_;
    PlyHeader header_;

    static std::string shown(std::string_view word) { return std::string(word.substr(0, 40)); }
    [[noreturn]] void fail(const std::string& message) const {
        throw InputError({options_.file_name, header_.lines}, message);
    }
    std::string_view next(std::string_view& rest) {
        ++header_.lines;
        return take_line(rest);
    }
    PlyFormat read_format(std::string_view line) const {
        const std::string_view name = take_word(line), version = take_word(line);
        if (version != "1.0") fail("expected version 1.0 of the format, found '" + shown(version) + "'");
        if (name == "ascii") return PlyFormat::ascii;
        if (name == "binary_little_endian") return PlyFormat::little_endian;
        if (name == "binary_big_endian") return PlyFormat::big_endian;
        fail("expected the format ascii, binary_little_endian or binary_big_endian, found '" + shown(name) + "'");
    }
    PlyElement read_element(std::string_view line) const {
        PlyElement element{.name = std::string(take_word(line))};
        if (const std::string_view count = take_word(line); !reads_whole(count, element.count))
            fail("expected the number of elements '" + shown(element.name) + "', found '" + shown(count) + "'");
        return element;
    }
    PlyType read_type(std::string_view word) const {
        if (const auto type = type_named(word)) return *type;
        fail("expected a type such as float or uchar, found '" + shown(word) + "'");
    }
    PlyProperty read_property(std::string_view line) const {
        PlyProperty property;
        std::string_view word = take_word(line);
        if (word == "list") {
            property.is_list = true;
            property.count_type = read_type(take_word(line));
            word = take_word(line);
        }
        property.type = read_type(word);
        property.name = std::string(take_word(line));
        if (property.name.empty()) fail("expected the name of the property");
        return property;
    }
};

}  // namespace

std::size_t bytes_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::float64:
            return 8;
        default:
            return 4;
    }
}

PlyHeader read_ply_header(std::string_view text, const MeshReadOptions& options) {
    return HeaderReader(text, options).read();
}

}  // namespace rinceau

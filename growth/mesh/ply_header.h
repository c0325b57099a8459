#pragma once
// What a PLY file says of itself before its numbers.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "growth/mesh/mesh_read_options.h"

namespace rinceau {

enum class PlyType : unsigned char { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytes_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyFormat : unsigned char { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< up to the first byte behind end_header's line
    int lines = 0;
};

/// Throws InputError with the line.
PlyHeader read_ply_header(std::string_view text, const MeshReadOptions& options);

}  // namespace rinceau

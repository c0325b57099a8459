#pragma once
// A mesh of a file format from any bytes, and the surface that comes of it.

#include <string>

#include "growth/surface/surface_read.h"

namespace rinceau {

/// With repair: what is refused without it is cut apart.
inline void take_mesh(std::string_view bytes, const std::string& file_name) {
    constexpr std::size_t most = 20'000;  // positions and faces, for the time that a case takes
    read_surface(std::string(bytes), file_name,
                 {.repair = true, .mesh = {.file_name = {}, .max_positions = most, .max_triangles = most}});
}

}  // namespace rinceau

#include "growth/mesh/mesh_read.h"

#include "growth/mesh/mesh_obj_read.h"
#include "growth/mesh/mesh_off_read.h"
#include "growth/mesh/mesh_ply_read.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// In lower case, with its point; empty without one.
std::string ending_of(const std::string& name) {
    const std::size_t point = name.find_last_of('.');
    if (point == std::string::npos) return {};
    std::string ending = name.substr(point);
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

}  // namespace

bool is_mesh_name(const std::string& name) {
    const std::string ending = ending_of(name);
    return ending == ".obj" || ending == ".off" || ending == ".ply";
}

TriangleMesh read_mesh(const std::string& name, const std::string& text, MeshReadOptions options) {
    if (options.file_name.empty()) options.file_name = name;
    options.keep_numbers = true;
    const std::string ending = ending_of(name);
    if (ending == ".ply" || text.starts_with("ply\n") || text.starts_with("ply\r")) return read_ply(text, options);
    if (ending == ".off" || text.starts_with("OFF\n") || text.starts_with("OFF\r")) return read_off(text, options);
    if (ending == ".obj") return read_obj(text, options);
    throw InputError({options.file_name}, "expected a mesh as .obj, .off or .ply");
}

}  // namespace rinceau

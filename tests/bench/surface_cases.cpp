#include "surface_cases.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "growth/mesh/mesh_read.h"
#include "growth/surface/surface_read.h"

namespace rinceau::test {

std::string file_text(const std::string& name) {
    std::ifstream in(name, std::ios::binary);
    if (!in) throw std::runtime_error(name + " cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

namespace {

MeshCase read_case(const std::filesystem::path& file, bool own) {
    MeshCase one{.name = file.stem().string(), .own = own};
    try {
        one.surface = std::make_shared<const SurfaceMesh>(read_surface(file_text(file.string()), file.string()).surface);
    } catch (const InputError& error) {
        one.refusal = error.what();
    }
    return one;
}

void add_folder(std::vector<MeshCase>& cases, const std::string& folder, bool own) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (is_mesh_name(entry.path().string())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files) cases.push_back(read_case(file, own));
}

}  // namespace

std::vector<MeshCase> mesh_cases(const SurfaceBenchOptions& options) {
    std::vector<MeshCase> cases;
    add_folder(cases, RINCEAU_SAMPLES "/surface", true);
    if (!options.meshes.empty()) add_folder(cases, options.meshes, false);
    return cases;
}

}  // namespace rinceau::test

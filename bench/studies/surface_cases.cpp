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

SurfaceReading reading_of(const std::filesystem::path& file, bool repair) {
    return read_surface(file_text(file.string()), file.string(), {.repair = repair});
}

MeshCase read_case(const std::filesystem::path& file, bool own) {
    MeshCase one;
    one.name = file.stem().string();
    one.own = own;
    const auto keep = [&](SurfaceReading reading, std::shared_ptr<const SurfaceMesh>& to) {
        one.warnings = std::move(reading.warnings);
        to = std::make_shared<const SurfaceMesh>(std::move(reading.surface));
    };
    const std::clock_t begin = std::clock();
    try {
        keep(reading_of(file, false), one.surface);
    } catch (const InputError& error) {
        one.refusal = error.what();
    }
    one.seconds = processor_seconds(begin);
    if (one.surface) return one;
    try {
        keep(reading_of(file, true), one.repaired);
    } catch (const InputError&) {
        one.repaired = nullptr;  // the refusal has said it
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

// Everything that docs/growth.md promises of patterns on surfaces, measured: figures with their bars, and a row for each of
// the paper's patterns on each mesh. Exit status 1 if a bar is missed.
// Usage: surface_bench [MESHES_FOLDER] [--csv] [--only PART] [--pictures FOLDER]
// PART: meshes, polar map, fields, walks, collision, outlines, sizes, patterns, drawings

#include "surface_bench.h"

#include <exception>

#include "surface_cases.h"

using namespace rinceau::test;

namespace {

SurfaceBenchOptions options_of(const std::vector<std::string>& arguments) {
    SurfaceBenchOptions options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        const bool value = i + 1 < arguments.size();
        if (argument == "--csv") {
            options.csv = true;
        } else if (argument == "--only" && value) {
            options.only = arguments[++i];
        } else if (argument == "--pictures" && value) {
            options.pictures = arguments[++i];
        } else {
            options.meshes = argument;
        }
    }
    return options;
}

}  // namespace

int main(int count, char** values) try {
    const SurfaceBenchOptions options = options_of({values + 1, values + count});
    GrowthLines lines(options.csv);
    const std::vector<MeshCase> meshes = mesh_cases(options);
    mesh_rows(lines, options, meshes);
    polar_map_lines(lines, options);
    field_lines(lines, options, meshes);
    walk_lines(lines, options, meshes);
    collision_lines(lines, options);
    laying_lines(lines, options, meshes);
    size_lines(lines, options, meshes);
    pattern_rows(lines, options, meshes);
    drawing_rows(lines, options, meshes);
    if (!options.csv) std::cout << '\n' << lines.judgements() << " bars, " << lines.failures() << " failures\n";
    return lines.failures() == 0 ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
}

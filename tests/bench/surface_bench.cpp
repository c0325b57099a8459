// Everything that docs/growth.md promises of patterns on surfaces, measured: figures with their bars, and a row for each of
// the paper's patterns on each mesh. Exit status 1 if a bar is missed.
// Usage: surface_bench [MESHES_FOLDER] [--csv] [--only NAME] [--pictures FOLDER]

#include "surface_bench.h"

#include <exception>

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
    polar_map_lines(lines, options);
    field_lines(lines, options);
    walk_lines(lines, options);
    collision_lines(lines, options);
    laying_lines(lines, options);
    pattern_rows(lines, options);
    if (!options.csv) std::cout << '\n' << lines.judgements() << " bars, " << lines.failures() << " failures\n";
    return lines.failures() == 0 ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
}

// A row for each of the paper's patterns on each mesh (bars: docs/growth.md, "Patterns on surfaces").

#include <filesystem>
#include <optional>

#include "growth/surface/derive_shapes.h"
#include "growth/surface/measure_pattern.h"
#include "growth/surface/parse_shape_grammar.h"
#include "growth/surface/surface_world.h"
#include "surface_bench.h"
#include "surface_cases.h"

namespace rinceau::test {
namespace {

constexpr double degrees_mean = 0.1;     // of the angle to the field
constexpr double surface_share = 1e-6;   // of the diagonal
constexpr double in_degrees = 180 / pi;

/// A row of the paper's table 1.
struct PaperRow {
    const char* figure;
    int faces_in;
    double faces_out, seconds;
};

struct PatternCase {
    std::string file;  ///< in samples/surface, without its ending
    std::string meshes;  ///< names apart by blanks; empty = all; "plane" = the plane
    double most_seconds;
    std::optional<PaperRow> paper;
};

/// Seconds at most: those of docs/growth.md where it names the pattern, else the paper's.
const std::vector<PatternCase>& pattern_cases() {
    static const std::vector<PatternCase> cases{
        {"vine", "torus", 0.5, PaperRow{"13 a", 9600, 568e3, 0.5}},
        {"vine", "", 1, PaperRow{"13 b", 12000, 352e3, 1}},
        {"stars", "", 9, PaperRow{"14 a", 1280, 739e3, 9}},
        {"cracks", "", 15, PaperRow{"15 a", 1280, 265e3, 15}},
        {"radial", "", 1, PaperRow{"15 b", 12000, 867e3, 1}},
        {"tree", "vase", 13, PaperRow{"15 c", 2748, 483e3, 13}},
        {"tiles", "", 10, PaperRow{"16 a", 23242, 1.2e6, 10}},
        {"rings_a", "three_rings", 12, std::nullopt},
        {"rings_b", "three_rings", 12, PaperRow{"17", 40000, 4e6, 12}},
        {"places", "cub vase blob torus", 3, PaperRow{"19", 8704, 134e3, 3}},
        {"glyphs", "", 10, std::nullopt},
    };
    return cases;
}

// Which meshes are surfaces: each loads, or is refused with reason and place and loads repaired.

#include "surface_bench.h"
#include "surface_cases.h"
#include "surface_table.h"

namespace rinceau::test {
namespace {

/// A refusal names a face, an edge or a vertex, with its place in space.
bool names_a_place(const std::string& refusal) {
    const std::size_t first = refusal.find("The first: ");
    return first != std::string::npos && refusal.find(" at (", first) != std::string::npos;
}

/// Without the file's name, and without what comes behind the first place.
std::string shortened(const std::string& refusal) {
    const std::size_t begin = refusal.find(": ");
    const std::string reason = begin == std::string::npos ? refusal : refusal.substr(begin + 2);
    return reason.substr(0, reason.find(';'));
}

std::string said_of(const MeshCase& one) {
    std::string said = one.refusal.empty() ? "" : "refused: " + shortened(one.refusal) + "; repaired:";
    for (const Warning& warning : one.warnings) said += (said.empty() ? "" : " ") + warning.message + ";";
    return said;
}

}  // namespace

void mesh_rows(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes) {
    if (!options.wants("meshes")) return;
    if (!options.csv) std::cout << "\nmeshes (seconds of the processor to read, check and build, or to refuse)\n";
    const RowPrinter rows(options.csv, {"mesh", "faces", "vertices", "Euler", "border", "seconds", "verdict"},
                          {16, 7, 8, 6, 7, 8});
    for (const MeshCase& one : meshes) {
        const SurfaceMesh* surface = one.surface ? one.surface.get() : one.repaired.get();
        const bool good = surface != nullptr && (one.surface || names_a_place(one.refusal));
        lines.count(good);
        const auto text = [&](int number) { return std::to_string(number); };
        const std::string verdict = (good ? "pass" : "FAIL") + std::string(one.surface ? ", loads " : " ") + said_of(one);
        if (surface == nullptr) {
            rows.print({one.name, "-", "-", "-", "-", short_text(one.seconds), verdict});
        } else {
            rows.print({one.name, text(surface->faces()), text(surface->vertices()), text(euler_characteristic(*surface)),
                        text(surface->border_edges), short_text(one.seconds), verdict});
        }
    }
}

}  // namespace rinceau::test

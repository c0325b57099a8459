// Arrangements (Ijiri et al. 2008) and aggregates (Sakurai & Miyata 2014).

#include <cmath>

#include "analyzer/analyze.h"
#include "growth/aggregate/fill_aggregate.h"
#include "growth/arrangement/grow_arrangement.h"
#include "growth/figures.h"
#include "made_inputs.h"
#include "scene/painted_region.h"
#include "scene/svg_read.h"
#include "sizes.h"

namespace rinceau::bench {
namespace {

std::string sample(const std::string& name) { return RINCEAU_SAMPLES "/growth/" + name; }

Exemplar exemplar_of(const std::string& name) {
    const Scene scene = read_svg(content_of(sample(name)), {.file_name = name}).scene;
    return make_exemplar(figures_of(analyze(scene).grammar), {}, name);
}

/// Grown to so many elements on one thread, relaxed and, where the exemplar is irregular, finished.
void arrangement(benchmark::State& state, const std::string& name) {
    const Exemplar exemplar = exemplar_of(name);
    const GrowOrder order{.count = static_cast<std::size_t>(size_of(state))};
    std::size_t elements = 0;
    for (auto _ : state) {
        ElementArrangement grown = with_seed(empty_arrangement(exemplar, {.threads = 1}), exemplar, {}, {});
        grown = grow(std::move(grown), exemplar, {}, order);
        elements = finished(std::move(grown), exemplar, {}, order).elements;
    }
    set_size(state, elements);
}
BENCHMARK_CAPTURE(arrangement, lattice, "bricks.svg")->Apply(to_100000);
BENCHMARK_CAPTURE(arrangement, irregular, "stones.svg")->Apply(to_10000);

ExclusiveRegion region_of(const std::string& name) {
    const Scene scene = read_svg(content_of(sample(name)), {.file_name = name}).scene;
    const double deviation = 1e-3 * drawing_diagonal(scene);
    Region outline;
    for (const Element& element : scene.elements) outline = union_of(outline, painted_region(element, deviation));
    return exclusive_region(outline, {}, name);
}

/// A square for about so many of the three toys.
void aggregate(benchmark::State& state, PackMethod method) {
    std::vector<ExclusiveRegion> regions;
    double area = 0;
    for (const char* name : {"toy_plane.svg", "toy_dinosaur.svg", "toy_caterpillar.svg"}) {
        regions.push_back(region_of(name));
        area += regions.back().area / 3;
    }
    constexpr double coverage = 0.45;  // what settle reaches with them, nearly
    const double side = std::sqrt(size_of(state) * area / coverage);
    const PackDomain domain{{{0, 0}, {side, side}}, {}, false};
    std::size_t placed = 0;
    for (auto _ : state) placed = fill_aggregate(regions, domain, {.method = method}, "toys").placed.size();
    set_size(state, placed);
}
BENCHMARK_CAPTURE(aggregate, settle, PackMethod::settle)->Apply(to_10000);
BENCHMARK_CAPTURE(aggregate, gaps, PackMethod::gaps)->Apply(to_10000);

}  // namespace
}  // namespace rinceau::bench

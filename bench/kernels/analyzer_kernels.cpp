// The stations of the analysis, one by one (Stava et al. 2010, sections 4 and 5; docs/analysis.md).

#include "analyzer/analyze.h"
#include "analyzer/cluster_table.h"
#include "analyzer/generate_rules.h"
#include "analyzer/moments.h"
#include "analyzer/spaces_report.h"
#include "made_inputs.h"
#include "sizes.h"

namespace rinceau::bench {
namespace {

constexpr SimilarityOptions on_one_thread{.threads = 1};

/// What elements are compared by.
void outline_signatures(benchmark::State& state) {
    const Scene scene = drawn(clutter_text(size_of(state)));
    for (auto _ : state) {
        for (const Element& element : scene.elements)
            benchmark::DoNotOptimize(describe(outline_of(element.paths, element.style)));
    }
    set_size(state, scene.elements.size());
}
BENCHMARK(outline_signatures)->Apply(to_100000);

void similar_elements(benchmark::State& state, std::string (*text)(int)) {
    const Scene scene = drawn(text(size_of(state)));
    for (auto _ : state) benchmark::DoNotOptimize(group_similar_elements(scene, on_one_thread));
    set_size(state, scene.elements.size());
}
BENCHMARK_CAPTURE(similar_elements, ornament, ornament_text)->Apply(to_100000);
BENCHMARK_CAPTURE(similar_elements, clutter, clutter_text)->Apply(to_100000);

void transformation_spaces(benchmark::State& state, std::string (*text)(int)) {
    const Instancing instancing = group_similar_elements(drawn(text(size_of(state))), on_one_thread);
    for (auto _ : state) benchmark::DoNotOptimize(fill_transformation_spaces(instancing));
    set_size(state, instancing.instances.size());
}
BENCHMARK_CAPTURE(transformation_spaces, ornament, ornament_text)->Apply(to_100000);
BENCHMARK_CAPTURE(transformation_spaces, clutter, clutter_text)->Apply(to_100000);

/// Clusters of all spaces of a drawing of so many elements; a program shows those of at most 60,000 points.
void clusters_in_spaces(benchmark::State& state, std::string (*text)(int)) {
    const Instancing instancing = group_similar_elements(drawn(text(size_of(state))), on_one_thread);
    const std::vector<TransformationSpace> spaces = fill_transformation_spaces(instancing);
    for (auto _ : state) benchmark::DoNotOptimize(cluster_spaces(spaces));
    std::size_t points = 0;
    for (const TransformationSpace& space : spaces) points += space.points.size();
    set_size(state, points);
}
BENCHMARK_CAPTURE(clusters_in_spaces, ornament, ornament_text)->Apply(to_10000);
BENCHMARK_CAPTURE(clusters_in_spaces, clutter, clutter_text)->Apply(to_10000);

/// The paper's importance function over all clusters that are shown.
void cluster_importance(benchmark::State& state) {
    const Scene scene = drawn(ornament_text(size_of(state)));
    const Instancing instancing = group_similar_elements(scene, on_one_thread);
    const std::vector<std::string> names(instancing.looks.size(), "A");
    const double diagonal = drawing_diagonal(scene);
    for (auto _ : state)
        benchmark::DoNotOptimize(ranked_clusters(cluster_table(instancing, names, diagonal), ImportanceWeights{}));
    set_size(state, scene.elements.size());
}
BENCHMARK(cluster_importance)->Apply(to_100000);

/// Choosing rules until nothing saves bits, at one tolerance, from below.
void rule_choice(benchmark::State& state, std::string (*text)(int)) {
    const Scene scene = drawn(text(size_of(state)));
    const Instancing instancing = group_similar_elements(scene, on_one_thread);
    const SearchState start = starting_state(instancing, {}, drawing_diagonal(scene));
    for (auto _ : state) benchmark::DoNotOptimize(generate_rules(start, {}));
    set_size(state, scene.elements.size());
}
BENCHMARK_CAPTURE(rule_choice, ornament, ornament_text)->Apply(to_100000);
BENCHMARK_CAPTURE(rule_choice, clutter, clutter_text)->Apply(to_100000);

/// All stations, with the proof, on one thread.
void whole_analysis(benchmark::State& state, std::string (*text)(int)) {
    const Scene scene = drawn(text(size_of(state)));
    const AnalyzeOptions options{.similarity = on_one_thread, .threads = 1};
    for (auto _ : state) benchmark::DoNotOptimize(analyze(scene, options));
    set_size(state, scene.elements.size());
}
BENCHMARK_CAPTURE(whole_analysis, ornament, ornament_text)->Apply(to_10000);
BENCHMARK_CAPTURE(whole_analysis, clutter, clutter_text)->Apply(to_10000);

}  // namespace
}  // namespace rinceau::bench

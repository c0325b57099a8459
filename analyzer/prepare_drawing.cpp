#include "analyzer/prepare_drawing.h"

#include <algorithm>
#include <chrono>

#include "analyzer/shape_looks.h"
#include "geometry/parallel.h"
#include "scene/input_error.h"

namespace rinceau {

namespace {

constexpr std::size_t most_elements = 5'000'000;
constexpr double outline_share = 1e-4;  // of the diagonal: copies may differ from their terminal by this

/// Tried in turn unless the user names one, in element sizes (docs/analysis.md, 9).
constexpr double tolerance_ladder[] = {0.01, 0.003, 0.03};

std::vector<double> tolerances(const AnalyzeOptions& options, std::size_t elements) {
    if (options.tolerance > 0) return {options.tolerance};
    // Large drawings are made by machines: the loosest tolerance is left out there.
    constexpr std::size_t large = 3000;
    return {std::begin(tolerance_ladder), std::end(tolerance_ladder) - (elements > large ? 1 : 0)};
}

/// The elements as looks and poses, as far as wishes leave that open; sets the scene that is meant.
Instancing grouped(PreparedDrawing& prepared, const AnalyzeOptions& options, const Progress& progress) {
    SimilarityOptions similarity = options.similarity;
    similarity.tolerance_of_diagonal = std::min(similarity.tolerance_of_diagonal, outline_share);
    similarity.threads = options.threads;
    Instancing found = group_similar_elements(*prepared.scene, similarity, progress);
    const std::vector<GroupingWish> wishes = effective_wishes(options.grouping);
    if (std::ranges::any_of(wishes, [](const GroupingWish& wish) { return wish.kind == GroupingKind::together; })) {
        const Scene& drawn = *prepared.scene;
        Scene meant = with_merged_elements(drawn, std::move(found), wishes);
        for (std::size_t e = 0; e < drawn.elements.size(); ++e)
            prepared.redrawn += drawn.elements[e].paths != meant.elements[e].paths;
        prepared.meant = std::make_shared<const Scene>(std::move(meant));
        prepared.scene = prepared.meant.get();
        found = group_similar_elements(*prepared.scene, similarity, progress);
    }
    if (!wishes.empty()) found = with_split_looks(std::move(found), wishes);
    return options.alone.empty() ? found : with_lone_elements(std::move(found), *prepared.scene, options.alone);
}

}  // namespace

PreparedDrawing prepare_drawing(const Scene& scene, const AnalyzeOptions& options, const Progress& progress) {
    if (scene.elements.size() > most_elements) {
        throw LimitError({}, "the drawing has " + std::to_string(scene.elements.size()) + " elements; at most " +
                                 std::to_string(most_elements) + " can be analysed: split the drawing");
    }
    const auto begin = std::chrono::steady_clock::now();
    report(progress, "similarity", 0);
    PreparedDrawing prepared;
    prepared.scene = &scene;
    prepared.diagonal = drawing_diagonal(scene);
    // Which elements are copies of which.
    prepared.readings.push_back({grouped(prepared, options, progress)});
    if (auto by_shape = merged_by_shape(prepared.readings.front().instancing, prepared.diagonal))
        prepared.readings.push_back({std::move(*by_shape)});
    // Which of them lie on which.
    OverlapOptions visible_only;
    visible_only.antialiasing = false;
    visible_only.threads = options.threads;
    prepared.overlaps = find_overlaps(*prepared.scene, visible_only, progress);
    // Items and what they cost, at each tolerance.
    const std::vector<double> tried = tolerances(options, scene.elements.size());
    for (PreparedReading& reading : prepared.readings) reading.starts.resize(tried.size());
    for_each_index(prepared.readings.size() * tried.size(), options.threads, "items", progress,
                   [&](std::size_t k, const Progress&) {
                       PreparedReading& reading = prepared.readings[k / tried.size()];
                       const double size = tried[k % tried.size()];
                       const PoseTolerance tolerance{size, size, PoseTolerance{}.per_distance};
                       reading.starts[k % tried.size()] = starting_state(reading.instancing, tolerance, prepared.diagonal);
                   });
    prepared.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return prepared;
}

}  // namespace rinceau

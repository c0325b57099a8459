#include "editor/effects/analysis_jobs.h"

#include <chrono>
#include <utility>

#include "analyzer/analyze.h"
#include "analyzer/symbol_names.h"
#include "editor/effects/guarded.h"
#include "editor/effects/progress_posts.h"

namespace rinceau {

Worker::Job analysis_job(RunAnalysis request, std::shared_ptr<AnalysisCache> cache) {
    return [request = std::move(request), cache = std::move(cache)](const Progress& progress, const Worker::Post& post) {
        ProgressPosts posts;
        const Progress told = [&](std::string_view stage, double fraction) {
            progress(stage, fraction);
            if (posts.worth(stage, std::chrono::steady_clock::now()))
                post(AnalysisAction{AnalysisProgress{request.job, std::string(stage), fraction}});
        };
        const auto work = [&] {
            const auto kept = cache->prepared(request.drawing, request.options, told);
            auto found = std::make_shared<const Analysis>(analyze(kept->prepared, request.options, told));
            post(AnalysisAction{AnalysisDone{request.job, std::move(found)}});
        };
        guarded(work, [&](std::string message) { post(AnalysisAction{AnalysisFailed{request.job, std::move(message)}}); });
    };
}

Worker::Job clusters_job(TabulateClusters request, std::shared_ptr<AnalysisCache> cache) {
    return [request = std::move(request), cache = std::move(cache)](const Progress& progress, const Worker::Post& post) {
        const auto work = [&] {
            const auto kept = cache->prepared(request.drawing, request.options, progress);
            const PreparedDrawing& prepared = kept->prepared;
            const Instancing& instancing = prepared.readings.front().instancing;
            auto found = std::make_shared<const DrawingClusters>(DrawingClusters{
                request.drawing, request.options,
                cluster_table(instancing, look_names(instancing, *prepared.scene), prepared.diagonal, {}, progress)});
            post(AnalysisAction{ClustersFound{request.job, std::move(found)}});
        };
        guarded(work, [&](std::string message) { post(AnalysisAction{ClustersFailed{request.job, std::move(message)}}); });
    };
}

Worker::Job mapping_job(MapElements request) {
    return [request = std::move(request)](const Progress& progress, const Worker::Post& post) {
        const auto work = [&] {
            ElementItems items = items_of_elements(request.picture, *request.drawing, progress);
            post(AnalysisAction{ElementsMapped{std::make_shared<const ElementItems>(std::move(items)), {}}});
        };
        guarded(work, [&](std::string message) { post(AnalysisAction{ElementsMapped{nullptr, std::move(message)}}); });
    };
}

}  // namespace rinceau

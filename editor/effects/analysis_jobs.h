#pragma once
// What the threads of the analysis do.

#include <memory>

#include "editor/effects/analysis_cache.h"
#include "editor/effects/worker.h"
#include "editor/model/request.h"

namespace rinceau {

/// Posts AnalysisProgress, then AnalysisDone or AnalysisFailed.
Worker::Job analysis_job(RunAnalysis request, std::shared_ptr<AnalysisCache> cache);

/// Posts ClustersFound or ClustersFailed.
Worker::Job clusters_job(TabulateClusters request, std::shared_ptr<AnalysisCache> cache);

/// Posts ElementsMapped.
Worker::Job mapping_job(MapElements request);

}  // namespace rinceau

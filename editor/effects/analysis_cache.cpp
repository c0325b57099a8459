#include "editor/effects/analysis_cache.h"

#include "editor/model/document.h"

namespace rinceau {
namespace {

/// Do weights and objective, of no account for what is prepared, make all the difference?
bool same_preparation(const AnalyzeOptions& a, AnalyzeOptions b) {
    b.weights = a.weights;
    b.objective = a.objective;
    b.symmetrize = a.symmetrize;
    b.stochastic = a.stochastic;
    return same_analysis(a, b);
}

}  // namespace

std::shared_ptr<const KeptDrawing> AnalysisCache::prepared(const std::shared_ptr<const Scene>& drawing,
                                                           const AnalyzeOptions& options, const Progress& progress) {
    std::shared_ptr<const KeptDrawing> kept;
    {
        const std::lock_guard lock(mutex_);
        kept = kept_;
    }
    if (kept && kept->drawing == drawing && same_preparation(kept->options, options)) return kept;
    kept = std::make_shared<const KeptDrawing>(KeptDrawing{drawing, options, prepare_drawing(*drawing, options, progress)});
    const std::lock_guard lock(mutex_);
    kept_ = kept;
    return kept;
}

}  // namespace rinceau

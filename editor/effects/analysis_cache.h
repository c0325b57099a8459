#pragma once
// What analyses of one drawing have in common, kept so that another one with other weights is quick.

#include <memory>
#include <mutex>

#include "analyzer/analyze.h"
#include "geometry/progress.h"

namespace rinceau {

/// A drawing that was prepared, and the scene that it points to.
struct KeptDrawing {
    std::shared_ptr<const Scene> drawing;
    AnalyzeOptions options;  ///< that it was prepared with
    PreparedDrawing prepared;
};

/// Holds the drawing that was prepared last. May be used by several threads.
class AnalysisCache {
  public:
    /// The drawing as analyze() and the table of clusters need it; prepared if it is not at hand. Throws as
    /// prepare_drawing(), and what `progress` throws.
    std::shared_ptr<const KeptDrawing> prepared(const std::shared_ptr<const Scene>& drawing, const AnalyzeOptions& options,
                                                const Progress& progress);

  private:
    std::mutex mutex_;
    std::shared_ptr<const KeptDrawing> kept_;
};

}  // namespace rinceau

#pragma once
// Fulfils what update() asks for.

#include <atomic>
#include <functional>
#include <memory>

#include "editor/effects/action_queue.h"
#include "editor/effects/analysis_cache.h"
#include "editor/effects/file_effects.h"
#include "editor/effects/worker.h"
#include "editor/model/request.h"

namespace rinceau {

class SurroundingsCache;  // growth_jobs.h

/// Pictures that were quick to derive are derived at once, so that a drag is seen in the same frame; the others, files and
/// analyses on threads. Answers come through the queue. Never throws.
class Effects {
  public:
    /// `folders` is where the program keeps what is its own; without them it keeps nothing.
    explicit Effects(ActionQueue& answers, const KeptFolders& folders = {});

    void fulfil(const Request& request);
    bool wants_to_close() const { return closing_; }

  private:
    void one(const DerivePicture& request);
    void one(const FindSelection& request);
    void one(const CheckText& request);
    void one(const MeasureDepth& request);
    void one(const LightRule& request);
    void one(const DeriveBefore& request);
    void one(const RunAnalysis& request);
    void one(const StopAnalysis& request);
    void one(const RunTool& request);
    void one(const ReadReplacement& request);
    void one(const TabulateClusters& request);
    void one(const MapElements& request);
    void one(const ReadSource& request);
    void one(const GrowArrangement& request);
    void one(const FillPattern& request);
    void one(const MakeGrownDocument& request);
    void one(const EndGrowth& request);
    void one(const ReadMesh& request);
    void one(const DesignField& request);
    void one(const GrowOnSurface& request);
    void one(const EndSurface& request);
    void one(const WriteSurface& request);
    void one(const CloseWindow& request);

    /// For growth that begins now; the growth before ends.
    std::shared_ptr<std::atomic<bool>> begin_growth();

    ActionQueue& answers_;
    Worker::Post post_;  ///< to the answers, from any thread
    Worker replacements_{post_};
    Worker pictures_{post_};
    Worker selections_{post_};
    Worker texts_{post_};
    Worker depths_{post_};
    Worker lights_{post_};
    Worker befores_{post_};
    std::shared_ptr<AnalysisCache> prepared_ = std::make_shared<AnalysisCache>();
    Worker analyses_{post_};
    Worker tools_{post_};
    Worker clusters_{post_};
    Worker maps_{post_};
    Worker sources_{post_};
    std::shared_ptr<SurroundingsCache> surroundings_;
    std::shared_ptr<std::atomic<bool>> growth_stop_ = std::make_shared<std::atomic<bool>>(false);
    Worker growth_{post_};
    Worker meshes_{post_};
    Worker fields_{post_};
    std::shared_ptr<std::atomic<bool>> surface_stop_ = std::make_shared<std::atomic<bool>>(false);
    Worker surfaces_{post_};
    Worker surface_files_{post_};
    bool closing_ = false;
    FileEffects files_;  ///< last: waits for what is to be written while all else is still there
};

}  // namespace rinceau

#pragma once
// Fulfils what update() asks for.

#include <functional>
#include <memory>

#include "editor/effects/action_queue.h"
#include "editor/effects/analysis_cache.h"
#include "editor/effects/worker.h"
#include "editor/model/request.h"

namespace rinceau {

/// Pictures that were quick to derive are derived at once, so that a drag is seen in the same frame; the others, files and
/// analyses on threads. Answers come through the queue. Never throws.
class Effects {
  public:
    explicit Effects(ActionQueue& answers);

    void fulfil(const Request& request);
    bool wants_to_close() const { return closing_; }

  private:
    void one(const ReadDocument& request);
    void one(const WriteDocument& request);
    void one(const WriteExport& request);
    void one(const DerivePicture& request);
    void one(const FindSelection& request);
    void one(const RunAnalysis& request);
    void one(const StopAnalysis& request);
    void one(const RunTool& request);
    void one(const ReadReplacement& request);
    void one(const CloseWindow& request);

    ActionQueue& answers_;
    Worker files_;
    Worker pictures_;
    Worker selections_;
    std::shared_ptr<AnalysisCache> prepared_ = std::make_shared<AnalysisCache>();
    Worker analyses_;
    Worker tools_;
    bool closing_ = false;
};

}  // namespace rinceau

#pragma once
// What the threads of growth do.

#include <atomic>
#include <memory>
#include <mutex>

#include "editor/effects/worker.h"
#include "editor/model/arrange_order.h"
#include "editor/model/fill_order.h"
#include "editor/model/request.h"

namespace rinceau {

/// Set when growth is to end with what stands.
using GrowthStop = std::shared_ptr<std::atomic<bool>>;

/// The flow and the boundary of the order before, for one that has the same strokes: a spray gives an order with every step
/// of the mouse. May be used by several threads.
class SurroundingsCache {
  public:
    /// Throws as surroundings_of().
    ArrangeSurroundings surroundings(const ArrangeOrder& order);

  private:
    std::mutex mutex_;
    ArrangeOrder order_;  ///< that `kept_` was made for, without its steps and what it goes on from
    ArrangeSurroundings kept_;
};

/// Posts SourceRead.
Worker::Job source_job(ReadSource request);

/// Post GrowthProgress and PatternGrown now and then, then PatternGrown{.done} or GrowthFailed.
Worker::Job arrange_job(GrowArrangement request, std::shared_ptr<SurroundingsCache> cache, GrowthStop stop);
Worker::Job fill_job(FillPattern request, GrowthStop stop);

/// Posts GrownDocumentMade or GrowthFailed.
Worker::Job grown_document_job(MakeGrownDocument request);

}  // namespace rinceau

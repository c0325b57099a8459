#pragma once
// Actions from other threads, drained once a frame.

#include <functional>
#include <mutex>
#include <utility>

#include "editor/model/action.h"

namespace rinceau {

class ActionQueue {
  public:
    /// `wake` tells the main thread that there is something; callable from any thread.
    explicit ActionQueue(std::function<void()> wake) : wake_(std::move(wake)) {}

    void post(Action action) {
        {
            const std::lock_guard lock(mutex_);
            actions_.push_back(std::move(action));
        }
        wake_();
    }
    Actions drain() {
        const std::lock_guard lock(mutex_);
        return std::exchange(actions_, {});
    }

  private:
    std::function<void()> wake_;
    std::mutex mutex_;
    Actions actions_;
};

}  // namespace rinceau

#pragma once
// One thread for long work of one kind: the newest job wins.

#include <functional>
#include <mutex>
#include <thread>

#include "editor/model/action.h"
#include "geometry/progress.h"

namespace rinceau {

/// Runs one job at a time. A new job stops the one before it; what that would have answered is dropped.
class Worker {
  public:
    /// Gives an action to the main thread. Called from the worker's thread.
    using Post = std::function<void(Action)>;
    /// Does the work and posts its answers; `progress` throws JobCancelled when the job is stopped.
    using Job = std::function<void(const Progress& progress, const Post& post)>;

    /// `post` must be callable until the worker is destroyed.
    explicit Worker(Post post);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void start(Job job);
    /// The running job posts nothing more, but for `on_stop` if one is given.
    void stop();

  private:
    Post post_;
    std::jthread thread_;
};

/// Thrown by a job's progress when it is stopped. Not of the core: it passes through it.
struct JobCancelled {};

}  // namespace rinceau

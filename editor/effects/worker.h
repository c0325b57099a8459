#pragma once
// One thread for long work of one kind: the newest job wins.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "editor/model/action.h"
#include "geometry/progress.h"

namespace rinceau {

/// Runs one job at a time. A new job stops the one before it, and begins when that has ended; of those that wait, only the
/// newest is run. A job that is stopped answers nothing more.
class Worker {
  public:
    /// Gives an action to the main thread. Called from the worker's thread.
    using Post = std::function<void(Action)>;
    /// Does the work and posts its answers; `progress` throws JobCancelled when the job is stopped.
    using Job = std::function<void(const Progress& progress, const Post& post)>;

    /// `post` must be callable until the worker is destroyed, and must not call the worker.
    explicit Worker(Post post);
    /// Stops, and waits until the running job has looked at its progress.
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Returns at once.
    void start(Job job);
    /// Returns at once: afterwards nothing more is posted, though the job may run until it next looks at its progress.
    void stop();
    /// Waits at most so long; true if then no job runs or waits.
    bool idle_within(double seconds);

  private:
    void serve(const std::stop_token& stop);

    Post post_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Job> next_;
    std::stop_source running_;  ///< of the job that runs
    bool busy_ = false;
    std::jthread thread_;  ///< last: it uses all the others
};

/// Thrown by a job's progress when it is stopped. Not of the core: it passes through it.
struct JobCancelled {};

}  // namespace rinceau

#pragma once
// A thread for work that must be done: writing files, listing folders.

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace rinceau {

/// Runs tasks one after the other in the order in which they were given. None is dropped: the destructor waits for all.
class Errands {
  public:
    using Task = std::function<void()>;

    Errands();
    ~Errands();
    Errands(const Errands&) = delete;
    Errands& operator=(const Errands&) = delete;

    /// The task must not throw.
    void run(Task task);

  private:
    void work();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Task> tasks_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace rinceau

#include "editor/effects/worker.h"

#include <chrono>
#include <utility>

namespace rinceau {

Worker::Worker(Post post) : post_(std::move(post)), thread_([this](const std::stop_token& token) { serve(token); }) {}

Worker::~Worker() { stop(); }

void Worker::start(Job job) {
    const std::lock_guard lock(mutex_);
    running_.request_stop();
    next_ = std::move(job);
    changed_.notify_all();
}

void Worker::stop() {
    const std::lock_guard lock(mutex_);
    running_.request_stop();
    next_.reset();
}

bool Worker::idle_within(double seconds) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return !busy_ && !next_; });
}

void Worker::serve(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return next_.has_value(); }) && !stop.stop_requested()) {
        const Job job = *std::exchange(next_, std::nullopt);
        running_ = std::stop_source();
        const std::stop_token stopped = running_.get_token();
        busy_ = true;
        lock.unlock();
        const Progress progress = [&](std::string_view, double) {
            if (stopped.stop_requested()) throw JobCancelled{};
        };
        const Post unless_stopped = [&](Action action) {
            const std::lock_guard posting(mutex_);  // so that nothing slips through while it is stopped
            if (!stopped.stop_requested()) post_(std::move(action));
        };
        try {
            job(progress, unless_stopped);
        } catch (const JobCancelled&) {  // whoever stopped it knows
        }
        lock.lock();
        busy_ = false;
        changed_.notify_all();
    }
}

}  // namespace rinceau

#include "editor/effects/worker.h"

#include <memory>
#include <utility>
#include <vector>

namespace rinceau {

namespace {

void run(const std::stop_token& stop, const Worker::Job& job, const Worker::Post& post) {
    const Progress progress = [&](std::string_view, double) {
        if (stop.stop_requested()) throw JobCancelled{};
    };
    const Worker::Post unless_stopped = [&](Action action) {
        if (!stop.stop_requested()) post(std::move(action));
    };
    try {
        job(progress, unless_stopped);
    } catch (const JobCancelled&) {  // whoever stopped it knows
    }
}

}  // namespace

Worker::Worker(Post post) : post_(std::move(post)) {}

Worker::~Worker() = default;

void Worker::start(Job job) {
    stop();
    thread_ = std::jthread([job = std::move(job), post = post_](const std::stop_token& token) { run(token, job, post); });
}

void Worker::stop() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

}  // namespace rinceau

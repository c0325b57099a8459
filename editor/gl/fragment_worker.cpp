#include "editor/gl/fragment_worker.h"

#include <algorithm>

namespace rinceau {

FragmentWorker::FragmentWorker() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

void FragmentWorker::want(std::vector<FragmentPlace> places) {
    {
        const std::lock_guard lock(mutex_);
        std::ranges::reverse(places);
        wanted_ = std::move(places);
    }
    wake_.notify_one();
}

std::vector<FragmentPixels> FragmentWorker::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(drawn_, {});
}

void FragmentWorker::wait(std::chrono::milliseconds longest) {
    std::unique_lock lock(mutex_);
    ready_.wait_for(lock, longest, [this] { return !drawn_.empty(); });
}

void FragmentWorker::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return !wanted_.empty(); })) {
        FragmentPixels result{std::move(wanted_.back()), {}};
        wanted_.pop_back();
        lock.unlock();
        result.pixels = fragment_pixels(result.place);
        lock.lock();
        drawn_.push_back(std::move(result));
        ready_.notify_one();
    }
}

}  // namespace rinceau

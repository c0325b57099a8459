#include "growth/arrangement/seed_queue.h"

#include <algorithm>

namespace rinceau {

namespace {

bool comes_later(const QueuedSeed& a, const QueuedSeed& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.node > b.node;
}

}  // namespace

void SeedQueue::push(QueuedSeed seed) {
    heap_.push_back(seed);
    std::push_heap(heap_.begin(), heap_.end(), comes_later);
}

std::optional<QueuedSeed> SeedQueue::pop() {
    if (heap_.empty()) return std::nullopt;
    std::pop_heap(heap_.begin(), heap_.end(), comes_later);
    const QueuedSeed seed = heap_.back();
    heap_.pop_back();
    return seed;
}

void SeedQueue::release(int blocker) {
    const auto found = waiting_.find(blocker);
    if (found == waiting_.end()) return;
    const std::vector<QueuedSeed> freed = std::move(found->second);
    waiting_.erase(found);
    for (const QueuedSeed& seed : freed) push(seed);
}

}  // namespace rinceau

#include "growth/surface/shape_queue.h"

#include <algorithm>
#include <utility>

namespace rinceau {

bool ShapeQueue::later(const Entry& a, const Entry& b) const {
    if (a.priority != b.priority) return a.priority < b.priority;
    if (a.depth != b.depth) return breadth_first_ ? a.depth > b.depth : a.depth < b.depth;
    return a.sequence > b.sequence;
}

void ShapeQueue::push(WaitingSymbol symbol) {
    if (free_.empty()) {
        free_.push_back(static_cast<int>(slots_.size()));
        slots_.emplace_back();
    }
    const int slot = free_.back();
    free_.pop_back();
    heap_.push_back({symbol.priority, symbol.depth, symbol.sequence, slot});
    slots_[static_cast<std::size_t>(slot)] = std::move(symbol);
    std::ranges::push_heap(heap_, [this](const Entry& a, const Entry& b) { return later(a, b); });
}

WaitingSymbol ShapeQueue::pop() {
    std::ranges::pop_heap(heap_, [this](const Entry& a, const Entry& b) { return later(a, b); });
    const int slot = heap_.back().slot;
    heap_.pop_back();
    free_.push_back(slot);
    return std::move(slots_[static_cast<std::size_t>(slot)]);
}

}  // namespace rinceau

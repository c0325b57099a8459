#include "geometry/index_map.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace rinceau {

IndexMap::IndexMap(std::size_t expected) {
    constexpr std::size_t least = 16;
    slots_.resize(std::bit_ceil(std::max(least, 2 * expected)));
    shift_ = 64U - static_cast<unsigned>(std::countr_zero(slots_.size()));
}

int IndexMap::find_or_insert(std::uint64_t key, int value) {
    const std::size_t slot = slot_of(key);
    if (slots_[slot].value != none) return slots_[slot].value;
    put(slot, key, value);
    return value;
}

void IndexMap::set(std::uint64_t key, int value) {
    const std::size_t slot = slot_of(key);
    if (slots_[slot].value != none) {
        slots_[slot].value = value;
    } else {
        put(slot, key, value);
    }
}

void IndexMap::clear() {
    std::ranges::fill(slots_, Slot{});
    size_ = 0;
}

void IndexMap::put(std::size_t slot, std::uint64_t key, int value) {
    slots_[slot] = {key, value};
    if (2 * ++size_ > slots_.size()) grow();
}

void IndexMap::grow() {
    const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
    --shift_;
    for (const Slot& slot : old) {
        if (slot.value != none) slots_[slot_of(slot.key)] = slot;
    }
}

}  // namespace rinceau

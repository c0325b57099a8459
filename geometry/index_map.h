#pragma once
// Keys -> small numbers, fast: one flat array, open addressing.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rinceau {

/// Stores a number >= 0 for each of a set of 64-bit keys; any key is allowed. Nothing can be taken out again.
class IndexMap {
  public:
    static constexpr int none = -1;

    /// Makes room for `expected` keys, so that no growth happens before.
    explicit IndexMap(std::size_t expected = 0);

    std::size_t size() const { return size_; }
    /// The number stored for `key`, or none.
    int find(std::uint64_t key) const { return slots_[slot_of(key)].value; }
    /// The number stored for `key`; if there is none, `value` is stored first.
    int find_or_insert(std::uint64_t key, int value);
    /// Replaces the number stored for `key`, or adds it.
    void set(std::uint64_t key, int value);
    /// Forgets all keys, keeps the room.
    void clear();

  private:
    struct Slot {
        std::uint64_t key = 0;
        int value = none;  // none = free
    };

    /// Where the key stands, or the free slot where it would.
    std::size_t slot_of(std::uint64_t key) const {
        // Multiplicative hashing: the upper bits of the product depend on all bits of the key.
        constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ULL;
        std::size_t at = static_cast<std::size_t>(((key ^ (key >> 32U)) * golden) >> shift_);
        while (slots_[at].value != none && slots_[at].key != key) at = (at + 1) & (slots_.size() - 1);
        return at;
    }
    void put(std::size_t slot, std::uint64_t key, int value);
    void grow();

    std::vector<Slot> slots_;  // a power of two of them, at most half of them in use
    unsigned shift_ = 0;       // 64 - log2(slots)
    std::size_t size_ = 0;
};

}  // namespace rinceau

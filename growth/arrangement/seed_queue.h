#pragma once
// Which seed grows next (Ijiri et al. 2008, section 5.1): the nearest one, and those that wait for one of higher priority.

#include <map>
#include <optional>
#include <vector>

namespace rinceau {

/// A seed with its distance from where growth began, measured when it was born.
struct QueuedSeed {
    double distance = 0;
    int node = 0;
};

/// Seeds by distance, ties by node. Seeds that are gone are not taken out: who pops one looks whether it still is one.
class SeedQueue {
  public:
    void push(QueuedSeed seed);
    /// The nearest of those that do not wait.
    std::optional<QueuedSeed> pop();
    /// `seed` comes back into the queue when `blocker` is released.
    void wait(QueuedSeed seed, int blocker) { waiting_[blocker].push_back(seed); }
    /// `blocker` is an element now, or gone.
    void release(int blocker);
    bool is_empty() const { return heap_.empty(); }

  private:
    std::vector<QueuedSeed> heap_;
    std::map<int, std::vector<QueuedSeed>> waiting_;
};

}  // namespace rinceau

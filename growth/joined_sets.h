#pragma once
// Things 0 .. n - 1 that are joined to sets, two at a time. Internal to the folder.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace rinceau {

class JoinedSets {
  public:
    explicit JoinedSets(std::size_t count) : up_(count), sizes_(count, 1) { std::iota(up_.begin(), up_.end(), 0); }

    /// The lowest member of the set that holds i.
    int root(int i) {
        while (up(i) != i) i = up(i) = up(up(i));
        return i;
    }
    void join(int a, int b) {
        const int low = std::min(root(a), root(b));
        const int high = std::max(root(a), root(b));
        if (low == high) return;
        up(high) = low;
        sizes_[static_cast<std::size_t>(low)] += sizes_[static_cast<std::size_t>(high)];
    }
    /// Members of the set that holds i.
    std::size_t size_of(int i) { return sizes_[static_cast<std::size_t>(root(i))]; }

    /// Sets in order of their lowest members, members ascending.
    std::vector<std::vector<int>> sets() {
        std::vector<std::vector<int>> by_root(up_.size());
        for (int i = 0; i < static_cast<int>(up_.size()); ++i) by_root[static_cast<std::size_t>(root(i))].push_back(i);
        std::erase_if(by_root, [](const auto& set) { return set.empty(); });
        return by_root;
    }

  private:
    int& up(int i) { return up_[static_cast<std::size_t>(i)]; }

    std::vector<int> up_;
    std::vector<std::size_t> sizes_;
};

}  // namespace rinceau

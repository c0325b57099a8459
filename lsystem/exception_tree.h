#pragma once
// Exceptions by address, one step of the address at a time. Internal to the folder.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

/// Nodes are addresses and the fronts of addresses; node 0 is the empty address.
class ExceptionTree {
  public:
    static constexpr int none = -1;

    /// The last of several exceptions at one address counts. Numbers below 1 match nothing.
    explicit ExceptionTree(const std::vector<Exception>& exceptions = {});

    bool empty() const { return children_.empty(); }
    /// The node one step further, or none.
    int child(int node, int number) const {
        if (node == none) return none;
        const auto found = children_.find(key(node, number));
        return found == children_.end() ? none : found->second;
    }
    /// The exception at the node's address, or none.
    int exception_at(int node) const { return node == none ? none : exceptions_[static_cast<std::size_t>(node)]; }

  private:
    static std::uint64_t key(int node, int number) {
        return (static_cast<std::uint64_t>(node) << 32U) | static_cast<std::uint32_t>(number);
    }
    std::unordered_map<std::uint64_t, int> children_;
    std::vector<int> exceptions_{none};
};

}  // namespace rinceau

#pragma once
// The symbols that wait for a rule (Li et al. 2010, section 3.2: the shape with the rule of highest priority goes first).

#include <vector>

#include "growth/surface/shape_scope.h"
#include "lsystem/draw_key.h"

namespace rinceau {

struct WaitingSymbol {
    int symbol = 0;
    int rule = -1;  ///< chosen already; -1 = to be chosen
    std::vector<double> arguments;
    ShapeScope scope;
    double priority = 0;
    int depth = 0;      ///< rules between it and the axiom
    long sequence = 0;  ///< unique
    DrawKey key = 0;    ///< its random numbers lie below it
};

/// By falling priority; then by rising depth, or falling depth if the derivation goes depth first; then in the order of
/// coming.
class ShapeQueue {
  public:
    explicit ShapeQueue(bool breadth_first) : breadth_first_(breadth_first) {}
    void push(WaitingSymbol symbol);
    /// There is one.
    WaitingSymbol pop();
    bool is_empty() const { return heap_.empty(); }
    long size() const { return static_cast<long>(heap_.size()); }

  private:
    /// Small, so that sorting moves no scopes.
    struct Entry {
        double priority;
        int depth;
        long sequence;
        int slot;
    };
    bool breadth_first_;
    std::vector<Entry> heap_;
    std::vector<WaitingSymbol> slots_;
    std::vector<int> free_;

    bool later(const Entry& a, const Entry& b) const;
};

}  // namespace rinceau

#pragma once
// The styles of a grammar by number.

#include <unordered_map>

#include "lsystem/grammar.h"

namespace rinceau {

/// Refers to the grammar that it was made from, which must outlive it.
class StyleTable {
  public:
    explicit StyleTable(const Grammar& grammar) {
        for (const NumberedStyle& style : grammar.styles) styles_.try_emplace(style.number, &style.style);
    }
    /// Also true of 0, which is a terminal's own style.
    bool contains(int number) const { return number == 0 || styles_.contains(number); }
    /// A default Style for 0 and for a number that the grammar lacks.
    const Style& style(int number) const {
        const auto found = styles_.find(number);
        return found == styles_.end() ? default_ : *found->second;
    }

  private:
    Style default_;
    std::unordered_map<int, const Style*> styles_;
};

}  // namespace rinceau

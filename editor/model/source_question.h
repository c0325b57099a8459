#pragma once
// What growth asks of the document.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

/// What is to be read, and how.
struct SourceQuestion {
    std::shared_ptr<const Grammar> grammar;  ///< with all that it uses
    std::string raised;                      ///< GrowthSettings
    bool group = true;
    std::vector<std::pair<int, int>> flips;  ///< ExemplarOptions
    friend bool operator==(const SourceQuestion&, const SourceQuestion&) = default;
};

}  // namespace rinceau

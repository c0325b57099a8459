#pragma once
// The panel of rules.

#include <string>

namespace rinceau {

/// What is open in the panel of rules.
struct RulesState {
    std::string filter;  ///< shows numbers and rules whose name holds this; empty = all
};

}  // namespace rinceau

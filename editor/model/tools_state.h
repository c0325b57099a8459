#pragma once
// The tools.

#include <cstdint>

namespace rinceau {

/// What is set in the tools before they are used.
struct ToolsState {
    std::uint64_t seed = 1;  ///< of the next randomization
};

}  // namespace rinceau

#pragma once
// What the editor knows of the analysis in the background.

#include <cstdint>
#include <string>

namespace rinceau {

struct AnalysisState {
    std::uint64_t job = 0;  ///< number of the last one that was started
    bool running = false;
    std::string stage;
    double fraction = 0;
};

}  // namespace rinceau

#pragma once
// What the editor knows of the analysis in the background.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "analyzer/analyze.h"

namespace rinceau {

struct AnalysisState {
    std::uint64_t job = 0;  ///< number of the last one that was started
    bool running = false;
    bool tried = false;                       ///< what the running one finds is only previewed
    AnalyzeOptions options;                   ///< of the last one that was started
    std::optional<AnalyzeOptions> next;       ///< tried when the running one is done
    std::shared_ptr<const Analysis> waiting;  ///< found while something was dragged; comes when that is let go
    std::string stage;
    double fraction = 0;
};

}  // namespace rinceau

#pragma once
// Analysis in the background.

#include <cstdint>
#include <string>
#include <variant>

#include "analyzer/analyze.h"

namespace rinceau {

/// Analyse the document's drawing with these options. An analysis that is running is stopped.
struct StartAnalysis {
    AnalyzeOptions options;
};
struct CancelAnalysis {};
struct AnalysisProgress {
    std::uint64_t job = 0;
    std::string stage;
    double fraction = 0;
};
struct AnalysisDone {
    std::uint64_t job = 0;
    Analysis analysis;
};
struct AnalysisFailed {
    std::uint64_t job = 0;
    std::string message;  ///< empty = it was cancelled
};

using AnalysisAction = std::variant<StartAnalysis, CancelAnalysis, AnalysisProgress, AnalysisDone, AnalysisFailed>;

}  // namespace rinceau

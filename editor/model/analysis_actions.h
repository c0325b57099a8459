#pragma once
// Analysis in the background.

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "analyzer/analyze.h"

namespace rinceau {

/// Analyse the document's drawing with these options: what is found becomes the document's grammar. An analysis that is
/// running is stopped.
struct StartAnalysis {
    AnalyzeOptions options;
};
/// The same while a slider moves: what is found is only previewed, until StartAnalysis or DropPreview.
struct TryAnalysis {
    AnalyzeOptions options;
};
/// Stop: the document is as before.
struct CancelAnalysis {};
struct AnalysisProgress {
    std::uint64_t job = 0;
    std::string stage;
    double fraction = 0;
};
struct AnalysisDone {
    std::uint64_t job = 0;
    std::shared_ptr<const Analysis> analysis;
};
struct AnalysisFailed {
    std::uint64_t job = 0;
    std::string message;
};

using AnalysisAction =
    std::variant<StartAnalysis, TryAnalysis, CancelAnalysis, AnalysisProgress, AnalysisDone, AnalysisFailed>;

}  // namespace rinceau

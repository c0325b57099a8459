#pragma once
// The analysis in words, for messages, labels of edits and the panel.

#include <string>
#include <string_view>

#include "analyzer/analyze.h"

namespace rinceau {

/// "412 elements in 7 rules: 3,120 bits instead of 41,800".
std::string analysis_summary(const AnalysisReport& report);

/// What an edit is called that analyses anew: "analyse with nearness 2", or "analyse" if no option or several changed.
std::string analysis_label(const AnalyzeOptions& before, const AnalyzeOptions& after);

/// What is done in a stage that the analysis names in its progress.
std::string stage_in_words(std::string_view stage);

}  // namespace rinceau

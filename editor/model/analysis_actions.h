#pragma once
// Analysis in the background.

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "analyzer/analyze.h"
#include "editor/model/clusters_state.h"

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

/// Show the table of clusters, or close it. While it is shown it follows the drawing.
struct ShowClusters {
    bool shown = true;
};
struct ClustersFound {
    std::uint64_t job = 0;
    std::shared_ptr<const DrawingClusters> clusters;
};
struct ClustersFailed {
    std::uint64_t job = 0;
    std::string message;
};
/// The elements of a row are lit on the canvas while the mouse is over it; -1 = of none.
struct HoverCluster {
    int row = -1;
};
/// They stay lit; the same row again, or -1: no more.
struct KeepCluster {
    int row = -1;
};
/// It is known which items of a picture stand for which elements.
struct ElementsMapped {
    std::shared_ptr<const ElementItems> items;  ///< null: it could not be found out
    std::string message;                        ///< why
};

/// A terminal is chosen to be merged with others, or no longer.
struct ChooseTerminal {
    std::string symbol;
    bool chosen = true;
};
/// The elements of the chosen terminals shall be copies of each other, drawn as the first; the drawing is analysed anew.
struct MergeTerminals {};
/// The elements of the selection shall be a terminal of their own; the drawing is analysed anew.
struct SplitSelection {};
/// What was merged and split by hand is left to the analysis again.
struct ForgetGrouping {};

struct AnalysisAction : std::variant<StartAnalysis, TryAnalysis, CancelAnalysis, AnalysisProgress, AnalysisDone,
                                     AnalysisFailed, ShowClusters, ClustersFound, ClustersFailed, HoverCluster, KeepCluster,
                                     ElementsMapped, ChooseTerminal, MergeTerminals, SplitSelection, ForgetGrouping> {
    using variant::variant;
    AnalysisAction(const AnalysisAction&);
    AnalysisAction(AnalysisAction&&) noexcept;
    AnalysisAction& operator=(const AnalysisAction&);
    AnalysisAction& operator=(AnalysisAction&&) noexcept;
    ~AnalysisAction();
};

}  // namespace rinceau

#pragma once
// Clusters of the drawing's transformation spaces, which of them is looked at, and groups made by hand.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/analyze.h"
#include "analyzer/cluster_table.h"
#include "editor/model/element_items.h"
#include "editor/model/lit_items.h"

namespace rinceau {

struct DrawingClusters {
    std::shared_ptr<const Scene> drawing;
    AnalyzeOptions options;  ///< with which its looks were found
    ClusterTable table;
};

/// What shall be grouped once it is known which elements are meant.
struct PendingGrouping {
    GroupingKind kind = GroupingKind::together;
    std::vector<std::string> terminals;  ///< to merge
    int first = 0;                       ///< to split off: items with orders in [first, last)
    int last = 0;
};

struct ClustersState {
    bool wanted = false;    ///< the table is shown: it follows the drawing
    std::uint64_t job = 0;  ///< number of the last search for clusters
    bool running = false;
    AnalyzeOptions options;                        ///< of that search
    std::string mistake;                           ///< why the last one failed
    std::shared_ptr<const DrawingClusters> found;  ///< null = none yet
    int hovered = -1;                              ///< row of the table; -1 = none
    int kept = -1;                                 ///< row that stays lit
    int lit_row = -1;                              ///< row that is lit on the canvas ..
    LitItems lit;                                  ///< .. by these flags

    std::shared_ptr<const ElementItems> items;      ///< of a picture that may be an older one
    std::shared_ptr<const DerivedPicture> mapping;  ///< picture whose items are being matched; null = none
    std::optional<PendingGrouping> pending;
    std::vector<std::string> merging;  ///< symbols of terminals that are chosen to be merged, in this order
};

}  // namespace rinceau

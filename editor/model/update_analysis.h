#pragma once
// The actions of the analysis that have a file of their own. Internal to the folder.

#include "editor/model/update_parts.h"

namespace rinceau {

// Clusters: update_clusters.cpp.
void analyse(Update& update, const ShowClusters& action);
void analyse(Update& update, const ClustersFound& action);
void analyse(Update& update, const ClustersFailed& action);
void analyse(Update& update, const HoverCluster& action);
void analyse(Update& update, const KeepCluster& action);
void analyse(Update& update, const ElementsMapped& action);

/// The table, and what is lit on the canvas, follow the drawing and its picture.
void follow_clusters(Update& update);

/// Which items stand for which elements, for the picture that is shown; null if it must be found first, which is asked for.
std::shared_ptr<const ElementItems> current_items(Update& update);

// Groups made by hand: update_grouping.cpp.
void analyse(Update& update, const ChooseTerminal& action);
void analyse(Update& update, const MergeTerminals& action);
void analyse(Update& update, const SplitSelection& action);
void analyse(Update& update, const ForgetGrouping& action);

/// What shall be grouped is grouped as soon as it is known which elements are meant.
void settle_grouping(Update& update);

}  // namespace rinceau

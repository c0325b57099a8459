#pragma once
// The parts of the analysis panel that have a file of their own. Internal to the folder.

#include "editor/panels/panel.h"

namespace rinceau {

/// Clusters as a table with their importance; the mouse over a row lights its elements up, a click keeps them lit.
Actions clusters_table(const EditorState& state, const PanelTools& tools);

/// The transformation space of the row that is lit: alpha against d, beta against s. A click on a point keeps its cluster.
Actions space_plots(const EditorState& state, const PanelTools& tools);

/// The productions that the analysis found; the mouse over a row lights up what the rule draws.
Actions found_rules(const EditorState& state, const PanelTools& tools);

/// Terminals to be merged, and the selection to be split off, by hand.
Actions grouping_tools(const EditorState& state, const PanelTools& tools);

/// The colour of a cluster of a space, 0 the largest: far apart for the first ten, grey for the rest; packed as Dear ImGui
/// packs colours.
unsigned cluster_color(int cluster);

}  // namespace rinceau

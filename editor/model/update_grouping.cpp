// Groups made by hand: which elements shall be, or shall not be, copies of each other. The analysis follows.

#include <algorithm>
#include <utility>

#include "editor/model/update_analysis.h"
#include "editor/model/wished_analysis.h"

namespace rinceau {
namespace {

int terminal_of(const Grammar& grammar, const std::string& symbol) {
    const auto found = std::ranges::find(grammar.terminals, symbol, &Terminal::symbol);
    return found == grammar.terminals.end() ? -1 : static_cast<int>(found - grammar.terminals.begin());
}

/// The elements that are meant, those of the first terminal first.
std::vector<int> meant_elements(const PendingGrouping& grouping, const ElementItems& items) {
    if (grouping.kind == GroupingKind::apart) return elements_of_items(items, grouping.first, grouping.last);
    std::vector<int> all;
    for (const std::string& symbol : grouping.terminals) {
        const std::vector<int> more = elements_of_terminal(items, terminal_of(*items.picture->grammar, symbol));
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

bool can_group(Update& update) {
    if (update.state.document.drawing) return true;
    tell(update, MessageKind::mistake,
         "There is no drawing to group elements of: this document was opened as a grammar. Open an .svg.");
    return false;
}

}  // namespace

void analyse(Update& update, const ChooseTerminal& action) {
    std::vector<std::string>& merging = update.state.clusters.merging;
    std::erase(merging, action.symbol);
    if (action.chosen) merging.push_back(action.symbol);
}

void analyse(Update& update, const MergeTerminals&) {
    ClustersState& clusters = update.state.clusters;
    if (!can_group(update)) return;
    if (clusters.merging.size() < 2) {
        tell(update, MessageKind::mistake, "Choose two terminals or more to merge: the first one is drawn for all");
        return;
    }
    clusters.pending = PendingGrouping{.kind = GroupingKind::together, .terminals = clusters.merging};
}

void analyse(Update& update, const SplitSelection&) {
    EditorState& state = update.state;
    if (!can_group(update)) return;
    if (!state.canvas.selection) {
        tell(update, MessageKind::mistake, "Click the elements on the canvas that shall be a terminal of their own");
        return;
    }
    const PathModule& module = selected_module(*state.canvas.selection);
    state.clusters.pending =
        PendingGrouping{.kind = GroupingKind::apart, .terminals = {}, .first = module.first, .last = module.last};
}

void analyse(Update& update, const ForgetGrouping&) {
    if (!can_group(update)) return;
    AnalyzeOptions options = wished_analysis(update.state);
    if (options.grouping.empty()) return;
    options.grouping.clear();
    perform(update, AnalysisAction{StartAnalysis{options}});
}

void settle_grouping(Update& update) {
    ClustersState& clusters = update.state.clusters;
    if (!clusters.pending) return;
    const auto items = current_items(update);
    if (!items) return;
    const PendingGrouping grouping = *std::exchange(clusters.pending, std::nullopt);
    const std::vector<int> elements = meant_elements(grouping, *items);
    if (elements.empty()) {
        tell(update, MessageKind::mistake,
             "None of these stands where the drawing has an element: groups are made of elements of the drawing");
        return;
    }
    clusters.merging.clear();
    AnalyzeOptions options = wished_analysis(update.state);
    options.grouping.push_back({grouping.kind, elements});
    perform(update, AnalysisAction{StartAnalysis{options}});
}

}  // namespace rinceau

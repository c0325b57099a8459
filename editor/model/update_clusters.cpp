// Clusters of the drawing's transformation spaces: found when their table is shown, lit on the canvas.

#include "editor/model/update_analysis.h"

namespace rinceau {
namespace {

/// Do the same options, as far as clusters go, hold?
bool same_looks(const AnalyzeOptions& a, const AnalyzeOptions& b) {
    AnalyzeOptions alike = b;
    alike.similarity = a.similarity;
    alike.grouping = a.grouping;
    return same_analysis(b, alike);
}

void find_clusters(Update& update) {
    ClustersState& clusters = update.state.clusters;
    const Document& document = update.state.document;
    clusters.running = true;
    clusters.options = document.analysis;
    clusters.mistake.clear();
    update.requests.push_back(TabulateClusters{++clusters.job, document.drawing, document.analysis});
}

/// Of another drawing, or with other looks.
bool is_stale(const ClustersState& clusters, const Document& document) {
    if (clusters.running) return !same_looks(clusters.options, document.analysis);
    if (!clusters.mistake.empty()) return false;
    return !clusters.found || clusters.found->drawing != document.drawing ||
           !same_looks(clusters.found->options, document.analysis);
}

void put_out(Update& update) {
    ClustersState& clusters = update.state.clusters;
    if (clusters.lit && update.state.canvas.lit == clusters.lit) perform(update, CanvasAction{HoverItems{}});
    clusters.lit.reset();
    clusters.lit_row = -1;
}

void forget_rows(Update& update) {
    put_out(update);
    update.state.clusters.hovered = update.state.clusters.kept = -1;
}

bool is_row(const ClustersState& clusters, int row) {
    return clusters.found && row >= 0 && static_cast<std::size_t>(row) < clusters.found->table.rows.size();
}

void light(Update& update, int row) {
    EditorState& state = update.state;
    ClustersState& clusters = state.clusters;
    const bool lit_by_others = state.canvas.lit && state.canvas.lit != clusters.lit;
    if (lit_by_others && clusters.hovered < 0) return;
    const bool is_lit =
        clusters.lit && clusters.lit_row == row && clusters.items && clusters.items->picture == state.picture;
    if (is_lit && state.canvas.lit == clusters.lit) return;
    const auto items = current_items(update);
    if (!items) return;
    const std::vector<int>& elements = clusters.found->table.rows[static_cast<std::size_t>(row)].elements;
    clusters.lit = std::make_shared<const std::vector<char>>(flags_of_elements(*items, elements));
    clusters.lit_row = row;
    perform(update, CanvasAction{HoverItems{clusters.lit}});
}

}  // namespace

void analyse(Update& update, const ShowClusters& action) {
    ClustersState& clusters = update.state.clusters;
    clusters.wanted = action.shown;
    clusters.mistake.clear();
    if (!action.shown) forget_rows(update);
}

void analyse(Update& update, const ClustersFound& action) {
    ClustersState& clusters = update.state.clusters;
    if (action.job != clusters.job || !clusters.running) return;
    clusters.running = false;
    forget_rows(update);
    clusters.found = action.clusters;
}

void analyse(Update& update, const ClustersFailed& action) {
    ClustersState& clusters = update.state.clusters;
    if (action.job != clusters.job || !clusters.running) return;
    clusters.running = false;
    clusters.mistake = action.message;
    tell(update, MessageKind::mistake, "No clusters could be found: " + action.message);
}

void analyse(Update& update, const HoverCluster& action) {
    if (action.row < 0 || is_row(update.state.clusters, action.row)) update.state.clusters.hovered = action.row;
}

void analyse(Update& update, const KeepCluster& action) {
    ClustersState& clusters = update.state.clusters;
    if (action.row >= 0 && !is_row(clusters, action.row)) return;
    clusters.kept = action.row == clusters.kept ? -1 : action.row;
}

void analyse(Update& update, const ElementsMapped& action) {
    ClustersState& clusters = update.state.clusters;
    if (!action.items) {
        clusters.pending.reset();
        clusters.hovered = clusters.kept = -1;
        tell(update, MessageKind::mistake, "The elements could not be found in the picture: " + action.message);
        return;
    }
    if (action.items->picture != clusters.mapping) return;  // it was asked for another picture since
    clusters.mapping.reset();
    clusters.items = action.items;
}

std::shared_ptr<const ElementItems> current_items(Update& update) {
    EditorState& state = update.state;
    ClustersState& clusters = state.clusters;
    if (!state.picture || !state.document.drawing) return nullptr;
    if (clusters.items && clusters.items->picture == state.picture) return clusters.items;
    if (clusters.mapping != state.picture) {
        clusters.mapping = state.picture;
        update.requests.push_back(MapElements{state.picture, state.document.drawing});
    }
    return nullptr;
}

void follow_clusters(Update& update) {
    EditorState& state = update.state;
    ClustersState& clusters = state.clusters;
    const bool same_drawing = clusters.found && clusters.found->drawing == state.document.drawing;
    if (clusters.found && !same_drawing) {
        forget_rows(update);
        clusters.found.reset();
    }
    if (clusters.wanted && state.document.drawing && is_stale(clusters, state.document)) find_clusters(update);
    const int row = clusters.hovered >= 0 ? clusters.hovered : clusters.kept;
    if (row >= 0) {
        light(update, row);
    } else if (clusters.lit) {
        put_out(update);
    }
}

}  // namespace rinceau

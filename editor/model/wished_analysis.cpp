#include "editor/model/wished_analysis.h"

namespace rinceau {

AnalyzeOptions wished_analysis(const EditorState& state) {
    if (state.analysis.next) return *state.analysis.next;
    if (state.analysis.running || state.analysis.waiting) return state.analysis.options;
    return shown_document(state).analysis;
}

AnalyzeOptions default_analysis(const EditorState& state) {
    AnalyzeOptions options;
    const AnalyzeOptions wished = wished_analysis(state);
    options.threads = wished.threads;
    options.grouping = wished.grouping;
    return options;
}

void set_symmetrize(AnalyzeOptions& options, bool on) {
    options.symmetrize = on;
    options.stochastic = options.stochastic && !on;
}

void set_stochastic(AnalyzeOptions& options, bool on) {
    options.stochastic = on;
    options.symmetrize = options.symmetrize && !on;
}

}  // namespace rinceau

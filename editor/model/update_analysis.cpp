// Analysis in the background: its result becomes the document's grammar.

#include "editor/model/update_parts.h"

namespace rinceau {
namespace {

void perform_one(Update& update, const StartAnalysis& action) {
    EditorState& state = update.state;
    if (!state.document.drawing) {
        tell(update, MessageKind::mistake,
             "There is no drawing to analyse: this document was opened as a grammar. Open an .svg.");
        return;
    }
    const auto job = state.analysis.job + 1;
    state.analysis = {.job = job, .running = true, .stage = "begin"};
    update.requests.push_back(RunAnalysis{job, state.document.drawing, action.options});
}

void perform_one(Update& update, const CancelAnalysis&) {
    if (update.state.analysis.running) update.requests.push_back(StopAnalysis{});
}

void perform_one(Update& update, const AnalysisProgress& action) {
    AnalysisState& analysis = update.state.analysis;
    if (action.job != analysis.job || !analysis.running) return;
    analysis.stage = action.stage;
    analysis.fraction = action.fraction;
}

void perform_one(Update& update, const AnalysisDone& action) {
    EditorState& state = update.state;
    if (action.job != state.analysis.job || !state.analysis.running) return;
    state.analysis.running = false;
    const bool first = !state.document.report;
    Document after = with_grammar(state.document, action.analysis.grammar);
    after.origin = after.grammar;
    after.report = std::make_shared<const AnalysisReport>(action.analysis.report);
    for (const std::string& warning : after.report->warnings) tell(update, MessageKind::warning, warning);
    if (!first) {
        record_edit(update, std::move(after), "analyse");
        return;
    }
    state.document = std::move(after);  // nothing to go back to: the drawing is as it was opened
    state.file.saved_grammar = state.document.grammar;
    show_anew(update);
}

void perform_one(Update& update, const AnalysisFailed& action) {
    AnalysisState& analysis = update.state.analysis;
    if (action.job != analysis.job || !analysis.running) return;
    analysis.running = false;
    if (action.message.empty()) {
        tell(update, MessageKind::note, "The analysis was stopped");
    } else {
        tell(update, MessageKind::mistake, action.message);
    }
}

}  // namespace

void perform(Update& update, const AnalysisAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau

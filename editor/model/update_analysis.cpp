// Analysis in the background: what it finds becomes the document's grammar. While a slider moves it is only previewed.

#include <utility>

#include "editor/model/analysis_words.h"
#include "editor/model/update_analysis.h"
#include "lsystem/grammar_text.h"

namespace rinceau {
namespace {

/// A tried analysis that takes no longer is let finish before the next one begins, so that something is always seen to
/// follow.
constexpr double quick_seconds = 0.3;

bool was_quick(const Document& document) {
    if (!document.report) return false;
    const AnalysisSeconds& seconds = document.report->seconds;
    return seconds.rules + seconds.verify < quick_seconds;
}

/// Is the preview what a tried analysis found?
bool shows_tried(const EditorState& state) { return state.preview && state.preview->report != state.document.report; }

void start(Update& update, const AnalyzeOptions& options, bool tried) {
    EditorState& state = update.state;
    const auto job = state.analysis.job + 1;
    state.analysis = {.job = job, .running = true, .tried = tried, .options = options, .stage = "begin"};
    update.requests.push_back(RunAnalysis{job, state.document.drawing, options});
}

void stop(Update& update) {
    AnalysisState& analysis = update.state.analysis;
    if (analysis.running) update.requests.push_back(StopAnalysis{});
    analysis = {.job = analysis.job};
}

/// The document with what was found in place of its grammar.
Document with_analysis(const Document& document, const std::shared_ptr<const Analysis>& analysis,
                       const AnalyzeOptions& options) {
    Document after = document;
    after.grammar = after.resolved = after.origin = {analysis, &analysis->grammar};
    after.report = {analysis, &analysis->report};
    after.used = nullptr;
    after.analysis = options;
    return after;
}

void show_document(Update& update) {
    if (!shows_tried(update.state)) return;
    update.state.preview.reset();
    show_anew(update);
}

/// The first analysis of a drawing is no edit: the drawing is as it was opened.
void take_as_opened(Update& update, Document after) {
    EditorState& state = update.state;
    state.document = std::move(after);
    state.preview.reset();
    state.file.awaits_rules = false;
    state.file.saved = state.document;
    show_anew(update);
}

bool found_the_same(const Document& before, const Document& after) {
    return same_analysis(before.analysis, after.analysis) && to_text(*before.grammar) == to_text(*after.grammar);
}

void take_over(Update& update, Document after) {
    EditorState& state = update.state;
    const Document& before = state.document;
    const bool first = state.file.awaits_rules && !rules_were_edited(before) && state.history.past.empty();
    if (!first && found_the_same(before, after)) {
        tell(update, MessageKind::note, "The analysis finds the same rules again");
        show_document(update);
        return;
    }
    for (const std::string& warning : after.report->warnings) tell(update, MessageKind::warning, warning);
    tell(update, MessageKind::note, analysis_summary(*after.report));
    if (first) {
        take_as_opened(update, std::move(after));
        return;
    }
    if (rules_were_edited(before))
        tell(update, MessageKind::warning, "The new rules take the place of those you had edited: Undo brings these back");
    const std::string label = analysis_label(before.analysis, after.analysis);
    record_edit(update, std::move(after), label);
}

void show_tried(Update& update, Document found) {
    EditorState& state = update.state;
    if (state.preview && !shows_tried(state)) return;  // something else is dragged
    state.preview_label = analysis_label(state.document.analysis, found.analysis);
    state.preview = std::move(found);
    show_anew(update);
}

void analyse(Update& update, const StartAnalysis& action) {
    EditorState& state = update.state;
    if (!state.document.drawing) {
        tell(update, MessageKind::mistake,
             "There is no drawing to analyse: this document was opened as a grammar. Open an .svg.");
        return;
    }
    if (shows_tried(state) && same_analysis(state.preview->analysis, action.options)) {
        stop(update);
        take_over(update, *state.preview);
    } else if (state.analysis.running && same_analysis(state.analysis.options, action.options)) {
        state.analysis.tried = false;
        state.analysis.next.reset();
    } else {
        start(update, action.options, false);
    }
}

void analyse(Update& update, const TryAnalysis& action) {
    AnalysisState& analysis = update.state.analysis;
    if (!update.state.document.drawing) return;
    if (analysis.running && same_analysis(analysis.options, action.options)) {
        analysis.next.reset();
    } else if (analysis.running && analysis.tried && was_quick(shown_document(update.state))) {
        analysis.next = action.options;
    } else {
        start(update, action.options, true);
    }
}

void analyse(Update& update, const CancelAnalysis&) {
    if (!update.state.analysis.running) return;
    stop(update);
    show_document(update);
    tell(update, MessageKind::note, "The analysis was stopped; the rules are as they were before");
}

void analyse(Update& update, const AnalysisProgress& action) {
    AnalysisState& analysis = update.state.analysis;
    if (action.job != analysis.job || !analysis.running) return;
    analysis.stage = action.stage;
    analysis.fraction = action.fraction;
}

void analyse(Update& update, const AnalysisDone& action) {
    EditorState& state = update.state;
    if (action.job != state.analysis.job || !state.analysis.running) return;
    state.analysis.running = false;
    if (!state.analysis.tried) {
        state.analysis.waiting = action.analysis;
        return;
    }
    show_tried(update, with_analysis(state.document, action.analysis, state.analysis.options));
    if (const auto next = state.analysis.next) start(update, *next, true);
}

void analyse(Update& update, const AnalysisFailed& action) {
    const AnalysisState& analysis = update.state.analysis;
    if (action.job != analysis.job || !analysis.running) return;
    stop(update);
    show_document(update);
    tell(update, MessageKind::mistake, "The analysis failed, the rules are as they were before: " + action.message);
}

}  // namespace

void settle_analysis(Update& update) {
    settle_grouping(update);
    follow_clusters(update);
    EditorState& state = update.state;
    if (!state.analysis.waiting || (state.preview && !shows_tried(state))) return;
    const auto found = std::exchange(state.analysis.waiting, nullptr);
    take_over(update, with_analysis(state.document, found, state.analysis.options));
}

void drop_tried_analysis(Update& update) {
    const EditorState& state = update.state;
    if (shows_tried(state) || (state.analysis.running && state.analysis.tried)) stop(update);
}

void forget_analysis(Update& update) { stop(update); }

void perform(Update& update, const AnalysisAction& action) {
    std::visit([&](const auto& one) { analyse(update, one); }, action);
}

}  // namespace rinceau

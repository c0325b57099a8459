// Growth: its panel, and the document as figures and exemplar, read anew whenever it has changed.

#include <utility>

#include "editor/model/update_growth.h"

namespace rinceau {
namespace {

void perform_one(Update& update, const OpenGrowth& action) {
    open_growth_panel(update.state, action.tab);
    update.state.shell.focus_wanted = EditorPanel::growth;
}

void perform_one(Update& update, const SetGrowth& action) {
    GrowthState& growth = update.state.growth;
    const bool jitters = growth.settings.arrangement.jitter != action.settings.arrangement.jitter;
    growth.settings = action.settings;
    const bool waits = !growth.waiting.empty() && std::holds_alternative<ShowStep>(growth.waiting.back());
    if (jitters && !waits && growth.grown && growth.grown->arrangement) ask_for_growth(update, {ShowStep{}});
}

void perform_one(Update& update, const ShowGrowth& action) { show_growth(update, action.shown); }

/// An edge that could not be flipped is not asked for again.
void tell_flip(Update& update) {
    GrowthState& growth = update.state.growth;
    if (growth.flips.empty() || growth.source->exemplar || !growth.source->drawing) return;
    growth.flips.pop_back();
    tell(update, MessageKind::warning, "The edge stays as it is: " + growth.source->mistake);
}

void perform_one(Update& update, const SourceRead& action) {
    GrowthState& growth = update.state.growth;
    if (action.job != growth.source_job || !growth.asked) return;
    growth.asked.reset();
    growth.source = action.source;
    if (action.source->drawing)
        for (const std::string& warning : action.source->drawing->warnings) tell(update, MessageKind::warning, warning);
    tell_flip(update);
    start_waiting_growth(update);
}

/// What belongs to numbers of elements holds as long as the grammar is the same.
void follow_document(Update& update) {
    GrowthState& growth = update.state.growth;
    const auto& grammar = update.state.document.resolved;
    if (growth.followed == grammar) return;
    growth.followed = grammar;
    growth.flips.clear();
    growth.settings.aggregate.shapes.clear();
    if (growth.work != GrowthWork::using_it) show_growth(update, false);
}

}  // namespace

void open_growth_panel(EditorState& state, GrowthTab tab) {
    state.shell.shown.right = true;
    state.shell.right_tab = EditorPanel::growth;
    state.growth.settings.tab = tab;
}

void follow_growth(Update& update) {
    GrowthState& growth = update.state.growth;
    follow_document(update);
    const bool rules_come = update.state.file.awaits_rules && update.state.analysis.running;
    if (!growth_is_open(update.state) || rules_come) return;
    SourceQuestion question = source_question(update.state);
    const bool known = growth.asked ? *growth.asked == question : growth.source && growth.source->question == question;
    if (known) return;
    growth.asked = question;
    update.requests.push_back(ReadSource{++growth.source_job, std::move(question), growth.source});
}

void forget_growth(Update& update) {
    drop_growth_work(update);
    GrowthState& growth = update.state.growth;
    GrowthState anew;
    anew.settings = std::move(growth.settings);
    anew.settings.raised.clear();
    anew.settings.brush = GrowthBrush::none;
    anew.source_job = growth.source_job;
    anew.job = growth.job;
    growth = std::move(anew);
}

void perform(Update& update, const GrowthAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau

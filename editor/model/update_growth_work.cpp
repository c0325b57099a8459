// Growth in the background: one order at a time; steps that are asked for meanwhile are the next one.

#include <utility>

#include "editor/model/update_growth.h"

namespace rinceau {
namespace {

void begin_work(GrowthState& growth, GrowthWork work) {
    ++growth.job;
    growth.work = work;
    growth.stopping = false;
    growth.stage.clear();
    growth.fraction = 0;
}

/// What is asked for needs a drawing with elements.
bool can_grow(Update& update) {
    if (!update.state.document.resolved->terminals.empty()) return true;
    tell(update, MessageKind::mistake, "There is nothing that could grow: open a drawing with some elements first");
    return false;
}

/// Where growth goes on; null = it begins.
std::shared_ptr<const GrownPattern> arrangement_to_go_on(const GrowthState& growth) {
    return growth.grown && growth.grown->arrangement ? growth.grown : nullptr;
}

void start_arranging(Update& update, std::shared_ptr<const GrowthSource> source) {
    GrowthState& growth = update.state.growth;
    begin_work(growth, GrowthWork::arranging);
    show_growth(update, true);
    ArrangeOrder order{.source = std::move(source),
                       .from = arrangement_to_go_on(growth),
                       .settings = growth.settings.arrangement,
                       .guides = growth.guides,
                       .canvas = growth_canvas(update.state),
                       .steps = std::exchange(growth.waiting, {})};
    update.requests.push_back(GrowArrangement{growth.job, std::make_shared<const ArrangeOrder>(std::move(order))});
}

void start_filling(Update& update) {
    GrowthState& growth = update.state.growth;
    growth.fill_waits = false;
    if (!growth.source->drawing) {
        tell(update, MessageKind::mistake, growth.source->mistake);
        return;
    }
    begin_work(growth, GrowthWork::filling);
    FillOrder order{growth.source, growth.settings.aggregate, growth_canvas(update.state)};
    update.requests.push_back(FillPattern{growth.job, std::make_shared<const FillOrder>(std::move(order))});
}

void tell_grown(Update& update, const GrownPattern& pattern) {
    if (pattern.placed.empty()) {
        tell(update, MessageKind::warning,
             "Nothing could grow there: give it more room, or take boundary strokes away from the middle of the canvas");
    } else {
        tell(update, MessageKind::note, "Grown: " + pattern.told);
    }
}

std::vector<ArrangeStep> steps_of_count(const ArrangementSettings& settings) {
    std::vector<ArrangeStep> steps{GrowStep{settings.fill ? 0 : settings.count}};
    if (settings.finish) steps.push_back(FinishStep{true});
    return steps;
}

void end_work(GrowthState& growth) {
    growth.work = GrowthWork::none;
    growth.stopping = false;
}

}  // namespace

void drop_growth_work(Update& update) {
    GrowthState& growth = update.state.growth;
    growth.waiting.clear();
    growth.fill_waits = false;
    if (growth.work == GrowthWork::none) return;
    end_work(growth);
    update.requests.push_back(EndGrowth{false});
}

void start_waiting_growth(Update& update) {
    GrowthState& growth = update.state.growth;
    if (growth.work != GrowthWork::none) return;
    if (growth.fill_waits && current_source(update.state) != nullptr) start_filling(update);
    if (growth.waiting.empty()) return;
    if (const auto from = arrangement_to_go_on(growth)) {
        start_arranging(update, from->source);
        return;
    }
    if (current_source(update.state) == nullptr) return;  // it is on its way
    if (growth.source->exemplar) {
        start_arranging(update, growth.source);
        return;
    }
    growth.waiting.clear();
    tell(update, MessageKind::mistake, growth.source->mistake);
}

void ask_for_growth(Update& update, std::vector<ArrangeStep> steps) {
    auto& waiting = update.state.growth.waiting;
    waiting.insert(waiting.end(), steps.begin(), steps.end());
    start_waiting_growth(update);
}

void show_growth(Update& update, bool shown) {
    EditorState& state = update.state;
    if (shown && !state.growth.grown) begin_blank(update);
    if (state.growth.shown == shown) return;
    state.growth.shown = shown;
    state.canvas.hovered_item = -1;
    perform(update, CanvasAction{FitView{}});
}

void begin_blank(Update& update) {
    GrowthState& growth = update.state.growth;
    if (has_grown(update.state)) growth.dropped = growth.grown;
    growth.grown = std::make_shared<const GrownPattern>(blank_pattern(growth_canvas(update.state)));
}

void perform_one(Update& update, const BeginGrowth&) {
    if (!can_grow(update)) return;
    drop_growth_work(update);
    open_growth_panel(update.state, GrowthTab::arrangement);
    begin_blank(update);
    show_growth(update, true);
    perform(update, CanvasAction{FitView{}});
    ask_for_growth(update, steps_of_count(update.state.growth.settings.arrangement));
}

void perform_one(Update& update, const GrowMore&) {
    if (!can_grow(update)) return;
    open_growth_panel(update.state, GrowthTab::arrangement);
    show_growth(update, true);
    ask_for_growth(update, steps_of_count(update.state.growth.settings.arrangement));
}

void perform_one(Update& update, const FinishGrowth& action) {
    if (arrangement_to_go_on(update.state.growth)) ask_for_growth(update, {FinishStep{action.repair}});
}

void perform_one(Update& update, const FillAggregate&) {
    if (!can_grow(update)) return;
    drop_growth_work(update);
    open_growth_panel(update.state, GrowthTab::aggregate);
    begin_blank(update);
    show_growth(update, true);
    perform(update, CanvasAction{FitView{}});
    update.state.growth.fill_waits = true;
    start_waiting_growth(update);
}

void perform_one(Update& update, const GrowOtherSeed&) {
    GrowthSettings& settings = update.state.growth.settings;
    if (settings.tab == GrowthTab::arrangement) {
        ++settings.arrangement.seed;
        perform_one(update, BeginGrowth{});
    } else {
        ++settings.aggregate.seed;
        perform_one(update, FillAggregate{});
    }
}

void perform_one(Update& update, const StopGrowth&) {
    GrowthState& growth = update.state.growth;
    growth.waiting.clear();
    growth.fill_waits = false;
    growth.sprayed.reset();
    if (growth.work == GrowthWork::none || growth.stopping) return;
    if (growth.work == GrowthWork::using_it) {
        drop_growth_work(update);
        return;
    }
    growth.stopping = true;
    update.requests.push_back(EndGrowth{true});
}

void perform_one(Update& update, const DropGrowth&) {
    GrowthState& growth = update.state.growth;
    drop_growth_work(update);
    perform_one(update, DropStroke{});
    if (has_grown(update.state)) growth.dropped = growth.grown;
    show_growth(update, false);
    growth.grown.reset();
    growth.settings.brush = GrowthBrush::none;
}

void perform_one(Update& update, const BringBackGrowth&) {
    GrowthState& growth = update.state.growth;
    if (!growth.dropped) return;
    drop_growth_work(update);
    const auto back = std::exchange(growth.dropped, nullptr);
    if (has_grown(update.state)) growth.dropped = growth.grown;
    growth.grown = back;
    growth.shown = false;  // so that it is fitted
    show_growth(update, true);
}

void perform_one(Update& update, const UseGrowth&) {
    GrowthState& growth = update.state.growth;
    if (!has_grown(update.state) || growth.work != GrowthWork::none) return;
    begin_work(growth, GrowthWork::using_it);
    growth.stage = "writing rules";
    update.requests.push_back(MakeGrownDocument{growth.job, update.state.document, growth.grown});
}

void perform_one(Update& update, const GrowthProgress& action) {
    GrowthState& growth = update.state.growth;
    if (action.job != growth.job || growth.work == GrowthWork::none) return;
    growth.stage = action.stage;
    growth.fraction = action.fraction;
}

void perform_one(Update& update, const PatternGrown& action) {
    GrowthState& growth = update.state.growth;
    if (action.job != growth.job || growth.work == GrowthWork::none) return;
    const bool other_canvas =
        growth.grown && growth.grown->picture->grammar->canvas != action.pattern->picture->grammar->canvas;
    growth.grown = action.pattern;
    if (other_canvas && !growth.sprayed) perform(update, CanvasAction{FitView{}});
    if (!action.done) return;
    end_work(growth);
    if (!growth.sprayed && growth.waiting.empty()) tell_grown(update, *growth.grown);
    start_waiting_growth(update);
}

void perform_one(Update& update, const GrowthFailed& action) {
    GrowthState& growth = update.state.growth;
    if (action.job != growth.job || growth.work == GrowthWork::none) return;
    end_work(growth);
    growth.waiting.clear();
    growth.sprayed.reset();
    tell(update, MessageKind::mistake, action.message);
}

void perform_one(Update& update, const GrownDocumentMade& action) {
    EditorState& state = update.state;
    if (action.job != state.growth.job || state.growth.work != GrowthWork::using_it) return;
    end_work(state.growth);
    if (action.before != state.document.grammar) {
        tell(update, MessageKind::warning, "What has grown was not used: something was edited meanwhile. Use it again");
        return;
    }
    const bool fills = state.growth.grown->kind == GrowthTab::aggregate;
    tell(update, MessageKind::note, "The drawing is what has grown now: " + state.growth.grown->told);
    record_edit(update, action.document, fills ? "use the aggregate" : "use the arrangement");
    state.growth.settings.brush = GrowthBrush::none;
    state.growth.dropped = std::exchange(state.growth.grown, nullptr);
    show_growth(update, false);
    perform(update, CanvasAction{ClearSelection{}});
}

}  // namespace rinceau

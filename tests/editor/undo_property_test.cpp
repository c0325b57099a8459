// Whatever a user does, undo brings back the identical document.

#include <algorithm>
#include <deque>

#include <catch2/catch.hpp>

#include "editor/effects/read_document.h"
#include "editor/model/update.h"
#include "geometry/random.h"
#include "lsystem/derivation_facts.h"
#include "lsystem/grammar_names.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;

namespace {

// The world outside, at once.

Actions answer(const DerivePicture& request) {
    try {
        auto picture = std::make_shared<const DerivedPicture>(derive_picture(request.document));
        return {CanvasAction{PictureDerived{request.revision, std::move(picture)}}};
    } catch (const std::runtime_error& error) {
        return {CanvasAction{PictureFailed{request.revision, error.what()}}};
    }
}
Actions answer(const FindSelection& request) { return {CanvasAction{find_selection(request.search)}}; }
Actions answer(const CheckText& request) {
    return {RulesAction{TextChecked{request.revision, check_rule_text(request.text, request.file, request.document)}}};
}
Actions answer(const MeasureDepth& request) {
    try {
        const int depth = derivation_facts(*request.document.resolved).depth;
        return {RulesAction{DepthMeasured{request.document.resolved, depth}}};
    } catch (const std::runtime_error&) {
        return {RulesAction{DepthMeasured{request.document.resolved, -1}}};
    }
}
Actions answer(const RunAnalysis& request) {
    return {AnalysisAction{
        AnalysisDone{request.job, std::make_shared<const Analysis>(analyze(*request.drawing, request.options))}}};
}
Actions answer(const RunTool& request) {
    try {
        return {ToolsAction{ToolDone{request.job, use_tool(request.document, *request.edit)}}};
    } catch (const std::runtime_error& error) {
        return {ToolsAction{ToolFailed{request.job, error.what()}}};
    }
}
template <class Other>
Actions answer(const Other&) {
    return {};  // files and windows
}

EditorState acted(EditorState state, const Action& first) {
    std::deque<Action> waiting{first};
    while (!waiting.empty()) {
        Update result = update(std::move(state), waiting.front());
        waiting.pop_front();
        state = std::move(result.state);
        for (const Request& request : result.requests) {
            for (Action& action : std::visit([](const auto& one) { return answer(one); }, request))
                waiting.push_back(std::move(action));
        }
    }
    return state;
}

// What a user may do.

using MakeAction = Action (*)(Random& random, const EditorState& state);

template <class List>
auto any_of(Random& random, const List& list) {
    return list[random.below(static_cast<std::uint32_t>(list.size()))];
}

const GrammarNumber& any_number(Random& random, const EditorState& state) {
    const auto& numbers = state.rules.sheet->numbers;
    return numbers[random.below(static_cast<std::uint32_t>(numbers.size()))];
}
double other_value(Random& random, const GrammarNumber& number) {
    const double value = number.value * random.uniform(0.5, 1.5) + random.uniform(-2, 2);
    return number.whole ? std::min(std::round(value), 40.0) : value;  // few elements: many actions
}
std::string any_symbol(Random& random, const EditorState& state) {
    const auto symbols = symbols_of(*state.document.grammar);
    return symbols.empty() ? std::string("A") : any_of(random, symbols);
}
int any_production(Random& random, const EditorState& state) {
    return static_cast<int>(random.below(static_cast<std::uint32_t>(state.document.grammar->productions.size() + 1)));
}
std::string other_text(Random& random, const EditorState& state) {
    std::string text = to_text(*state.document.grammar);
    text[random.below(static_cast<std::uint32_t>(text.size()))] = any_of(random, std::string("3(f]A.-"));
    return text;
}

const std::vector<MakeAction> of_rules{
    [](Random& random, const EditorState& state) -> Action {
        const GrammarNumber& number = any_number(random, state);
        return RulesAction{SetNumber{number.name, other_value(random, number), random.below(2) == 0}};
    },
    [](Random& random, const EditorState& state) -> Action {
        const GrammarNumber& number = any_number(random, state);
        return RulesAction{SetNumber{number.name, other_value(random, number), true}};
    },
    [](Random&, const EditorState&) -> Action { return RulesAction{CommitPreview{}}; },
    [](Random&, const EditorState&) -> Action { return RulesAction{DropPreview{}}; },
    [](Random& random, const EditorState& state) -> Action {
        const std::vector<std::string> texts{"*=1.1", "-=1", "150%", "2*", "7", "pi"};
        return RulesAction{TypeNumber{any_number(random, state).name, any_of(random, texts)}};
    },
    [](Random&, const EditorState&) -> Action { return RulesAction{EnterTyped{}}; },
    [](Random& random, const EditorState& state) -> Action {
        return RulesAction{ResetNumber{any_number(random, state).name}};
    },
    [](Random& random, const EditorState& state) -> Action {
        return RulesAction{LockNumber{any_number(random, state).name, random.below(3) != 0}};
    },
    [](Random& random, const EditorState&) -> Action {
        return RulesAction{SetDepth{static_cast<int>(random.below(9)) - 1, random.below(2) == 0}};
    },
    [](Random& random, const EditorState&) -> Action { return RulesAction{SetSeed{random.below(5)}}; },
    [](Random& random, const EditorState& state) -> Action {
        AddProductionOptions options{.shape = static_cast<ProductionShape>(random.below(5))};
        options.elements = {any_symbol(random, state)};
        options.before = any_production(random, state) - 1;
        return RulesAction{AddProduction{options}};
    },
    [](Random& random, const EditorState& state) -> Action {
        return RulesAction{RemoveProduction{any_production(random, state), random.below(2) == 0}};
    },
    [](Random& random, const EditorState& state) -> Action {
        return RulesAction{MoveProduction{any_production(random, state), any_production(random, state)}};
    },
    [](Random& random, const EditorState& state) -> Action {
        return RulesAction{
            RenameSymbol{any_symbol(random, state), any_of(random, std::vector<std::string>{"Q", "Z1", "f", "Row"})}};
    },
    [](Random& random, const EditorState& state) -> Action {
        return RulesAction{CommentProduction{any_production(random, state), "Said."}};
    },
    [](Random& random, const EditorState& state) -> Action {
        return RulesAction{WriteCard{CardField::name, any_production(random, state), "R" + std::to_string(random.below(4))}};
    },
    [](Random&, const EditorState&) -> Action { return RulesAction{EnterCard{}}; },
    [](Random& random, const EditorState&) -> Action {
        return RulesAction{ShowRules{random.below(2) == 0 ? RulesView::rules : RulesView::text}};
    },
    [](Random& random, const EditorState& state) -> Action { return RulesAction{WriteText{other_text(random, state)}}; },
    [](Random&, const EditorState&) -> Action { return RulesAction{ApplyText{}}; },
    [](Random&, const EditorState&) -> Action { return RulesAction{RevertText{}}; },
    [](Random&, const EditorState&) -> Action { return RulesAction{UndoEdit{}}; },
    [](Random&, const EditorState&) -> Action { return RulesAction{RedoEdit{}}; },
    [](Random& random, const EditorState&) -> Action {
        return RulesAction{GoInHistory{static_cast<int>(random.below(5)) - 2}};
    }};

const std::vector<MakeAction> of_tools{
    [](Random& random, const EditorState&) -> Action {
        RandomizeOptions noise{.angle = random.uniform(0, 9), .distance = random.uniform(0, 0.2), .seed = random.below(9)};
        return ToolsAction{UseTool{shared_edit(RandomizeEdit{noise}), random.below(2) == 0}};
    },
    [](Random& random, const EditorState&) -> Action {
        return ToolsAction{UseTool{shared_edit(SymmetrizeEdit{}), random.below(2) == 0}};
    },
    [](Random& random, const EditorState& state) -> Action {
        Replacement replacement{.symbol = any_symbol(random, state), .with = OwnModules{}, .label = "nothing"};
        if (random.below(2) == 0) replacement.with = OwnModules{{{any_symbol(random, state), {}, {}}}};
        return ToolsAction{UseTool{shared_edit(ReplaceEdit{replacement, {}}), random.below(2) == 0}};
    },
    [](Random& random, const EditorState&) -> Action { return ToolsAction{SetNoise{{.angle = random.uniform(0, 9)}}}; },
    [](Random&, const EditorState&) -> Action { return ToolsAction{KeepTool{}}; }};

const std::vector<MakeAction> of_canvas{
    [](Random& random, const EditorState& state) -> Action {
        const Box& canvas = state.document.grammar->canvas;
        const Point at{random.uniform(canvas.low.x, canvas.high.x), random.uniform(canvas.low.y, canvas.high.y)};
        return CanvasAction{ClickCanvas{at, 2, random.below(4) == 0}};
    },
    [](Random& random, const EditorState&) -> Action {
        return CanvasAction{StepSelection{static_cast<int>(random.below(3)) - 1}};
    },
    [](Random& random, const EditorState& state) -> Action {
        const auto count = static_cast<std::uint32_t>(state.canvas.handles.size());
        const std::size_t index = random.below(count + 1);
        const Point at = index < count ? state.canvas.handles[index].at : Point{};
        return CanvasAction{GrabHandle{index, at}};
    },
    [](Random& random, const EditorState& state) -> Action {
        const Point from = state.canvas.drag ? state.canvas.drag->to : Point{};
        return CanvasAction{
            DragHandle{from + Point{random.uniform(-30, 30), random.uniform(-30, 30)}, random.below(4) == 0}};
    },
    [](Random&, const EditorState&) -> Action { return CanvasAction{ReleaseHandle{}}; },
    [](Random&, const EditorState&) -> Action { return CanvasAction{DropHandle{}}; },
    [](Random&, const EditorState&) -> Action { return CanvasAction{ClearSelection{}}; }};

const std::vector<MakeAction> of_analysis{
    [](Random& random, const EditorState& state) -> Action {
        AnalyzeOptions options = state.document.analysis;
        options.symmetrize = random.below(2) == 0;
        if (random.below(2) == 0) return AnalysisAction{TryAnalysis{options}};
        return AnalysisAction{StartAnalysis{options}};
    },
    [](Random&, const EditorState&) -> Action { return AnalysisAction{CancelAnalysis{}}; }};

// What must hold.

bool identical(const Document& a, const Document& b) {
    return a.drawing == b.drawing && a.grammar == b.grammar && a.resolved == b.resolved && a.used == b.used &&
           a.report == b.report && same_document(a, b);
}

/// `after` came from `before` by one action that was no step in the history.
void check_undo(const EditorState& before, const EditorState& after) {
    REQUIRE(after.history.past.size() == before.history.past.size() + 1);
    CHECK_FALSE(after.history.past.back().label.empty());
    CHECK(after.history.future.empty());
    CHECK_FALSE(after.preview);
    const EditorState back = acted(after, RulesAction{UndoEdit{}});
    CHECK(identical(back.document, before.document));
    const EditorState again = acted(back, RulesAction{RedoEdit{}});
    CHECK(identical(again.document, after.document));
}

bool steps_in_history(const Action& action) {
    const auto* rules = std::get_if<RulesAction>(&action);
    return rules != nullptr && (std::holds_alternative<UndoEdit>(*rules) || std::holds_alternative<RedoEdit>(*rules) ||
                                std::holds_alternative<GoInHistory>(*rules));
}

void check_step(const EditorState& before, const Action& action, const EditorState& after) {
    if (steps_in_history(action)) {
        CHECK(after.history.past.size() + after.history.future.size() ==
              before.history.past.size() + before.history.future.size());
    } else if (after.history.past.size() != before.history.past.size()) {
        check_undo(before, after);
    } else {
        CHECK(identical(after.document, before.document));
    }
    CHECK(after.rules.sheet->grammar == shown_document(after).grammar);
    CHECK(after.document.resolved);
    if (after.preview) CHECK_FALSE(after.preview_label.empty());
}

void check_random_actions(EditorState state, std::uint64_t seed, const std::vector<const std::vector<MakeAction>*>& areas,
                          int count) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        const std::vector<MakeAction>& area = *any_of(random, areas);
        const auto which = random.below(static_cast<std::uint32_t>(area.size()));
        const Action action = area[which](random, state);
        INFO("seed " << seed << ", action " << i << ", of area " << action.index() << " the " << which << ". kind");
        EditorState next = acted(state, action);
        check_step(state, action, next);
        state = std::move(next);
    }
    const EditorState dropped = acted(state, RulesAction{DropPreview{}});
    CHECK_FALSE(dropped.preview);
    EditorState first = acted(dropped, RulesAction{GoInHistory{-static_cast<int>(dropped.history.past.size())}});
    CHECK(first.history.past.empty());
}

EditorState opened(const std::string& sample) {
    const std::string path = std::string(RINCEAU_SOURCE_DIR "/samples/") + sample;
    const EditorState state = update(initial_state(), FileAction{OpenFile{path}}).state;
    EditorState ready = acted(state, FileAction{read_document(path)});
    return acted(ready, CanvasAction{ResizeCanvas{{400, 300}}});
}

}  // namespace

TEST_CASE("whatever is done to rules, undo brings back the identical document") {
    std::uint64_t seed = 1;
    for (const char* sample : {"facade.lsys", "rosette.lsys", "fern.lsys", "fig10_irregular.lsys"})
        check_random_actions(opened(sample), ++seed, {&of_rules}, 120);
}

TEST_CASE("whatever is done in all areas, undo brings back the identical document") {
    std::uint64_t seed = 20;
    for (const char* sample : {"border.lsys", "snowflake.lsys", "fig01_branching.lsys"})
        check_random_actions(opened(sample), ++seed, {&of_rules, &of_rules, &of_tools, &of_canvas, &of_canvas}, 150);
}

TEST_CASE("whatever is done about an analysed drawing, undo brings back the identical document") {
    const EditorState state = opened("fig08_sequence.svg");
    REQUIRE(state.document.report);
    check_random_actions(state, 40, {&of_rules, &of_tools, &of_canvas, &of_analysis}, 60);
}

#include <catch2/catch.hpp>

#include "editor/effects/read_document.h"
#include "editor/effects/read_tool_replacement.h"
#include "editor/model/tool_view.h"
#include "editor/model/update.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;

namespace {

const std::string samples = RINCEAU_SOURCE_DIR "/samples/";

EditorState acted(const EditorState& state, const Action& action);

/// The state when all that was asked for is done, as the effects do it.
EditorState settled(Update next) {
    for (const Request& request : next.requests) {
        if (const auto* run = std::get_if<RunTool>(&request)) {
            try {
                return acted(next.state, ToolsAction{ToolDone{run->job, use_tool(run->document, *run->edit)}});
            } catch (const std::exception& error) {
                return acted(next.state, ToolsAction{ToolFailed{run->job, error.what()}});
            }
        }
        if (const auto* read = std::get_if<ReadReplacement>(&request)) {
            try {
                return acted(next.state, read_tool_replacement(*read));
            } catch (const std::exception& error) {
                return acted(next.state, ToolsAction{ReplacementFailed{read->with, error.what()}});
            }
        }
    }
    return next.state;
}

EditorState acted(const EditorState& state, const Action& action) { return settled(update(state, action)); }

EditorState opened(const std::string& sample) {
    const EditorState asked = acted(initial_state(), FileAction{OpenFile{samples + sample}});
    return acted(asked, FileAction{read_document(samples + sample)});
}

EditorState with_noise(const EditorState& state, double angle) {
    RandomizeOptions noise = state.tools.settings.noise;
    noise.angle = angle;
    return acted(state, ToolsAction{SetNoise{noise}});
}

std::string text_of(const Document& document) { return to_text(*document.grammar); }

UseTool use(ToolEdit edit, bool preview = false) { return {shared_edit(std::move(edit)), preview}; }

}  // namespace

TEST_CASE("spreads and seeds are previewed, kept once and undone to the identical document") {
    const EditorState before = opened("facade.lsys");
    RandomizeOptions seven;
    seven.seed = 7;
    EditorState state = acted(before, ToolsAction{SetNoise{seven}});
    CHECK_FALSE(state.preview);  // nothing is drawn at random yet
    for (const double angle : {2, 4, 5}) state = with_noise(state, angle);
    CHECK(shows_tool_preview(state));
    CHECK(state.history.past.empty());
    CHECK(state.document.grammar == before.document.grammar);
    state = acted(state, ToolsAction{KeepTool{}});
    CHECK(state.history.past.size() == 1);
    CHECK(state.document.grammar->seed == 7);
    CHECK(text_of(state.document).find("normal(0, 5)") != std::string::npos);
    CHECK_FALSE(state.preview);
    state = acted(state, RulesAction{UndoEdit{}});
    CHECK(state.document.grammar == before.document.grammar);
}

TEST_CASE("another seed is another relative, and Esc drops it") {
    const EditorState noisy = acted(with_noise(opened("facade.lsys"), 5), ToolsAction{KeepTool{}});
    const EditorState other = acted(noisy, ToolsAction{NewSeed{}});
    CHECK(shown_document(other).grammar->seed == shown_seed(noisy) + 1);
    const EditorState dropped = acted(other, RulesAction{DropPreview{}});
    CHECK_FALSE(dropped.preview);
    CHECK(shown_seed(dropped) == shown_seed(noisy));
    CHECK(same_document(dropped.document, noisy.document));
}

TEST_CASE("of edits that were asked for while one runs, the last one is done") {
    const EditorState before = opened("facade.lsys");
    const Update first = update(before, ToolsAction{use(RandomizeEdit{{.angle = 1}}, true)});
    const RunTool run = std::get<RunTool>(first.requests.back());
    Update second = update(first.state, ToolsAction{use(RandomizeEdit{{.angle = 2}}, true)});
    CHECK(second.requests.empty());
    second = update(second.state, ToolsAction{use(RandomizeEdit{{.angle = 3}}, true)});
    const Action answer = ToolsAction{ToolDone{run.job, use_tool(run.document, *run.edit)}};
    CHECK(text_of(shown_document(acted(second.state, answer))).find("normal(0, 3)") != std::string::npos);
    // Esc while it runs
    const EditorState dropped = acted(acted(second.state, RulesAction{DropPreview{}}), answer);
    CHECK_FALSE(dropped.preview);
    CHECK_FALSE(dropped.tools.running);
}

TEST_CASE("an edit of a document that has changed meanwhile is told, not made") {
    const EditorState before = opened("facade.lsys");
    const Update asked = update(before, ToolsAction{use(RandomizeEdit{{.angle = 1}})});
    const RunTool run = std::get<RunTool>(asked.requests.back());
    EditorState other = asked.state;
    other.document = with_grammar(other.document, Grammar(*other.document.grammar));
    const EditorState state = acted(other, ToolsAction{ToolDone{run.job, use_tool(run.document, *run.edit)}});
    CHECK(state.document.grammar == other.document.grammar);
    CHECK(state.messages.back().kind == MessageKind::warning);
}

TEST_CASE("a symbol is replaced by a symbol, a drawing or a part of another grammar") {
    const EditorState before = opened("facade.lsys");
    const std::string symbol = before.document.resolved->terminals.back().symbol;
    for (const std::string& with : {std::string("Door"), samples + "flower.svg", samples + "vine.lsys#Leaf"}) {
        INFO(with);
        ToolSettings settings;
        settings.replace.symbol = symbol;
        settings.replace.with = with;
        EditorState state = acted(before, ToolsAction{SetTools{settings}});
        state = acted(state, ToolsAction{UseReplace{true}});
        CHECK(shows_tool_preview(state));
        state = acted(state, ToolsAction{UseReplace{}});
        CHECK(state.history.past.size() == 1);
        for (const Terminal& terminal : state.document.resolved->terminals) CHECK(terminal.symbol != symbol);
        CHECK(acted(state, RulesAction{UndoEdit{}}).document.grammar == before.document.grammar);
    }
}

TEST_CASE("a replacement that cannot be read leaves the document alone and is told") {
    EditorState state = opened("facade.lsys");
    const auto before = state.document.grammar;
    ToolSettings settings;
    settings.replace.with = "/nowhere/leaf.svg";
    state = acted(state, ToolsAction{SetTools{settings}});
    state = acted(state, ToolsAction{UseReplace{}});
    CHECK(state.document.grammar == before);
    CHECK(state.messages.back().kind == MessageKind::mistake);
    CHECK_FALSE(state.tools.reading);
}

TEST_CASE("rings, rows, groups, inlined rules and paints are recorded and undone") {
    const EditorState before = opened("rosette.lsys");
    const Grammar& grammar = *before.document.grammar;
    const std::string ring = symbols_of_rows(grammar).front();
    const std::string terminal = grammar.terminals.front().symbol;
    const Style blue{.fill = Color{0, 0, 255}};
    const GroupOptions first_module{.string = {StringPlace::In::axiom, 0}, .last = 0};
    for (const ToolEdit& edit : {ToolEdit{RowEdit{ring, {}}}, ToolEdit{RestyleEdit{terminal, blue}},
                                 ToolEdit{SymmetrizeEdit{{.tolerance = 5}}}, ToolEdit{GroupEdit{first_module}}}) {
        INFO(tool_label(edit));
        const EditorState state = acted(before, ToolsAction{use(edit)});
        if (state.history.past.empty()) {
            CHECK(state.document.grammar == before.document.grammar);
            CHECK_FALSE(state.messages.empty());
            continue;
        }
        CHECK(text_of(state.document) != text_of(before.document));
        CHECK(acted(state, RulesAction{UndoEdit{}}).document.grammar == before.document.grammar);
    }
}

TEST_CASE("locked numbers stay, whatever a tool does") {
    EditorState state = opened("facade.lsys");
    for (const GrammarNumber& number : grammar_numbers(*state.document.grammar))
        if (number.kind == NumberKind::length) state.document.locked.insert(number.name);
    state = acted(state, ToolsAction{use(RandomizeEdit{{.distance = 0.2}})});
    CHECK(state.history.past.empty());
    CHECK(state.messages.back().text.find("locked") != std::string::npos);
}

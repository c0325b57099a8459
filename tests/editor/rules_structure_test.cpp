#include <catch2/catch.hpp>

#include "editor/model/update.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;

namespace {

const std::string text =
    "lsystem 1\n"
    "axiom: [Wall(2)] B\n"
    "Wall(m) : m > 0 -> [Row(3)] f(20) Wall(m-1)\n"
    "Row(m) : m > 1 -> [A] f(5) Row(m-1)\n"
    "Row(m) : m > 0 -> [B] f(7) Row(m-1)\n"
    "terminal A: path \"M-1 0H1V-3Z\"\nterminal B: path \"M-1 0H1V-5Z\"\n";

EditorState opened() {
    EditorState state = update(initial_state(), FileAction{OpenFile{"/a.lsys"}}).state;
    return update(state, FileAction{FileOpened{"/a.lsys", with_grammar(empty_document(), parse_grammar(text)), {}}}).state;
}

EditorState after(EditorState state, const std::vector<RulesAction>& actions) {
    for (const RulesAction& action : actions) state = update(std::move(state), action).state;
    return state;
}

std::string written(const EditorState& state) { return to_text(*state.document.grammar); }

bool holds(const EditorState& state, const std::string& part) { return written(state).find(part) != std::string::npos; }

}  // namespace

TEST_CASE("rules are added, moved, renamed and commented, each as one edit that can be undone") {
    const EditorState before = opened();
    const std::vector<std::pair<RulesAction, std::string>> edits{
        {AddProduction{{.shape = ProductionShape::ring, .elements = {"B"}}}, "Ring(m) : m > 0 -> [f("},
        {MoveProduction{0, 2}, "[B] f(7) Row(m-1)\nWall(m)"},
        {RenameSymbol{"Wall", "House"}, "[House(2)] B"},
        {CommentProduction{0, "Two rows."}, "# Two rows.\nWall(m)"},
        {SetSeed{5}, "seed 5"}};
    for (const auto& [action, part] : edits) {
        const EditorState state = after(before, {action});
        INFO(written(state));
        CHECK(holds(state, part));
        CHECK(state.history.past.size() == 1);
        CHECK(after(state, {UndoEdit{}}).document.grammar == before.document.grammar);
        CHECK(written(after(state, {UndoEdit{}, RedoEdit{}})) == written(state));
    }
}

TEST_CASE("a rule that is used goes only when its uses may go, too") {
    const EditorState before = opened();
    const EditorState asked = after(before, {RemoveProduction{0}});
    REQUIRE(asked.rules.removal);
    CHECK(asked.rules.removal->reason.find("the axiom") != std::string::npos);
    CHECK(asked.document.grammar == before.document.grammar);
    CHECK_FALSE(after(asked, {KeepProduction{}}).rules.removal);
    const EditorState gone = after(asked, {RemoveProduction{0, true}});
    CHECK_FALSE(gone.rules.removal);
    CHECK_FALSE(holds(gone, "Wall"));
    CHECK_FALSE(holds(after(before, {RemoveProduction{2}}), "f(7)"));  // the other rule of Row is enough
}

TEST_CASE("names are written in the card and refused if they are taken") {
    const EditorState before = opened();
    CHECK(holds(after(before, {WriteCard{CardField::name, 0, "Tower"}, EnterCard{}}), "Tower(m-1)"));
    const EditorState wrong = after(before, {WriteCard{CardField::name, 0, "Row"}, EnterCard{}});
    REQUIRE(wrong.rules.written);
    CHECK(wrong.rules.written->mistake.find("another symbol") != std::string::npos);
    CHECK(wrong.document.grammar == before.document.grammar);
    CHECK_FALSE(after(wrong, {StopCard{}}).rules.written);
    CHECK(after(before, {WriteCard{CardField::name, 0, "Wall"}, EnterCard{}}).history.past.empty());
    CHECK(holds(after(before, {WriteCard{CardField::comment, 1, "First."}, EnterCard{}}), "# First.\nRow(m) : m > 1"));
}

TEST_CASE("locks go along with rules that are moved or renamed") {
    const EditorState locked = after(opened(), {LockNumber{"Row.distance"}, LockNumber{"Wall.count"}});
    const EditorState moved = after(locked, {MoveProduction{1, 2}});
    CHECK(moved.document.locked == std::set<std::string>{"Row.case2.distance", "Wall.count"});
    CHECK(holds(moved, "f(5)"));
    const EditorState renamed = after(locked, {RenameSymbol{"Wall", "House"}});
    CHECK(renamed.document.locked == std::set<std::string>{"House.count", "Row.distance"});
    const EditorState removed = after(locked, {RemoveProduction{1}});
    CHECK(removed.document.locked == std::set<std::string>{"Wall.count"});
    CHECK(after(removed, {UndoEdit{}}).document.locked == locked.document.locked);
}

TEST_CASE("the depth is shown while it slides and recorded once") {
    const EditorState before = opened();
    EditorState state = after(before, {SetDepth{2, true}, SetDepth{1, true}});
    CHECK(shown_document(state).derive.depth == 1);
    CHECK(state.document.derive.depth == -1);
    state = after(state, {CommitPreview{}});
    CHECK(state.document.derive.depth == 1);
    CHECK(state.history.past.size() == 1);
    CHECK(after(state, {SetDepth{1}}).history.past.size() == 1);
    CHECK(after(state, {UndoEdit{}}).document.derive.depth == -1);
}

TEST_CASE("the depth of a grammar is asked for once, and again when it is another one") {
    const auto asks = [](const Update& result) {
        return std::count_if(result.requests.begin(), result.requests.end(),
                             [](const Request& request) { return std::holds_alternative<MeasureDepth>(request); });
    };
    const auto measured = [](const EditorState& state) {
        return update(state, RulesAction{DepthMeasured{state.rules.measuring, 7}});
    };
    EditorState state = opened();
    while (state.rules.measuring) state = measured(state).state;
    CHECK(state.rules.depth == 7);
    CHECK(state.rules.measured == state.document.resolved);
    CHECK(asks(update(state, RulesAction{FilterRules{"x"}})) == 0);
    const Update edited = update(state, RulesAction{SetNumber{"Wall.count", 3}});
    CHECK(asks(edited) == 1);
    CHECK(asks(update(edited.state, RulesAction{SetNumber{"Wall.count", 4}})) == 0);  // one at a time
}

TEST_CASE("steps of the history are gone to and come back from") {
    const EditorState before = opened();
    const EditorState state =
        after(before, {SetNumber{"Wall.count", 3}, SetNumber{"Wall.count", 4}, SetNumber{"Row.distance", 6}});
    const EditorState first = after(state, {GoInHistory{-3}});
    CHECK(first.document.grammar == before.document.grammar);
    CHECK(first.history.future.size() == 3);
    CHECK(after(first, {GoInHistory{3}}).document.grammar == state.document.grammar);
    CHECK(after(first, {GoInHistory{-5}}).document.grammar == before.document.grammar);
    CHECK(after(state, {GoInHistory{0}}).history.past.size() == 3);
}

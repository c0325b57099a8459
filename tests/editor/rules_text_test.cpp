#include <algorithm>

#include <catch2/catch.hpp>

#include "editor/model/update.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;

namespace {

const std::string drawings = "terminal A: path \"M-1 0H1V-3Z\"\n";

std::string text_with(const std::string& count) {
    return "lsystem 1\naxiom: Row(" + count + ")\nRow(m) : m > 0 -> [A] f(5) Row(m-1)\n" + drawings;
}

EditorState opened() {
    EditorState state = update(initial_state(), FileAction{OpenFile{"/a.lsys"}}).state;
    const Document document = with_grammar(empty_document(), parse_grammar(text_with("3")));
    state = update(state, FileAction{FileOpened{"/a.lsys", document, {}}}).state;
    return update(state, RulesAction{ShowRules{RulesView::text}}).state;
}

EditorState after(EditorState state, const std::vector<RulesAction>& actions) {
    for (const RulesAction& action : actions) state = update(std::move(state), action).state;
    return state;
}

/// The checks that are asked for.
std::vector<CheckText> checks(const Update& result) {
    std::vector<CheckText> found;
    for (const Request& request : result.requests)
        if (const auto* check = std::get_if<CheckText>(&request)) found.push_back(*check);
    return found;
}

TextFindings findings_of(const std::string& text) { return check_rule_text(text, {}, opened().document); }

}  // namespace

TEST_CASE("the text is that of the rules until it is written in") {
    EditorState state = opened();
    CHECK(state.rules.text.text == to_text(*state.document.grammar));
    state = after(state, {SetNumber{"Row.count", 5}});
    CHECK(state.rules.text.text == to_text(*state.document.grammar));
    CHECK_FALSE(state.rules.text.changed);
}

TEST_CASE("text with mistakes leaves the document, is kept, and its mistake is marked") {
    const EditorState before = opened();
    const std::string wrong = text_with("3)) Rwo(");
    const EditorState state = after(before, {WriteText{wrong}, ApplyText{}});
    CHECK(state.document.grammar == before.document.grammar);
    CHECK(state.history.past.empty());
    CHECK(state.rules.text.text == wrong);
    CHECK(state.rules.text.line == 2);
    CHECK(state.rules.text.goes_there);
    CHECK_FALSE(after(state, {TextPlaceShown{}}).rules.text.goes_there);
    CHECK(state.messages.back().kind == MessageKind::mistake);
    const EditorState left = after(state, {ShowRules{RulesView::rules}});
    CHECK(left.messages.back().kind == MessageKind::warning);
    CHECK(after(left, {ShowRules{RulesView::text}}).rules.text.text == wrong);
    CHECK(after(left, {SetNumber{"Row.count", 4}, ShowRules{RulesView::text}}).rules.text.text == wrong);
    CHECK(after(state, {RevertText{}}).rules.text.text == to_text(*before.document.grammar));
}

TEST_CASE("good text is one edit, and undone the text follows") {
    const EditorState before = opened();
    const EditorState state = after(before, {WriteText{text_with("7")}, ApplyText{}});
    CHECK(state.history.past.size() == 1);
    CHECK(to_text(*state.document.grammar).find("Row(7)") != std::string::npos);
    CHECK_FALSE(state.rules.text.changed);
    const EditorState back = after(state, {UndoEdit{}});
    CHECK(back.document.grammar == before.document.grammar);
    CHECK(back.rules.text.text == before.rules.text.text);
    const EditorState nothing = after(before, {WriteText{text_with("0")}, ApplyText{}});
    CHECK(nothing.document.grammar == before.document.grammar);
    CHECK(nothing.messages.back().text.find("nothing is drawn") != std::string::npos);
}

TEST_CASE("text is checked once at a time, and again if it was written in meanwhile") {
    const Update first = update(opened(), RulesAction{WriteText{text_with("4")}});
    REQUIRE(checks(first).size() == 1);
    const Update second = update(first.state, RulesAction{WriteText{text_with("45")}});
    CHECK(checks(second).empty());
    const Update answered = update(second.state, RulesAction{TextChecked{checks(first)[0].revision, {.picture = "old"}}});
    REQUIRE(checks(answered).size() == 1);
    CHECK(checks(answered)[0].text == text_with("45"));
    CHECK(answered.state.rules.text.findings.picture.empty());
    const Update done = update(answered.state, RulesAction{TextChecked{checks(answered)[0].revision, {.picture = "new"}}});
    CHECK(checks(done).empty());
    CHECK(done.state.rules.text.findings.picture == "new");
}

TEST_CASE("a check names mistakes by line and column, and says what would be drawn") {
    CHECK(findings_of(text_with("3")).picture == "It draws 3 elements");
    CHECK(findings_of(text_with("3")).drawn);
    CHECK(findings_of(text_with("0")).picture == "It draws nothing");
    const TextFindings wrong = findings_of(text_with("3) Rwo"));
    REQUIRE(wrong.mistakes.size() >= 1);
    CHECK(wrong.mistakes.front().place.line == 2);
    CHECK(wrong.mistakes.front().place.column > 10);
    CHECK(wrong.picture.empty());
    const TextFindings endless = findings_of("lsystem 1\naxiom: B\nB -> A [B] [B]\n" + drawings);
    CHECK_FALSE(endless.drawn);
    CHECK_FALSE((endless.mistakes.empty() && endless.picture.empty()));
    CHECK_FALSE(findings_of("lsystem 1\nuse \"gone.lsys\"\naxiom: A\n" + drawings).mistakes.empty());
}

TEST_CASE("places in a text are found as offsets") {
    CHECK(offset_of_place("ab\ncd\n", 1, 1) == 0);
    CHECK(offset_of_place("ab\ncd\n", 2, 2) == 4);
    CHECK(offset_of_place("ab\ncd\n", 2, 9) == 5);
    CHECK(offset_of_place("ab\ncd\n", 9, 1) == 6);
    CHECK(offset_of_place("", 1, 1) == 0);
}

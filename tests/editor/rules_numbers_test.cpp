#include <algorithm>

#include <catch2/catch.hpp>

#include "editor/model/number_feel.h"
#include "editor/model/update.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;

namespace {

const std::string text =
    "lsystem 1\n"
    "define bay = 80\n"
    "axiom: [Ring(12)] [Row(3)] +(55) B\n"
    "# All around.\n"
    "Ring(m) : m > 0 -> [f(50) A] +(30) Ring(m-1)\n"
    "Row(m) : m > 0 -> [A] -(90) f(bay) +(90) Row(m-1)\n"
    "except 2.3 -> B\n"
    "style 1: stroke black; stroke-width 2\n"
    "terminal A: style 1; path \"M-1 0H1V-3Z\"\nterminal B: path \"M-1 0H1V-5Z\"\n";

EditorState opened() {
    EditorState state = update(initial_state(), FileAction{OpenFile{"a.lsys"}}).state;
    return update(state, FileAction{FileOpened{"a.lsys", with_grammar(empty_document(), parse_grammar(text)), {}}}).state;
}

EditorState after(EditorState state, const std::vector<RulesAction>& actions) {
    for (const RulesAction& action : actions) state = update(std::move(state), action).state;
    return state;
}

const GrammarNumber& number(const EditorState& state, const std::string& name) {
    REQUIRE(state.rules.sheet);
    REQUIRE(state.rules.sheet->grammar == shown_document(state).grammar);
    const int index = find_number(*state.rules.sheet, name);
    INFO(name);
    REQUIRE(index >= 0);
    return state.rules.sheet->numbers[static_cast<std::size_t>(index)];
}

double value(const EditorState& state, const std::string& name) { return number(state, name).value; }

}  // namespace

TEST_CASE("the sheet says each listed number once, where it stands") {
    const EditorState state = opened();
    const RuleSheet& sheet = *state.rules.sheet;
    std::map<int, int> times;
    const auto count = [&](const std::vector<int>& numbers) {
        for (const int index : numbers) ++times[index];
    };
    for (const auto* numbers : {&sheet.counts, &sheet.constants, &sheet.picture}) count(*numbers);
    for (const auto* cards : {&sheet.rules, &sheet.exceptions, &sheet.styles})
        for (const RuleCard& card : *cards) count(card.numbers);
    for (std::size_t i = 0; i < sheet.numbers.size(); ++i) {
        INFO(sheet.numbers[i].name);
        const bool shown = sheet.numbers[i].rank != NumberRank::hidden;
        CHECK(times[static_cast<int>(i)] == (shown || sheet.numbers[i].name == "Row.distance" ? 1 : 0));
    }
    CHECK(sheet.counts.size() == 2);
    REQUIRE(sheet.rules.size() == 3);
    CHECK(sheet.rules[1].text == "Ring(m) : m > 0 -> [f(50) A] +(30) Ring(m-1)");
    CHECK(sheet.rules[1].comment == "All around.");
    CHECK(name_on_card(sheet.rules[0], "axiom.B.turn") == "B.turn");
}

TEST_CASE("a drag shows every value and records one edit") {
    const EditorState before = opened();
    EditorState state = after(before, {SetNumber{"axiom.B.turn", 56.2, true}, SetNumber{"axiom.B.turn", 58.9, true}});
    CHECK(value(state, "axiom.B.turn") == 59);  // in half degrees
    CHECK(state.document.grammar == before.document.grammar);
    state = after(state, {CommitPreview{}});
    CHECK(value(state, "axiom.B.turn") == 59);
    CHECK_FALSE(state.preview);
    REQUIRE(state.history.past.size() == 1);
    CHECK(state.history.past.back().label == "set axiom.B.turn");
    CHECK(after(state, {UndoEdit{}}).document.grammar == before.document.grammar);
}

TEST_CASE("Esc drops the drag and what is left of it") {
    const EditorState before = opened();
    const EditorState state =
        after(before, {SetNumber{"Ring.count", 15, true}, DropPreview{}, SetNumber{"Ring.count", 17, true}});
    CHECK_FALSE(state.preview);
    const EditorState released = after(state, {CommitPreview{}});
    CHECK(released.document.grammar == before.document.grammar);
    CHECK(released.history.past.empty());
    CHECK(value(after(released, {SetNumber{"Ring.count", 14, true}}), "Ring.count") == 14);
}

TEST_CASE("a drag of a ring's count closes it at every value") {
    const EditorState state = after(opened(), {SetNumber{"Ring.count", 9.6, true}});
    CHECK(value(state, "Ring.count") == 10);
    CHECK(value(state, "Ring.turn") == 36);
}

TEST_CASE("a drag of a ring's turn goes from one closed ring to the next") {
    EditorState state = after(opened(), {SetNumber{"Ring.turn", 34, true}});
    CHECK(value(state, "Ring.count") == 11);
    CHECK(value(state, "Ring.turn") == Approx(360.0 / 11));
    CHECK(to_text(*after(state, {CommitPreview{}}).document.grammar).find("+(360/11)") != std::string::npos);
    state = after(state, {SetNumber{"Ring.turn", -45, true}, CommitPreview{}});
    CHECK(value(state, "Ring.count") == 8);
    CHECK(value(state, "Ring.turn") == -45);
    CHECK(state.history.past.size() == 1);
}

TEST_CASE("exceptions where nothing stands any more go with the drag that takes them") {
    const EditorState state = after(opened(), {SetNumber{"Row.count", 2, true}, CommitPreview{}});
    CHECK(state.document.grammar->exceptions.empty());
    CHECK(std::ranges::any_of(state.messages, [](const EditorMessage& message) {
        return message.text.find("1 exception dropped (2.3)") != std::string::npos;
    }));
}

TEST_CASE("numbers are typed as expressions") {
    const auto typed = [](const std::string& name, const std::string& what) {
        return after(opened(), {TypeNumber{name, what}, EnterTyped{}});
    };
    CHECK(value(typed("bay", "80*1.5"), "bay") == 120);
    CHECK(value(typed("bay", "+=2"), "Row.distance") == 82);
    CHECK(value(typed("bay", " 150%"), "bay") == 120);
    CHECK(value(typed("Ring.A.distance", "bay/2"), "Ring.A.distance") == 40);
    CHECK(number(typed("Ring.A.distance", "bay/2"), "Ring.A.distance").written == "bay/2");
    const EditorState wrong = typed("bay", "80*");
    REQUIRE(wrong.rules.typed);
    CHECK(wrong.rules.typed->text == "80*");
    CHECK_FALSE(wrong.rules.typed->mistake.empty());
    CHECK(wrong.history.past.empty());
    CHECK_FALSE(after(wrong, {StopTyping{}}).rules.typed);
    CHECK(typed("bay", "80").history.past.empty());  // nothing is another one
}

TEST_CASE("numbers go back to what they were when the grammar was opened") {
    const EditorState state = after(opened(), {SetNumber{"bay", 100}, SetNumber{"Ring.count", 9}, ResetNumber{"bay"}});
    CHECK(value(state, "bay") == 80);
    CHECK(value(state, "Ring.count") == 9);
    CHECK(value(after(state, {ResetNumber{"Ring.count"}}), "Ring.turn") == 30);
    CHECK(after(state, {ResetNumber{"Nobody.count"}}).messages.back().kind == MessageKind::mistake);
}

TEST_CASE("a lock can be undone and holds in drags, typing and tools") {
    const EditorState before = opened();
    const EditorState locked = after(before, {LockNumber{"Row.distance"}});
    CHECK(locked.history.past.size() == 1);
    CHECK(locked.document.grammar == before.document.grammar);
    CHECK(after(locked, {LockNumber{"Row.distance"}}).history.past.size() == 1);  // it was locked already
    CHECK(same_document(after(locked, {UndoEdit{}}).document, before.document));
    CHECK(value(after(locked, {SetNumber{"bay", 90, true}}), "bay") == 80);
    CHECK(value(after(locked, {SetNumber{"bay", 90}}), "bay") == 80);
    CHECK(value(after(locked, {TypeNumber{"bay", "90"}, EnterTyped{}}), "bay") == 80);
    RandomizeOptions options{.angle = 5, .distance = 0.2, .seed = 7};
    options.only = {"Ring.A.distance"};
    const EditorState both = after(locked, {LockNumber{"Ring.A.distance"}});
    const Grammar wild = *use_tool(both.document, RandomizeEdit{options}).grammar;
    CHECK(to_text(wild).find("[f(50) A]") != std::string::npos);
    CHECK(value(after(locked, {LockNumber{"Row.distance", false}, SetNumber{"bay", 90}}), "bay") == 90);
}

TEST_CASE("steps suit kind and size, and stay in range") {
    const auto of = [](NumberKind kind, double low, double high, bool whole = false) {
        GrammarNumber number;
        number.kind = kind;
        number.low = low;
        number.high = high;
        number.whole = whole;
        return number;
    };
    const double endless = std::numeric_limits<double>::infinity();
    const auto felt = [](const GrammarNumber& number, double start, double wanted) {
        return felt_value(number_feel(number, start), wanted);
    };
    CHECK(felt(of(NumberKind::count, 0, endless, true), 5, 6.7) == 7);
    CHECK(felt(of(NumberKind::count, 0, endless, true), 5, -3) == 0);
    CHECK(felt(of(NumberKind::angle, -360, 360), 30, 31.3) == 31.5);
    CHECK(felt(of(NumberKind::share, 0, 1), 1, 1.4) == 1);
    CHECK(felt(of(NumberKind::scale, 0, endless), 0.8, -1) > 0);
    CHECK(felt(of(NumberKind::length, -endless, endless), 80, 83.1234) == Approx(83.1).margin(1e-12));
    CHECK(felt(of(NumberKind::length, -endless, endless), 80'000, 83'123.4) == Approx(83'100).margin(1e-9));
    CHECK(felt(of(NumberKind::length, -endless, endless), 0, 0.123456) == Approx(0.123).margin(1e-12));
}

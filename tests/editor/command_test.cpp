#include "editor/model/command.h"

#include <catch2/catch.hpp>

#include <set>

#include "editor/model/update.h"

using namespace rinceau;

namespace {

std::vector<std::string> words_of_list(const std::string& list) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < list.size();) {
        const auto end = std::min(list.find(' ', at), list.size());
        words.push_back(list.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

const Command* given_by(const KeyChord& pressed, const std::string& position = {}) {
    return command_of_key(commands(), meanings(pressed, position));
}

std::string name_given_by(const KeyChord& pressed, const std::string& position = {}) {
    const Command* command = given_by(pressed, position);
    return command != nullptr ? command->name : "nothing";
}

}  // namespace

TEST_CASE("every command has a name of its own, a place in a menu, a help sentence and an action") {
    std::set<std::string> names;
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        CHECK(names.insert(command.name).second);
        CHECK(command.name.find('.') != std::string::npos);
        CHECK_FALSE(command.menu.empty());
        CHECK_FALSE(command.label.empty());
        CHECK(command.help.size() > command.label.size());
        CHECK(command.help.back() == '.');
        CHECK(command.action != nullptr);
    }
    for (const char* area : {"file.", "edit.", "view.", "tools.", "analysis.", "help."}) {
        CAPTURE(area);
        CHECK(std::ranges::any_of(names, [&](const std::string& name) { return name.starts_with(area); }));
    }
}

TEST_CASE("labels within a menu differ") {
    std::set<std::string> seen;
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        CHECK(seen.insert(command.menu + '/' + command.label).second);
    }
}

TEST_CASE("every shortcut can be pressed, and gives its command alone") {
    std::set<std::string> seen;
    // What moves about in a panel and presses its buttons is not to be taken away from it.
    const std::set<std::string> of_panels{"Left", "Right", "Up", "Down", "Space", "Enter", "Tab", "F10"};
    for (const Command& command : commands()) {
        for (const std::string& text : words_of_list(command.shortcut)) {
            CAPTURE(command.name, text);
            const auto chord = parse_chord(text);
            REQUIRE(chord);
            CHECK_FALSE(of_panels.contains(text));
            CHECK(seen.insert(text).second);
            CHECK(name_given_by(*chord) == command.name);
        }
    }
}

TEST_CASE("every command that can be given at first leaves a whole document, and what it edits can be undone") {
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        const EditorState state = initial_state();
        if (!is_enabled(command, state)) continue;
        const EditorState after = update(state, command.action(state)).state;
        REQUIRE(after.document.grammar);
        REQUIRE(after.document.resolved);
        if (same_document(after.document, state.document) || command.name.starts_with("file.")) continue;
        CHECK(same_document(update(after, RulesAction{UndoEdit{}}).state.document, state.document));
    }
}

TEST_CASE("the habitual keys do what they do everywhere") {
    CHECK(name_given_by({"Z", true}) == "edit.undo");
    CHECK(name_given_by({"Y", true}) == "edit.redo");
    CHECK(name_given_by({"Z", true, true}) == "edit.redo");
    CHECK(name_given_by({"S", true}) == "file.save");
    CHECK(name_given_by({"Q", true}) == "file.quit");
    CHECK(name_given_by({"0"}) == "view.fit");
    CHECK(name_given_by({"F1"}) == "help.help");
    CHECK(name_given_by({"P", true}) == "help.palette");
    CHECK(name_given_by({"P", true, true}) == "help.palette");
    CHECK(name_given_by({"Tab", true}) == "panel.next");
    CHECK(name_given_by({"Z"}) == "nothing");
}

TEST_CASE("a sign is found where the keyboard has it") {
    // American: + is the shifted =, which need not be held.
    CHECK(name_given_by({"=", true, true}) == "view.larger_text");
    // German: + has a key of its own.
    CHECK(name_given_by({"+", true, true}) == "view.larger_text");
    // French: the digits are shifted; the key of 0 writes another sign.
    CHECK(name_given_by({"\xc3\x80"}, "0") == "view.fit");
}

TEST_CASE("chords are read as they are written, and nothing else is") {
    CHECK(parse_chord("Ctrl+Shift+S") == KeyChord{"S", true, true, false});
    CHECK(parse_chord("Ctrl++") == KeyChord{"+", true});
    CHECK(parse_chord("+") == KeyChord{"+"});
    CHECK(parse_chord("F12") == KeyChord{"F12"});
    for (const char* wrong : {"", "Ctrl+", "s", "Shift+Ctrl+S", "Ctrl+Ctrl+S", "F0", "Del", "Ctrl+Save", "\xc3\x84"}) {
        CAPTURE(wrong);
        CHECK_FALSE(parse_chord(wrong));
    }
    CHECK(parse_chords("Ctrl+Y  nonsense Ctrl+Shift+Z").size() == 2);
}

TEST_CASE("what is typed into a text field is no command, and what does not write is") {
    for (const KeyChord& text : {KeyChord{"A"}, KeyChord{"0"}, KeyChord{"Delete"}, KeyChord{"Z", true}, KeyChord{"V", true},
                                 KeyChord{"Left", true}, KeyChord{"Escape"}})
        CHECK(belongs_to_text(text));
    for (const KeyChord& command : {KeyChord{"S", true}, KeyChord{"F1"}, KeyChord{"P", true}, KeyChord{"Enter", true}})
        CHECK_FALSE(belongs_to_text(command));
}

TEST_CASE("commands are found by parts of their names, in any order, labels first") {
    const auto found = matching_commands(commands(), "text LARGER");
    REQUIRE_FALSE(found.empty());
    CHECK(found.front()->name == "view.larger_text");
    CHECK(matching_commands(commands(), "").size() == commands().size());
    CHECK(matching_commands(commands(), "no such thing at all").empty());
}

// Actions of files, without files.

#include "editor/model/new_document.h"
#include "editor/model/state_preferences.h"
#include "lsystem/interpret.h"
#include "tests/editor/editor_desk.h"

using namespace rinceau;

namespace {

template <class Wanted>
const Wanted* asked_for(const Update& update) {
    for (const Request& request : update.requests)
        if (const auto* wanted = std::get_if<Wanted>(&request)) return wanted;
    return nullptr;
}

EditorState edited() {
    EditorState state = update(initial_state(), FileAction{NewDocument{}}).state;
    state.document.grammar = std::make_shared<const Grammar>(*state.document.grammar);
    return state;
}

Update after(EditorState state, const Action& action) { return update(std::move(state), action); }

}  // namespace

TEST_CASE("a new document draws three squares and is no unsaved work") {
    const Update made = after(initial_state(), FileAction{NewDocument{}});
    CHECK(interpret(*made.state.document.resolved).size() == 3);
    CHECK_FALSE(has_unsaved_changes(made.state));
    CHECK(made.state.file.path.empty());
}

TEST_CASE("whatever makes the document go asks first if it is not saved") {
    const std::vector<FileAction> leaving{NewDocument{}, OpenFile{"x.svg"}, OpenSample{"x.lsys"}, CloseFile{}, QuitEditor{}};
    for (const FileAction& action : leaving) {
        INFO(action.index());
        const EditorState before = edited();
        const Update asked = after(before, action);
        REQUIRE(asked.state.file.question);
        CHECK(asked.requests.empty());
        CHECK(same_document(asked.state.document, before.document));

        const Update cancelled = after(asked.state, FileAction{AnswerFileQuestion{FileAnswer::cancel}});
        CHECK_FALSE(cancelled.state.file.question);
        CHECK(cancelled.requests.empty());
        CHECK_FALSE(after(asked.state, FileAction{AnswerFileQuestion{FileAnswer::discard}}).requests.empty());
        // To be saved it needs a name; then what was asked for goes on.
        const Update saving = after(asked.state, FileAction{AnswerFileQuestion{FileAnswer::save}});
        REQUIRE(saving.state.dialog.file);
        const Update named = after(saving.state, FileAction{SaveFileAs{"/a/b.lsys"}});
        REQUIRE(asked_for<WriteDocument>(named));
        const Update saved = after(named.state, FileAction{FileSaved{"/a/b.lsys", named.state.document}});
        CHECK_FALSE(saved.state.dialog.file);
        CHECK_FALSE(saved.state.file.after_saving);
        const bool went_on = asked_for<ReadDocument>(saved) || asked_for<CloseWindow>(saved) ||
                             saved.state.document.grammar != before.document.grammar;
        CHECK(went_on);
        // Whoever gives up naming the file stays.
        const Update stayed = after(saving.state, DialogAction{CloseFileDialog{}});
        CHECK_FALSE(stayed.state.file.after_saving);
    }
}

TEST_CASE("work that is done while a file is read is not lost to it") {
    EditorState state = after(initial_state(), FileAction{NewDocument{}}).state;
    state = after(state, FileAction{OpenFile{"/x.lsys"}}).state;
    state.document.grammar = std::make_shared<const Grammar>(*state.document.grammar);
    const Document before = state.document;
    const Update opened = after(state, FileAction{FileOpened{"/x.lsys", empty_document()}});
    CHECK(opened.state.file.question);
    CHECK(same_document(opened.state.document, before));
}

TEST_CASE("only the file that was asked for last is opened") {
    EditorState state = after(initial_state(), FileAction{OpenFile{"/first.lsys"}}).state;
    state = after(state, FileAction{OpenFile{"/second.lsys"}}).state;
    state = after(state, FileAction{FileOpened{"/first.lsys", new_document()}}).state;
    CHECK(state.file.path.empty());
    state = after(state, FileAction{FileOpened{"/second.lsys", new_document()}}).state;
    CHECK(state.file.path == "/second.lsys");
    CHECK(state.file.recent == std::vector<std::string>{"/second.lsys"});
}

TEST_CASE("a sample is a beginning without a file") {
    EditorState state = after(initial_state(), FileAction{OpenSample{"/s.lsys"}}).state;
    state = after(state, FileAction{FileOpened{"/s.lsys", new_document()}}).state;
    CHECK(state.file.path.empty());
    CHECK(state.file.recent.empty());
    CHECK(after(state, FileAction{SaveFile{}}).state.dialog.file);
}

TEST_CASE("locks are unsaved work in a project and not in a grammar") {
    EditorState state = after(initial_state(), FileAction{NewDocument{}}).state;
    state.document.locked.insert("Row.count");
    state.file.path = "/x.rinceau";
    CHECK(has_unsaved_changes(state));
    state.file.path = "/x.lsys";
    CHECK_FALSE(has_unsaved_changes(state));
}

TEST_CASE("an export that runs is waited for before the window closes") {
    EditorState state = after(initial_state(), FileAction{ExportFile{"/x.png", "png"}}).state;
    const Update quitting = after(state, FileAction{QuitEditor{}});
    CHECK_FALSE(asked_for<CloseWindow>(quitting));
    CHECK(asked_for<CloseWindow>(after(quitting.state, FileAction{FileExported{"/x.png", {}}})));
    const Update failed = after(quitting.state, FileAction{ExportFailed{"/x.png", "no"}});
    CHECK_FALSE(asked_for<CloseWindow>(failed));
}

TEST_CASE("a copy for emergencies is asked for at once, then once an interval, and goes with the unsaved work") {
    EditorState state = edited();
    const auto tick = [&](double seconds) {
        Update ticked = after(state, RecoveryAction{Tick{seconds}});
        state = ticked.state;
        return ticked;
    };
    const auto edit = [&] { state.document.grammar = std::make_shared<const Grammar>(*state.document.grammar); };
    REQUIRE(asked_for<WriteRecovery>(tick(1)));
    state = after(state, RecoveryAction{RecoveryWritten{state.document}}).state;
    CHECK_FALSE(asked_for<WriteRecovery>(tick(100)));  // nothing new
    edit();
    state.recovery.last = 100;
    CHECK_FALSE(asked_for<WriteRecovery>(tick(101)));
    CHECK(wants_tick(state));
    CHECK(asked_for<WriteRecovery>(tick(159)));         // never older than a minute
    CHECK_FALSE(asked_for<WriteRecovery>(tick(1000)));  // the last one is still being written
    state = after(state, RecoveryAction{RecoveryFailed{"disk full"}}).state;
    CHECK(state.messages.back().text.find("disk full") != std::string::npos);
    CHECK(asked_for<WriteRecovery>(tick(1060)));
    state = after(state, RecoveryAction{RecoveryWritten{state.document}}).state;
    state.file.saved = state.document;
    CHECK(asked_for<RemoveRecovery>(tick(1061)));
    CHECK_FALSE(wants_tick(state));
}

TEST_CASE("preferences are written when they change and when the window closes") {
    EditorState state = initial_state();
    CHECK_FALSE(asked_for<WritePreferences>(after(state, RecoveryAction{Tick{1}})));
    state.shell.dark = !state.shell.dark;
    const Update ticked = after(state, RecoveryAction{Tick{2}});
    REQUIRE(asked_for<WritePreferences>(ticked));
    CHECK(asked_for<WritePreferences>(ticked)->preferences.dark == state.shell.dark);
    CHECK_FALSE(asked_for<WritePreferences>(after(ticked.state, RecoveryAction{Tick{3}})));
    CHECK(asked_for<WritePreferences>(after(state, FileAction{QuitEditor{}})));
}

TEST_CASE("preferences come back as they were, and a broken file gives the usual ones") {
    Preferences preferences;
    preferences.dark = false;
    preferences.autosave_seconds = 20;
    preferences.recent = {"/a b/c.lsys", "/d.svg"};
    const std::string text = to_json(preferences, "{\"of another program\": [1]}");
    CHECK(parse_preferences(text).preferences == preferences);
    CHECK(text.find("of another program") != std::string::npos);
    for (const char* broken : {"{", "[]", "3", "\xff\xfe"}) {
        const PreferencesInFile read = parse_preferences(broken);
        CHECK(read.preferences == Preferences{});
        CHECK_FALSE(read.mistake.empty());
        CHECK(parse_preferences(to_json(preferences, broken)).preferences == preferences);
    }
    const PreferencesInFile odd = parse_preferences(
        "{\"dark\": 1, \"text_scale\": 1e9, \"autosave_seconds\": 0, \"panels\": 3, \"recent\": [1, \"/x\", null]}");
    CHECK(odd.mistake.empty());
    CHECK(odd.preferences.recent == std::vector<std::string>{"/x"});
    CHECK(odd.preferences.autosave_seconds == Preferences{}.autosave_seconds);
}

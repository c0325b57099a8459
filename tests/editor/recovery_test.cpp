// What survives a crash. A window that crashes is a process that is killed.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "lsystem/grammar_text.h"
#include "tests/editor/editor_desk.h"

using namespace rinceau;

namespace {

/// Opens a sample in another process, edits it, waits for the copy and is killed. The text of its grammar.
std::string crash(const KeptFolders& kept, const std::string& sample) {
    int channel[2];
    REQUIRE(::pipe(channel) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        EditorDesk desk(kept);
        desk.open(sample);
        desk.edit();
        desk.act(RecoveryAction{Tick{1}});
        desk.until([&] { return desk.state().recovery.kept.has_value(); });
        const std::string text = to_text(*desk.state().document.grammar);
        if (::write(channel[1], text.data(), text.size()) < 0) ::_exit(1);
        ::kill(::getpid(), SIGKILL);
    }
    ::close(channel[1]);
    std::string text;
    std::array<char, 4096> piece;
    for (ssize_t count = 0; (count = ::read(channel[0], piece.data(), piece.size())) > 0;)
        text.append(piece.data(), static_cast<std::size_t>(count));
    ::close(channel[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    return text;
}

std::size_t files_in(const std::string& folder) {
    std::error_code error;
    std::size_t count = 0;
    for (std::filesystem::directory_iterator at(folder, error); !error && at != std::filesystem::directory_iterator(); ++at)
        ++count;
    return count;
}

void look(EditorDesk& desk) {
    desk.act(RecoveryAction{LookForRecoverables{}});
    desk.until([&] { return !desk.state().recovery.found.empty(); });
}

}  // namespace

TEST_CASE("what a killed window had not saved is offered, opened as it was, and saved where it came from") {
    const TestFolder folder;
    const KeptFolders kept{folder / "state", {}};
    std::filesystem::copy_file(sample_path("border.lsys"), folder / "border.lsys");
    const std::string text = crash(kept, folder / "border.lsys");
    EditorDesk desk(kept);
    look(desk);
    REQUIRE(desk.state().recovery.found.size() == 1);
    const Recoverable found = desk.state().recovery.found.front();
    CHECK(found.path == folder / "border.lsys");
    CHECK(found.mistake.empty());

    desk.act(RecoveryAction{OpenRecoverable{found.file}});
    desk.until([&] { return !is_busy(desk.state()); });
    CHECK(to_text(*desk.state().document.grammar) == text);
    CHECK(has_unsaved_changes(desk.state()));
    CHECK(desk.state().file.path == folder / "border.lsys");

    SECTION("and crashes again") {
        const std::string again = crash(kept, folder / "border.lsys");
        EditorDesk next(kept);
        look(next);
        CHECK(next.state().recovery.found.size() == 1);  // the other one belongs to a window that lives
        CHECK(again == text);
    }
    SECTION("and is saved") {
        desk.act(FileAction{SaveFile{}});
        desk.until([&] { return !is_busy(desk.state()); });
        CHECK_FALSE(desk.state().file.question);
        CHECK(read_input(folder / "border.lsys") == text);
        desk.act(RecoveryAction{Tick{5}});
        desk.act(RecoveryAction{LookForRecoverables{}});
        desk.act(FileAction{QuitEditor{}});
    }
    SECTION("and the file was changed by another program meanwhile") {
        std::ofstream(folder / "border.lsys") << "something else";
        desk.act(FileAction{SaveFile{}});
        desk.until([&] { return !is_busy(desk.state()); });
        CHECK(desk.state().file.question);
        CHECK(read_input(folder / "border.lsys") == "something else");
    }
}

TEST_CASE("windows that end in order leave nothing behind") {
    const TestFolder folder;
    {
        EditorDesk desk(KeptFolders{folder / "state", folder / "config"});
        desk.open(sample_path("border.lsys"));
        desk.edit();
        desk.act(RecoveryAction{Tick{1}});
        desk.until([&] { return desk.state().recovery.kept.has_value(); });
        CHECK(files_in(folder / "state/recovery") == 2);  // the copy and its lock
        desk.act(FileAction{QuitEditor{}});
        desk.act(FileAction{AnswerFileQuestion{FileAnswer::discard}});
    }
    CHECK(files_in(folder / "state/recovery") == 0);
    CHECK(files_in(folder / "state/open") == 0);
    CHECK(std::filesystem::exists(folder / "config/preferences.json"));
}

TEST_CASE("copies are discarded or kept for later as the user says, and a broken one is told") {
    const TestFolder folder;
    const KeptFolders kept{folder / "state", {}};
    crash(kept, sample_path("border.lsys"));
    std::ofstream(folder / "state/recovery/1-0.rinceau") << "{\"format\": \"rinceau-project\"";
    EditorDesk desk(kept);
    look(desk);
    REQUIRE(desk.state().recovery.found.size() == 2);
    const auto broken =
        std::ranges::find_if(desk.state().recovery.found, [](const auto& entry) { return !entry.mistake.empty(); });
    REQUIRE(broken != desk.state().recovery.found.end());
    desk.act(RecoveryAction{DiscardRecoverable{broken->file}});
    CHECK(desk.state().recovery.found.size() == 1);
    desk.act(RecoveryAction{PostponeRecovery{}});
    CHECK(desk.state().recovery.found.empty());
    look(desk);
    CHECK(desk.state().recovery.found.size() == 1);
}

TEST_CASE("a copy that cannot be written leaves the one before as it was") {
    const TestFolder folder;
    RecoveryFiles files(folder / "recovery");
    files.write("first");
    std::string copy;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "recovery"))
        if (entry.path().extension() == ".rinceau") copy = entry.path().string();
    REQUIRE(read_input(copy) == "first");
    // The folder becomes unusable for a new file: what is written beside the copy cannot be made.
    std::filesystem::rename(folder / "recovery", folder / "moved");
    CHECK_THROWS(files.write("second"));
    CHECK(read_input(folder / "moved/" + std::filesystem::path(copy).filename().string()) == "first");
}

// Opening, saving and exporting with the real files.

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "files/signals_held.h"
#include "lsystem/grammar_text.h"
#include "tests/editor/editor_desk.h"

using namespace rinceau;

namespace {

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

bool is_settled(const EditorDesk& desk) { return !is_busy(desk.state()); }

void save_as(EditorDesk& desk, const std::string& path, bool replace = false) {
    desk.act(FileAction{SaveFileAs{path, replace}});
    desk.until([&] { return is_settled(desk); });
}

/// A window takes the lock of its file behind the user's back: no answer tells of it.
void wait_for_lock(const std::string& folder) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!std::filesystem::exists(folder) || std::filesystem::is_empty(folder)) {
        if (std::chrono::steady_clock::now() > end) FAIL("no window took a lock");
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// While it lives, folders that their owner has closed are closed to the test, too, even if root runs it.
class PlainUser {
  public:
    PlainUser() {
        constexpr uid_t nobody = 65534;
        if (::geteuid() == 0) changed_ = ::seteuid(nobody) == 0;
    }
    PlainUser(const PlainUser&) = delete;
    PlainUser& operator=(const PlainUser&) = delete;
    ~PlainUser() {
        if (changed_ && ::seteuid(0) != 0) std::abort();
    }

  private:
    bool changed_ = false;
};

/// While it lives, files may not become larger than a few bytes.
class SmallFiles {
  public:
    SmallFiles() {
        let_writes_fail();
        constexpr rlim_t few_bytes = 10;
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = few_bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;
    ~SmallFiles() { ::setrlimit(RLIMIT_FSIZE, &before_); }

  private:
    rlimit before_{};
};

}  // namespace

TEST_CASE("a document is saved, read again and not unsaved any more") {
    const TestFolder folder;
    EditorDesk desk;
    desk.open(sample_path("border.lsys"));
    CHECK_FALSE(has_unsaved_changes(desk.state()));
    desk.edit();
    CHECK(has_unsaved_changes(desk.state()));
    const std::string text = to_text(*desk.state().document.grammar);
    for (const char* name : {"border.lsys", "border.json", "border.rinceau"}) {
        save_as(desk, folder / name);
        CHECK_FALSE(has_unsaved_changes(desk.state()));
        CHECK(desk.state().file.path == folder / name);
        EditorDesk other;
        other.open(folder / name);
        CHECK(to_text(*other.state().document.grammar) == text);
        CHECK_FALSE(has_unsaved_changes(other.state()));
    }
    CHECK(read_input(folder / "border.lsys") == text);
    CHECK(desk.state().file.recent.front() == folder / "border.rinceau");
}

TEST_CASE("what cannot be saved is told with a cure, and the document stays unsaved and open") {
    const TestFolder folder;
    EditorDesk desk;
    desk.open(sample_path("border.lsys"));
    desk.edit();
    const Document before = desk.state().document;
    const auto fails = [&](const std::string& path, const std::string& cure) {
        save_as(desk, path, true);
        INFO(path);
        CHECK(desk.was_told(path));
        CHECK(desk.was_told(cure));
        CHECK(has_unsaved_changes(desk.state()));
        CHECK(same_document(desk.state().document, before));
        CHECK(desk.state().file.path == sample_path("border.lsys"));
    };
    SECTION("a full disk") {
        std::filesystem::create_symlink("/dev/full", folder / "full.lsys");
        fails(folder / "full.lsys", "make room on the disk");
    }
    SECTION("a file that would become larger than is allowed") {
        put(folder / "old.lsys", "old");
        {
            const SmallFiles small;
            fails(folder / "old.lsys", "files as large as this one are not allowed here");
        }
        CHECK(read_input(folder / "old.lsys") == "old");
        CHECK(std::distance(std::filesystem::directory_iterator(folder.name()), {}) == 1);
    }
    SECTION("a folder that is gone") { fails(folder / "gone/border.lsys", "make its folder first"); }
    SECTION("a file in the place of the folder") {
        put(folder / "file", "");
        fails(folder / "file/border.rinceau", "write in another folder");
    }
    SECTION("a folder that may not be written, with the old file in it") {
        put(folder / "old.lsys", "old");
        ::chmod(folder.name().c_str(), S_IRUSR | S_IXUSR | S_IROTH | S_IXOTH);
        {
            const PlainUser user;
            fails(folder / "old.lsys", "write under another name or in another folder");
            fails(folder / "new.lsys", "write under another name or in another folder");
        }
        ::chmod(folder.name().c_str(), S_IRWXU);
        CHECK(read_input(folder / "old.lsys") == "old");
    }
}

TEST_CASE("leaving goes on after saving, and not after a failure") {
    const TestFolder folder;
    EditorDesk desk;
    desk.open(sample_path("border.lsys"));
    save_as(desk, folder / "border.lsys");
    desk.edit();
    SECTION("saved") {
        desk.act(FileAction{QuitEditor{}});
        REQUIRE(desk.state().file.question);
        desk.act(FileAction{AnswerFileQuestion{FileAnswer::save}});
        desk.until([&] { return desk.effects().wants_to_close(); });
        CHECK_FALSE(has_unsaved_changes(desk.state()));
    }
    SECTION("not saved") {
        desk.changeable().file.path = folder / "gone/border.lsys";
        desk.act(FileAction{QuitEditor{}});
        desk.act(FileAction{AnswerFileQuestion{FileAnswer::save}});
        desk.until([&] { return is_settled(desk); });
        CHECK_FALSE(desk.effects().wants_to_close());
        CHECK(has_unsaved_changes(desk.state()));
        CHECK_FALSE(desk.state().file.after_saving);
    }
}

TEST_CASE("another file, and a file that another program has changed, are replaced only when the user says so") {
    const TestFolder folder;
    EditorDesk desk;
    desk.open(sample_path("border.lsys"));
    put(folder / "other.lsys", "other");
    save_as(desk, folder / "other.lsys");
    REQUIRE(desk.state().file.question);
    CHECK(read_input(folder / "other.lsys") == "other");
    desk.act(FileAction{AnswerFileQuestion{FileAnswer::replace}});
    desk.until([&] { return is_settled(desk); });
    CHECK(read_input(folder / "other.lsys") == to_text(*desk.state().document.grammar));

    put(folder / "other.lsys", "changed by another program");
    desk.edit();
    desk.act(FileAction{SaveFile{}});
    desk.until([&] { return is_settled(desk); });
    REQUIRE(desk.state().file.question);
    CHECK(read_input(folder / "other.lsys") == "changed by another program");
    SECTION("not at all") {
        desk.act(FileAction{AnswerFileQuestion{FileAnswer::cancel}});
        CHECK(has_unsaved_changes(desk.state()));
    }
    SECTION("overwritten") {
        desk.act(FileAction{AnswerFileQuestion{FileAnswer::replace}});
        desk.until([&] { return is_settled(desk); });
        CHECK(read_input(folder / "other.lsys") == to_text(*desk.state().document.grammar));
    }
    SECTION("saved elsewhere") {
        desk.act(FileAction{AnswerFileQuestion{FileAnswer::save_as}});
        CHECK(desk.state().dialog.file);
    }
}

TEST_CASE("a broken file is told with its place and leaves the document and its history alone") {
    const TestFolder folder;
    EditorDesk desk;
    desk.open(sample_path("border.lsys"));
    const Document before = desk.state().document;
    const auto fails = [&](const std::string& name, const std::string& text, const std::string& place) {
        put(folder / name, text);
        desk.open(folder / name);
        INFO(name);
        CHECK(desk.was_told((folder / name) + place));
        CHECK(same_document(desk.state().document, before));
        CHECK(desk.state().file.path == sample_path("border.lsys"));
    };
    fails("broken.lsys", "lsystem 1\naxiom: A(\n", ":2:");
    fails("broken.svg", "<svg>\n<path d=\"M0 0\"\n</svg>", ":");
    fails("broken.json", "{\"format\": \"rinceau-grammar\",\n]", ":2:");
    fails("broken.rinceau", "{\"format\": \"rinceau-project\",\n \"version\": 1, \"grammar\": }", ":2:");
    fails("half.rinceau", "{\"format\": \"rinceau-project\", \"version\": 1, \"grammar\": \"lsystem 1\\naxiom: A(\"}",
          ": grammar, line 2");
    fails("newer.rinceau", "{\"format\": \"rinceau-project\", \"version\": 99}", ": was saved by a newer Rinceau");
    fails("folder.svg/", "", ":");
}

TEST_CASE("a drawing is seen at once, and its rules are no unsaved change") {
    EditorDesk desk;
    desk.act(FileAction{OpenFile{sample_path("facade.svg")}});
    desk.until([&] { return desk.state().picture != nullptr; });
    const auto elements = desk.state().document.drawing->elements.size();
    if (!desk.state().document.report) CHECK(desk.state().picture->items.size() == elements);
    desk.until([&] { return is_settled(desk) && desk.state().document.report; });
    CHECK_FALSE(desk.state().document.grammar->productions.empty());
    CHECK_FALSE(has_unsaved_changes(desk.state()));
    desk.act(FileAction{SaveFile{}});
    REQUIRE(desk.state().dialog.file);  // a drawing is never written over
    CHECK(desk.state().dialog.file->text == "facade.rinceau");
}

TEST_CASE("every export draws or says what it must, asks before it replaces, and can be stopped") {
    const TestFolder folder;
    EditorDesk desk;
    desk.open(sample_path("rosette.lsys"));
    const auto write = [&](const std::string& name, const std::string& format, bool replace = false) {
        desk.act(FileAction{ExportFile{folder / name, format, {}, replace}});
        desk.until([&] { return is_settled(desk); });
    };
    write("rosette.png", "png");
    CHECK(read_input(folder / "rosette.png").substr(1, 3) == "PNG");
    write("rosette.l", "cpfg");
    CHECK(std::filesystem::exists(folder / "rosette.map"));
    CHECK_FALSE(desk.state().file.question);

    std::filesystem::remove(folder / "rosette.l");
    put(folder / "rosette.map", "mine");
    write("rosette.l", "cpfg");
    REQUIRE(desk.state().file.question);
    CHECK(read_input(folder / "rosette.map") == "mine");
    CHECK_FALSE(std::filesystem::exists(folder / "rosette.l"));
    desk.act(FileAction{AnswerFileQuestion{FileAnswer::replace}});
    desk.until([&] { return is_settled(desk); });
    CHECK(std::filesystem::exists(folder / "rosette.l"));
    CHECK(read_input(folder / "rosette.map") != "mine");

    write("gone/rosette.svg", "picture-svg");
    CHECK(desk.was_told("gone/rosette.svg: cannot be written"));

    desk.act(FileAction{ExportFile{folder / "stopped.svg", "picture-svg"}});
    desk.act(FileAction{CancelExport{}});
    desk.until([&] { return is_settled(desk); });
    CHECK(desk.was_told("The export was stopped") != std::filesystem::exists(folder / "stopped.svg"));
}

TEST_CASE("two windows with one file open warn, and a window that has closed it does not") {
    const TestFolder folder;
    const KeptFolders kept{folder / "state", {}};
    EditorDesk first(kept);
    EditorDesk second(kept);
    first.open(sample_path("border.lsys"));
    wait_for_lock(folder / "state/open");
    second.open(sample_path("border.lsys"));
    second.until([&] { return second.was_told("is open in another window"); });
    CHECK_FALSE(first.was_told("is open in another window"));
    first.act(FileAction{CloseFile{}});
    second.act(FileAction{CloseFile{}});
    save_as(first, folder / "a.lsys");  // after the file was let go
    save_as(second, folder / "b.lsys");
    EditorDesk third(kept);
    third.open(sample_path("border.lsys"));
    save_as(third, folder / "c.lsys");
    CHECK_FALSE(third.was_told("is open in another window"));
}

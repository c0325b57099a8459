// The dialog for choosing a file, by keyboard.

#include "editor/model/file_dialog.h"

#include "editor/model/export_target.h"
#include "tests/editor/editor_desk.h"

using namespace rinceau;

namespace {

FileDialog listed(FilePurpose purpose) {
    return with_entries({.purpose = purpose}, "/art",
                        {{.name = "vine.lsys"},
                         {.name = "Rose.svg"},
                         {.name = ".secret.svg"},
                         {.name = "notes.txt"},
                         {.name = "old", .folder = true},
                         {.name = "rose.rinceau"}},
                        false);
}

std::vector<std::string> shown_names(const FileDialog& dialog) {
    std::vector<std::string> names;
    for (const std::size_t entry : shown_entries(dialog)) names.push_back(dialog.entries[entry].name);
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a list shows folders first and what the purpose has use for") {
    FileDialog dialog = listed(FilePurpose::open);
    CHECK(shown_names(dialog) == Names{"old", "rose.rinceau", "Rose.svg", "vine.lsys"});
    dialog.hidden = dialog.all_kinds = true;
    CHECK(shown_names(dialog) == Names{"old", ".secret.svg", "notes.txt", "rose.rinceau", "Rose.svg", "vine.lsys"});
    CHECK(shown_names(listed(FilePurpose::save)) == Names{"old", "rose.rinceau", "vine.lsys"});
}

TEST_CASE("typing narrows the list of files to open, Enter takes the first, and arrows choose") {
    FileDialog dialog = with_text(listed(FilePurpose::open), "ROSE");
    CHECK(shown_names(dialog) == Names{"rose.rinceau", "Rose.svg"});
    CHECK(chosen_path(dialog) == "rose.rinceau");
    dialog = with_row_moved(dialog, 1);
    CHECK(chosen_path(dialog) == "Rose.svg");
    CHECK(chosen_path(with_row_moved(dialog, 100)) == "Rose.svg");
    CHECK(chosen_path(with_row_moved(dialog, -100)) == "rose.rinceau");
    CHECK(chosen_path(with_row_moved(listed(FilePurpose::open), 1)) == "old");
    CHECK(chosen_path(with_text(dialog, "../x.svg")) == "../x.svg");
    CHECK(chosen_path(with_text(dialog, "~/x.svg")) == "~/x.svg");
    CHECK(chosen_path(with_text(dialog, "nothing like it")) == "nothing like it");
}

TEST_CASE("the name of a file to be gets the ending of its kind, and a typed ending says the kind") {
    FileDialog dialog = with_text(listed(FilePurpose::save), "rose");
    CHECK(chosen_path(dialog) == "rose.rinceau");
    dialog = with_text(dialog, "rose.lsys");
    CHECK(dialog.kind == FileKind::grammar);
    CHECK(with_file_kind(dialog, FileKind::json_grammar).text == "rose.json");
    CHECK(chosen_path(with_text(dialog, "my.drawing")) == "my.drawing.lsys");
    CHECK(chosen_path(with_text(dialog, "/tmp/")) == "/tmp/");
    CHECK(chosen_path(with_row_moved(dialog, 1)) == "old");
    CHECK(with_row_moved(dialog, 3).text == "vine.lsys");
}

TEST_CASE("the ending follows the format of an export") {
    FileDialog dialog = with_text({.purpose = FilePurpose::export_picture, .format = "picture-svg"}, "rose.svg");
    dialog = with_export_format(dialog, "png");
    CHECK(dialog.text == "rose.png");
    CHECK(with_export_format(dialog, "lpy").text == "rose.lpy");
    for (const ExportTarget& target : export_targets()) CHECK_FALSE(target.help.empty());
}

TEST_CASE("folders are gone into, up and made, and a file is opened by its name alone") {
    const TestFolder folder;
    std::filesystem::create_directories(folder / "a/b");
    std::filesystem::copy_file(sample_path("border.lsys"), folder / "a/b/border.lsys");
    EditorDesk desk;
    desk.changeable().file.last_folder = folder.name();
    desk.act(DialogAction{ShowFileDialog{FilePurpose::open}});
    const auto folder_shown = [&] {
        return desk.state().dialog.file->listing ? std::string() : desk.state().dialog.file->folder;
    };
    const auto shows = [&](const std::string& name) { return [&, name] { return folder_shown() == name; }; };
    const auto type = [&](const std::string& text) {
        desk.act(DialogAction{TypeInFileDialog{text}});
        desk.act(DialogAction{AcceptFileDialog{}});
    };
    desk.until(shows(folder.name()));
    type("a");
    desk.until(shows(folder / "a"));
    CHECK(desk.state().dialog.file->text.empty());
    type("./b/");
    desk.until(shows(folder / "a/b"));
    desk.act(DialogAction{GoToFolder{".."}});
    desk.until(shows(folder / "a"));
    desk.act(DialogAction{NameNewFolder{"new"}});
    desk.act(DialogAction{MakeNewFolder{}});
    desk.until(shows(folder / "a/new"));
    desk.act(DialogAction{NameNewFolder{"../b"}});
    desk.act(DialogAction{MakeNewFolder{}});
    desk.until([&] { return !desk.state().dialog.file->mistake.empty(); });
    type("gone.svg");
    desk.until([&] { return desk.state().dialog.file->mistake == "There is no file " + (folder / "a/new/gone.svg"); });
    type("../b");
    desk.until(shows(folder / "a/b"));
    type("bord");
    desk.until([&] { return !is_busy(desk.state()) && desk.state().file.path == folder / "a/b/border.lsys"; });
    CHECK_FALSE(desk.state().dialog.file);
}

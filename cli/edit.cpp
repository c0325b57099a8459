// rinceau edit: the editor, which is a program of its own.

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "cli/exit_status.h"
#include "cli/messages.h"
#include "cli/verbs.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

constexpr const char* editor_name = "rinceau-editor";

struct EditOptions {
    std::string file;
    std::string screenshot;
    std::string size;
    std::string scale;
    std::string places;  // for tests
    bool light = false;  // for pictures in the documentation
};

bool is_program(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

/// Beside this program, as installed or as built; else in the PATH. Empty = nowhere.
fs::path find_editor() {
    std::error_code ignored;
    const fs::path own_folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    std::vector<fs::path> folders;
    if (!own_folder.empty()) folders = {own_folder, own_folder.parent_path() / "editor"};
    const char* path = std::getenv("PATH");
    std::istringstream listed(path != nullptr ? path : "");
    for (std::string folder; std::getline(listed, folder, ':');) folders.emplace_back(folder.empty() ? "." : folder);
    for (const fs::path& folder : folders)
        if (is_program(folder / editor_name)) return folder / editor_name;
    return {};
}

std::vector<std::string> editor_words(const EditOptions& options) {
    std::vector<std::string> words{editor_name};
    const auto pass = [&](const char* name, const std::string& value) {
        if (!value.empty()) words.push_back(std::string(name) + '=' + value);
    };
    pass("--screenshot", options.screenshot);
    pass("--size", options.size);
    pass("--scale", options.scale);
    pass("--places", options.places);
    if (options.light) words.emplace_back("--light");
    if (!options.file.empty()) words.insert(words.end(), {"--", options.file});
    return words;
}

/// Becomes the editor; returns only if that is not possible.
int run_edit(const EditOptions& options) {
    const fs::path editor = find_editor();
    if (editor.empty()) {
        say("rinceau edit: the editor is not installed: there is no rinceau-editor beside rinceau or in the PATH. Build the "
            "project with -D RINCEAU_BUILD_EDITOR=ON and install it.");
        return exit_status::input_at_fault;
    }
    std::vector<std::string> words = editor_words(options);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(editor.c_str(), arguments.data());
    say("rinceau edit: " + editor.string() + " cannot be started: " + std::strerror(errno));
    return exit_status::input_at_fault;
}

}  // namespace

void add_edit(CLI::App& program, Job& job) {
    const auto [verb, options] =
        add_verb<EditOptions>(program, job, "edit", "Open the editor: a drawing and its rules side by side",
                              "rinceau edit samples/facade.svg --screenshot window.png --size 1280x800", run_edit);
    verb->add_option("FILE", options->file,
                     "A drawing (.svg), whose rules are found, a grammar (.lsys .json) or a project (.rinceau)");
    verb->add_option("--screenshot", options->screenshot,
                     "Open the file, draw the window into this picture (.png) when all work is done, and leave")
        ->type_name("FILE");
    verb->add_option("--size", options->size, "Size of the window, or of the screenshot in pixels")->type_name("WxH");
    verb->add_option("--scale", options->scale, "Size of text and buttons; without it, as the display is set")
        ->type_name("S");
    verb->add_option("--places", options->places)->group("");
    verb->add_flag("--light", options->light)->group("");
}

}  // namespace rinceau

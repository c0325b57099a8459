#include "editor/effects/kept_preferences.h"

#include <filesystem>

#include "files/files.h"
#include "files/output_file.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

std::string file_in(const std::string& folder) { return (std::filesystem::path(folder) / "preferences.json").string(); }

/// Empty if there is none that can be read.
std::string text_of(const std::string& file) {
    try {
        return read_input(file);
    } catch (const std::runtime_error&) {
        return {};
    }
}

}  // namespace

PreferencesInFile read_preferences(const std::string& config_folder) {
    const std::string text = config_folder.empty() ? std::string() : text_of(file_in(config_folder));
    if (text.empty()) return {};
    PreferencesInFile read = parse_preferences(text);
    if (!read.mistake.empty())
        read.mistake = file_in(config_folder) + ' ' + read.mistake +
                       ": the preferences are the usual ones, and the file is replaced when one is changed";
    return read;
}

void write_preferences(const std::string& config_folder, const Preferences& preferences) {
    std::error_code error;
    std::filesystem::create_directories(config_folder, error);
    if (error) fail_output(config_folder, error.value());
    const std::string file = file_in(config_folder);
    write_output(file, to_json(preferences, text_of(file)));
}

}  // namespace rinceau

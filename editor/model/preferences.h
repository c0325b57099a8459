#pragma once
// What the editor keeps between two starts.

#include <string>
#include <string_view>
#include <vector>

namespace rinceau {

struct Preferences {
    bool dark = true;
    double scale = 0;  ///< of fonts and widgets; 0 = the display's
    int window_width = 1280;
    int window_height = 800;
    double autosave_seconds = 50;  ///< between two copies for emergencies
    std::vector<std::string> recent;
    std::string last_folder;
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// Preferences as JSON. What `before`, the file's text so far, holds besides is kept; it may be broken or empty.
std::string to_json(const Preferences& preferences, std::string_view before = {});

struct PreferencesInFile {
    Preferences preferences;  ///< what is missing, of another kind or beyond reason is as usual
    std::string mistake;      ///< empty = the text is JSON
};
PreferencesInFile parse_preferences(std::string_view text);

}  // namespace rinceau

#pragma once
// What the editor keeps between two starts.

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/shell_state.h"

namespace rinceau {

struct Preferences {
    bool dark = true;
    float text_scale = 1;  ///< ShellState::text_scale
    PanelSizes sizes;
    ShownPanels shown;
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

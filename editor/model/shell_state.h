#pragma once
// The window itself.

#include <optional>
#include <string>

namespace rinceau {

enum class EditorPanel : unsigned char { terminals, analysis, canvas, rules, tools, growth, log };

/// Lengths at scale 1, wished for: a small window gives less.
struct PanelSizes {
    float left = 270;             ///< width of the column of terminals and analysis
    float right = 350;            ///< of rules and tools
    float log = 110;              ///< height
    float terminals_share = 0.5;  ///< of the left column's height, while both of its panels are shown
    friend bool operator==(const PanelSizes&, const PanelSizes&) = default;
};

/// What is shown of the panels.
struct ShownPanels {
    bool left = true;       ///< the column of terminals and analysis
    bool terminals = true;  ///< unfolded there
    bool analysis = true;
    bool right = true;  ///< the column of rules, tools and growth
    bool log = false;   ///< the newest message stands in the status line anyway
    friend bool operator==(const ShownPanels&, const ShownPanels&) = default;
};

struct ShellState {
    // Kept from session to session.
    bool dark = true;
    float text_scale = 1;  ///< beside the display's own scale
    PanelSizes sizes;
    ShownPanels shown;
    // Of this session.
    EditorPanel right_tab = EditorPanel::rules;  ///< rules, tools or growth
    EditorPanel focused = EditorPanel::canvas;   ///< where the keyboard is
    std::optional<EditorPanel> focus_wanted;     ///< where it is to go with the next frame
    bool help = false;
    bool palette = false;
    std::string palette_text;
    int palette_chosen = 0;
};

/// Does it stand in the window, be it behind the other tab of its column?
bool is_open(const ShellState& shell, EditorPanel panel);

/// "Rules", as the panel's heading says.
const char* panel_title(EditorPanel panel);

}  // namespace rinceau

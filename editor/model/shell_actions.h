#pragma once
// The window itself: looks, panels, messages.

#include <string>
#include <variant>

#include "editor/model/shell_state.h"

namespace rinceau {

struct SetDarkTheme {
    bool dark = true;
};
/// Text and all that goes with it become so large beside what the display is set to; kept within reason.
struct SetTextScale {
    float scale = 1;
};
/// A panel is shown, its tab is brought to the front, or it is hidden. The canvas is always shown.
struct ShowPanel {
    EditorPanel panel = EditorPanel::canvas;
    bool shown = true;
};
/// The left column with all its panels.
struct ShowLeftColumn {
    bool shown = true;
};
/// Columns and rows between panels get another size.
struct ResizePanels {
    PanelSizes sizes;
};
/// The keyboard goes to a panel, which is shown for it.
struct FocusPanel {
    EditorPanel panel = EditorPanel::canvas;
};
/// The keyboard goes to the next of the panels that are shown (`step` 1) or the one before (-1).
struct FocusNextPanel {
    int step = 1;
};
/// The keyboard is in a panel now.
struct PanelFocused {
    EditorPanel panel = EditorPanel::canvas;
};
struct ShowHelp {
    bool shown = true;
};
/// Type a part of a command's name, Enter runs it.
struct ShowPalette {
    bool shown = true;
};
struct EditPalette {
    std::string text;
    int chosen = 0;  ///< of the commands that match
};
struct DismissMessages {};

struct ShellAction : std::variant<SetDarkTheme, SetTextScale, ShowPanel, ShowLeftColumn, ResizePanels, FocusPanel,
                                  FocusNextPanel, PanelFocused, ShowHelp, ShowPalette, EditPalette, DismissMessages> {
    using variant::variant;
    ShellAction(const ShellAction&);
    ShellAction(ShellAction&&) noexcept;
    ShellAction& operator=(const ShellAction&);
    ShellAction& operator=(ShellAction&&) noexcept;
    ~ShellAction();
};

}  // namespace rinceau

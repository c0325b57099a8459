// The window itself.

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/model/update_parts.h"

namespace rinceau {
namespace {

constexpr float least_text = 0.7F;
constexpr float greatest_text = 2.5F;
constexpr float least_column = 120;  // lengths at scale 1
constexpr float greatest_column = 1200;
constexpr float least_row = 40;
constexpr float least_share = 0.1F;

/// In the order in which the keyboard goes round.
constexpr std::array all_panels{EditorPanel::terminals, EditorPanel::analysis, EditorPanel::canvas, EditorPanel::rules,
                                EditorPanel::tools,     EditorPanel::growth,   EditorPanel::log};

PanelSizes bounded(const PanelSizes& sizes) {
    const auto column = [](float width) { return std::clamp(width, least_column, greatest_column); };
    return {.left = column(sizes.left),
            .right = column(sizes.right),
            .log = std::clamp(sizes.log, least_row, greatest_column),
            .terminals_share = std::clamp(sizes.terminals_share, least_share, 1 - least_share)};
}

void show(ShellState& shell, EditorPanel panel, bool shown) {
    switch (panel) {
        case EditorPanel::terminals:
            shell.shown.terminals = shown;
            shell.shown.left = shell.shown.left || shown;
            break;
        case EditorPanel::analysis:
            shell.shown.analysis = shown;
            shell.shown.left = shell.shown.left || shown;
            break;
        case EditorPanel::rules:
        case EditorPanel::tools:
        case EditorPanel::growth:
            if (shown) shell.right_tab = panel;
            shell.shown.right = shown;
            break;
        case EditorPanel::log:
            shell.shown.log = shown;
            break;
        case EditorPanel::canvas:
            break;
    }
}

void perform_one(Update& update, const SetDarkTheme& action) { update.state.shell.dark = action.dark; }

void perform_one(Update& update, const SetTextScale& action) {
    if (std::isfinite(action.scale)) update.state.shell.text_scale = std::clamp(action.scale, least_text, greatest_text);
}

void perform_one(Update& update, const ShowPanel& action) { show(update.state.shell, action.panel, action.shown); }

void perform_one(Update& update, const ShowLeftColumn& action) { update.state.shell.shown.left = action.shown; }

void perform_one(Update& update, const ResizePanels& action) { update.state.shell.sizes = bounded(action.sizes); }

void perform_one(Update& update, const FocusPanel& action) {
    show(update.state.shell, action.panel, true);
    update.state.shell.focus_wanted = action.panel;
}

void perform_one(Update& update, const FocusNextPanel& action) {
    ShellState& shell = update.state.shell;
    const int count = static_cast<int>(all_panels.size());
    const int step = action.step < 0 ? count - 1 : 1;
    int at = static_cast<int>(shell.focus_wanted.value_or(shell.focused));
    do at = (at + step) % count;
    while (!is_open(shell, all_panels[static_cast<std::size_t>(at)]));
    perform_one(update, FocusPanel{all_panels[static_cast<std::size_t>(at)]});
}

void perform_one(Update& update, const PanelFocused& action) {
    update.state.shell.focused = action.panel;
    update.state.shell.focus_wanted.reset();
}

void perform_one(Update& update, const ShowHelp& action) { update.state.shell.help = action.shown; }

void perform_one(Update& update, const ShowPalette& action) {
    ShellState& shell = update.state.shell;
    shell.palette = action.shown;
    shell.palette_text.clear();
    shell.palette_chosen = 0;
}

void perform_one(Update& update, const EditPalette& action) {
    update.state.shell.palette_text = action.text;
    update.state.shell.palette_chosen = action.chosen;
}

void perform_one(Update& update, const DismissMessages&) { update.state.messages.clear(); }

}  // namespace

void perform(Update& update, const ShellAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau

// Commands of the menus View and Help that concern the window.

#include "editor/model/command.h"

namespace rinceau {
namespace {

constexpr float text_step = 1.1F;  ///< from one size of text to the next

template <EditorPanel panel>
Action toggle(const EditorState& state) {
    return ShellAction{ShowPanel{panel, !is_open(state.shell, panel)}};
}

template <EditorPanel panel>
bool open(const EditorState& state) {
    return is_open(state.shell, panel);
}

template <EditorPanel panel>
Action go_to(const EditorState&) {
    return ShellAction{FocusPanel{panel}};
}

template <EditorPanel panel>
Command panel_command(const std::string& name, const std::string& shortcut, const std::string& help) {
    return {.name = "panel." + name,
            .menu = "View/Go to",
            .label = panel_title(panel),
            .shortcut = shortcut,
            .help = help,
            .action = go_to<panel>};
}

std::vector<Command> panel_commands() {
    return {
        panel_command<EditorPanel::canvas>("canvas", "Ctrl+1", "The keyboard goes to the canvas."),
        panel_command<EditorPanel::rules>("rules", "Ctrl+2", "The keyboard goes to the rules and their numbers."),
        panel_command<EditorPanel::tools>("tools", "Ctrl+3", "The keyboard goes to the tools."),
        panel_command<EditorPanel::terminals>("terminals", "Ctrl+4", "The keyboard goes to the terminals."),
        panel_command<EditorPanel::analysis>("analysis", "Ctrl+5", "The keyboard goes to the analysis."),
        panel_command<EditorPanel::log>("log", "Ctrl+6", "The keyboard goes to the log of what happened."),
        panel_command<EditorPanel::growth>("growth", "Ctrl+7", "The keyboard goes to growth: more of the same."),
        {.name = "panel.next",
         .menu = "View/Go to",
         .label = "Next panel",
         .shortcut = "F6 Ctrl+Tab",
         .help = "The keyboard goes round the panels: arrows then move in one, Space presses a button.",
         .action = [](const EditorState&) -> Action { return ShellAction{FocusNextPanel{1}}; },
         .repeats = true},
        {.name = "panel.previous",
         .menu = "View/Go to",
         .label = "Panel before",
         .shortcut = "Shift+F6 Ctrl+Shift+Tab",
         .help = "The keyboard goes round the panels the other way.",
         .action = [](const EditorState&) -> Action { return ShellAction{FocusNextPanel{-1}}; },
         .repeats = true},
    };
}

std::vector<Command> look_commands() {
    return {
        {.name = "view.dark",
         .menu = "View",
         .label = "Dark",
         .shortcut = "",
         .help = "Light letters on a dark ground, or dark ones on a light ground.",
         .action = [](const EditorState& state) -> Action { return ShellAction{SetDarkTheme{!state.shell.dark}}; },
         .checked = [](const EditorState& state) { return state.shell.dark; }},
        {.name = "view.larger_text",
         .menu = "View",
         .label = "Larger text",
         .shortcut = "Ctrl+Shift++",
         .help = "Text and buttons become larger.",
         .action = [](const EditorState& state) -> Action {
             return ShellAction{SetTextScale{state.shell.text_scale * text_step}};
         },
         .repeats = true},
        {.name = "view.smaller_text",
         .menu = "View",
         .label = "Smaller text",
         .shortcut = "Ctrl+Shift+-",
         .help = "Text and buttons become smaller.",
         .action = [](const EditorState& state) -> Action {
             return ShellAction{SetTextScale{state.shell.text_scale / text_step}};
         },
         .repeats = true},
        {.name = "view.usual_text",
         .menu = "View",
         .label = "Text as the display is set",
         .shortcut = "Ctrl+Shift+0",
         .help = "Text and buttons get the size that the display asks for.",
         .action = [](const EditorState&) -> Action { return ShellAction{SetTextScale{1}}; }},
    };
}

std::vector<Command> layout_commands() {
    return {
        {.name = "view.terminals",
         .menu = "View/Panels",
         .label = "Terminals",
         .shortcut = "",
         .help = "Shows or hides the terminals.",
         .action = toggle<EditorPanel::terminals>,
         .checked = open<EditorPanel::terminals>},
        {.name = "view.analysis",
         .menu = "View/Panels",
         .label = "Analysis",
         .shortcut = "",
         .help = "Shows or hides the analysis.",
         .action = toggle<EditorPanel::analysis>,
         .checked = open<EditorPanel::analysis>},
        {.name = "view.left",
         .menu = "View/Panels",
         .label = "Left column",
         .shortcut = "F7",
         .help = "Shows or hides the column of terminals and analysis.",
         .action = [](const EditorState& state) -> Action { return ShellAction{ShowLeftColumn{!state.shell.shown.left}}; },
         .checked = [](const EditorState& state) { return state.shell.shown.left; }},
        {.name = "view.right",
         .menu = "View/Panels",
         .label = "Right column",
         .shortcut = "F8",
         .help = "Shows or hides the column of rules, tools and growth.",
         .action = [](const EditorState& state) -> Action {
             return ShellAction{ShowPanel{state.shell.right_tab, !state.shell.shown.right}};
         },
         .checked = open<EditorPanel::rules>},
        {.name = "view.log",
         .menu = "View/Panels",
         .label = "Log",
         .shortcut = "F9",
         .help = "Shows or hides what happened. The newest message stands in the status line, too.",
         .action = toggle<EditorPanel::log>,
         .checked = open<EditorPanel::log>},
    };
}

std::vector<Command> help_commands() {
    return {
        {.name = "help.palette",
         .menu = "Help",
         .label = "Find a command...",
         .shortcut = "Ctrl+P Ctrl+Shift+P",
         .help = "Type a part of a command's name; Enter runs it.",
         .action = [](const EditorState& state) -> Action { return ShellAction{ShowPalette{!state.shell.palette}}; }},
        {.name = "help.help",
         .menu = "Help",
         .label = "Commands and keys",
         .shortcut = "F1",
         .help = "Lists all commands with their keys.",
         .action = [](const EditorState& state) -> Action { return ShellAction{ShowHelp{!state.shell.help}}; }},
        {.name = "help.forget_messages",
         .menu = "Help",
         .label = "Clear the log",
         .shortcut = "",
         .help = "Forgets what happened until now.",
         .enabled = [](const EditorState& state) { return !state.messages.empty(); },
         .action = [](const EditorState&) -> Action { return ShellAction{DismissMessages{}}; }},
    };
}

}  // namespace

std::vector<Command> shell_commands() {
    std::vector<Command> all;
    for (const auto part : {look_commands, layout_commands, panel_commands, help_commands})
        for (Command& command : part()) all.push_back(std::move(command));
    return all;
}

}  // namespace rinceau

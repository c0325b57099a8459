#include "editor/model/shell_state.h"

namespace rinceau {

bool is_open(const ShellState& shell, EditorPanel panel) {
    switch (panel) {
        case EditorPanel::terminals:
            return shell.shown.left && shell.shown.terminals;
        case EditorPanel::analysis:
            return shell.shown.left && shell.shown.analysis;
        case EditorPanel::rules:
        case EditorPanel::tools:
        case EditorPanel::growth:
            return shell.shown.right;
        case EditorPanel::log:
            return shell.shown.log;
        case EditorPanel::canvas:
            break;
    }
    return true;
}

const char* panel_title(EditorPanel panel) {
    switch (panel) {
        case EditorPanel::terminals:
            return "Terminals";
        case EditorPanel::analysis:
            return "Analysis";
        case EditorPanel::rules:
            return "Rules";
        case EditorPanel::tools:
            return "Tools";
        case EditorPanel::growth:
            return "Growth";
        case EditorPanel::log:
            return "Log";
        case EditorPanel::canvas:
            break;
    }
    return "Canvas";
}

}  // namespace rinceau

// The menus: one for each that the commands name, in the order in which they name them first.

#include <imgui.h>

#include <algorithm>

#include "editor/panels/command_menu.h"

namespace rinceau {
namespace {

/// A menu with its commands, and with the menus within it.
struct MenuTree {
    std::string name;  ///< "Export"
    std::string path;  ///< "File/Export"
    std::vector<const Command*> commands;
    std::vector<MenuTree> menus;
};

MenuTree& menu_of(MenuTree& tree, const std::string& path) {
    const auto end = path.find('/', tree.path.empty() ? 0 : tree.path.size() + 1);
    const std::string here = path.substr(0, end);
    auto found = std::ranges::find(tree.menus, here, &MenuTree::path);
    if (found == tree.menus.end()) {
        tree.menus.push_back({here.substr(here.rfind('/') + 1), here, {}, {}});
        found = tree.menus.end() - 1;
    }
    return end == std::string::npos ? *found : menu_of(*found, path);
}

MenuTree all_menus() {
    MenuTree tree;
    for (const Command& command : commands()) menu_of(tree, command.menu).commands.push_back(&command);
    return tree;
}

void draw_menu(const MenuTree& menu, const EditorState& state, const PanelTools& tools, Actions& actions) {
    const bool open = ImGui::BeginMenu(menu.name.c_str());
    note_place(tools, "menu/" + menu.path);
    if (!open) return;
    for (const Command* command : menu.commands) command_entry(*command, state, tools, actions);
    for (const MenuTree& inner : menu.menus) draw_menu(inner, state, tools, actions);
    ImGui::EndMenu();
}

}  // namespace

Actions menu_bar(const EditorState& state, const PanelTools& tools) {
    static const MenuTree tree = all_menus();
    Actions actions;
    if (!ImGui::BeginMenuBar()) return actions;
    for (const MenuTree& menu : tree.menus) draw_menu(menu, state, tools, actions);
    ImGui::EndMenuBar();
    return actions;
}

}  // namespace rinceau

// The dialog for choosing a file: its folder as a list, a name or path to type, keys as in a terminal.

#include "editor/panels/file_browser.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>

#include "editor/model/export_target.h"
#include "editor/panels/modal_window.h"

namespace rinceau {
namespace {

// At scale 1.
constexpr float wide = 760;
constexpr float high = 520;
constexpr float side_width = 170;
constexpr float size_column = 80;
constexpr float time_column = 130;
constexpr int rows_a_page = 12;

std::string size_text(const FolderEntry& entry) {
    if (entry.folder) return {};
    constexpr std::uint64_t kilobyte = 1024;
    if (entry.bytes < kilobyte) return std::to_string(entry.bytes) + " B";
    if (entry.bytes < kilobyte * kilobyte) return std::to_string(entry.bytes / kilobyte) + " KB";
    return std::to_string(entry.bytes / (kilobyte * kilobyte)) + " MB";
}

std::string time_text(std::int64_t seconds) {
    if (seconds == 0) return {};
    const std::time_t time = seconds;
    std::tm parts{};
    if (::localtime_r(&time, &parts) == nullptr) return {};
    std::array<char, 32> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &parts);
    return {text.data(), length};
}

/// The dialog while it is drawn.
struct Browser {
    const FileDialog& dialog;
    const EditorState& state;
    const PanelTools& tools;
    std::string prefix;  ///< of the names of widgets: "open/"
    Actions actions;

    void act(const DialogAction& action) { actions.push_back(action); }
    void note(const std::string& name) const { note_place(tools, prefix + name); }
    bool button(const char* label, const std::string& name) const {
        const bool pressed = ImGui::Button(label);
        note(name);
        return pressed;
    }
};

/// The way to the folder as buttons.
void crumbs(Browser& browser) {
    const std::filesystem::path folder(browser.dialog.folder);
    if (browser.button("Up", "Up")) browser.act(GoToFolder{".."});
    std::filesystem::path so_far;
    int number = 0;
    for (const auto& part : folder) {
        so_far /= part;
        const std::string label = part.string() + "##" + std::to_string(number++);
        const float width = ImGui::CalcTextSize(part.string().c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
        ImGui::SameLine();
        if (width > ImGui::GetContentRegionAvail().x) ImGui::NewLine();
        if (ImGui::Button(label.c_str())) browser.act(GoToFolder{so_far.string()});
    }
}

void side(Browser& browser) {
    if (ImGui::BeginChild("places", {side_width * browser.tools.scale, -ImGui::GetFrameHeightWithSpacing() * 2}, true)) {
        if (ImGui::Selectable("Home")) browser.act(GoToFolder{"~"});
        browser.note("Home");
        std::vector<std::string> folders;
        for (const std::string& file : browser.state.file.recent) {
            const std::string folder = std::filesystem::path(file).parent_path().string();
            if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(folder);
        }
        if (!folders.empty()) ImGui::TextDisabled("Recent folders");
        for (const std::string& folder : folders) {
            const std::string label = file_name_of(folder) + "##" + folder;
            if (ImGui::Selectable(label.c_str())) browser.act(GoToFolder{folder});
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", folder.c_str());
        }
    }
    ImGui::EndChild();
}

void row(Browser& browser, int number, const FolderEntry& entry) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = entry.name + (entry.folder ? "/" : "") + "##row";
    if (ImGui::Selectable(label.c_str(), number == browser.dialog.selected,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick)) {
        browser.act(SelectFileRow{number});
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) browser.act(AcceptFileDialog{});
    }
    browser.note(entry.name);
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", size_text(entry).c_str());
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", time_text(entry.modified).c_str());
}

void list(Browser& browser) {
    const std::vector<std::size_t> shown = shown_entries(browser.dialog);
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
    if (!ImGui::BeginTable("entries", 3, flags, {0, -ImGui::GetFrameHeightWithSpacing() * 2})) return;
    ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, size_column * browser.tools.scale);
    ImGui::TableSetupColumn("Changed", ImGuiTableColumnFlags_WidthFixed, time_column * browser.tools.scale);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(shown.size()));
    if (browser.dialog.selected >= 0)
        clipper.ForceDisplayRangeByIndices(browser.dialog.selected, browser.dialog.selected + 1);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            row(browser, i, browser.dialog.entries[shown[static_cast<std::size_t>(i)]]);
            if (i == browser.dialog.selected && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
        }
    }
    if (shown.empty()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", browser.dialog.listing ? "Reading the folder..." : "Nothing here fits");
    }
    ImGui::EndTable();
}

/// Arrow keys move in the list while the text is typed.
int rows_from_keys(ImGuiInputTextCallbackData* data) {
    *static_cast<int*>(data->UserData) += data->EventKey == ImGuiKey_DownArrow ? 1 : -1;
    return 0;
}

bool key(ImGuiKey_ which) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which)); }

void path_field(Browser& browser) {
    const FileDialog& dialog = browser.dialog;
    if (dialog.wants_focus) {
        ImGui::SetKeyboardFocusHere();
        browser.act(FocusFileDialog{});
    }
    std::string text = dialog.text;
    int rows = 0;
    const float buttons = (browser.prefix == "open/" ? 170.0F : 190.0F) * browser.tools.scale;
    ImGui::SetNextItemWidth(-buttons);
    const char* hint = dialog.purpose == FilePurpose::open ? "Part of a name, or a path" : "Name or path";
    const bool was_empty = text.empty();
    const bool entered = ImGui::InputTextWithHint(
        "##Path", hint, &text,
        ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll,
        rows_from_keys, &rows);
    const bool typing = ImGui::IsItemActive();
    browser.note("Path");
    if (text != dialog.text) browser.act(TypeInFileDialog{text});
    if (rows != 0) browser.act(MoveInFileDialog{rows});
    if (typing && key(ImGuiKey_PageDown)) browser.act(MoveInFileDialog{rows_a_page});
    if (typing && key(ImGuiKey_PageUp)) browser.act(MoveInFileDialog{-rows_a_page});
    if (typing && was_empty && key(ImGuiKey_Backspace)) browser.act(GoToFolder{".."});
    if (entered) browser.act(AcceptFileDialog{});
}

void new_folder(Browser& browser) {
    const FileDialog& dialog = browser.dialog;
    if (!dialog.new_folder) {
        if (browser.button("New folder", "NewFolder")) browser.act(NameNewFolder{});
        return;
    }
    std::string name = *dialog.new_folder;
    ImGui::SetNextItemWidth(180 * browser.tools.scale);
    if (name.empty() && !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputTextWithHint("##NewFolder", "Name of the folder", &name, ImGuiInputTextFlags_EnterReturnsTrue);
    browser.note("NewFolderName");
    if (name != *dialog.new_folder) browser.act(NameNewFolder{name});
    ImGui::SameLine();
    if (browser.button("Make", "MakeFolder") || entered) browser.act(MakeNewFolder{});
}

void save_kind(Browser& browser) {
    constexpr std::array<std::pair<FileKind, const char*>, 3> kinds{
        {{FileKind::project, "Project: drawing, rules, options (.rinceau)"},
         {FileKind::grammar, "Rules alone (.lsys)"},
         {FileKind::json_grammar, "Rules alone, as JSON (.json)"}}};
    for (const auto& [kind, label] : kinds) {
        if (ImGui::RadioButton(label, browser.dialog.kind == kind)) browser.act(ChooseFileKind{kind});
        browser.note(ending_of(kind).substr(1));
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

void export_choices(Browser& browser) {
    ExportChoices choices = browser.dialog.choices;
    if (browser.dialog.format == "png") {
        ImGui::SetNextItemWidth(120 * browser.tools.scale);
        ImGui::InputInt("pixels wide (0 = the picture's own width)", &choices.width, 0);
        browser.note("Width");
    } else if (!find_export_target(browser.dialog.format).picture) {
        ImGui::Checkbox("Keep chance alive, where the format can", &choices.live_random);
        browser.note("LiveRandom");
    }
    constexpr int widest = 32767;
    choices.width = std::clamp(choices.width, 0, widest);
    if (choices != browser.dialog.choices) browser.act(SetExportChoices{choices});
}

void export_format(Browser& browser) {
    const ExportTarget chosen = find_export_target(browser.dialog.format);
    if (ImGui::BeginChild("formats", {0, 7 * ImGui::GetTextLineHeightWithSpacing()}, true)) {
        for (const ExportTarget& target : export_targets()) {
            const std::string label = target.name + "##format";
            if (ImGui::Selectable(label.c_str(), target.name == chosen.name)) browser.act(ChooseExportFormat{target.name});
            browser.note(target.name);
            ImGui::SameLine(side_width * browser.tools.scale);
            ImGui::TextDisabled("%s: %s", target.ending.c_str(), target.help.c_str());
        }
    }
    ImGui::EndChild();
    export_choices(browser);
}

void filters(Browser& browser) {
    bool hidden = browser.dialog.hidden;
    if (ImGui::Checkbox("Hidden", &hidden)) browser.act(ShowHiddenFiles{hidden});
    browser.note("Hidden");
    ImGui::SameLine();
    bool all = browser.dialog.all_kinds;
    if (ImGui::Checkbox("All files", &all)) browser.act(ShowAllKinds{all});
    browser.note("AllFiles");
    ImGui::SameLine();
    new_folder(browser);
    if (!browser.dialog.mistake.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_PlotHistogram));
        ImGui::TextWrapped("%s", browser.dialog.mistake.c_str());
        ImGui::PopStyleColor();
    } else if (browser.dialog.cut_short) {
        ImGui::TextDisabled("The folder holds more; type a path to open what is not shown");
    }
}

const char* title_of(FilePurpose purpose) {
    constexpr std::array<const char*, 3> titles{"Open", "Save as", "Export"};
    return titles[static_cast<std::size_t>(purpose)];
}

const char* verb_of(FilePurpose purpose) {
    constexpr std::array<const char*, 3> verbs{"Open", "Save", "Export"};
    return verbs[static_cast<std::size_t>(purpose)];
}

void content(Browser& browser) {
    const FilePurpose purpose = browser.dialog.purpose;
    if (purpose == FilePurpose::save) save_kind(browser);
    if (purpose == FilePurpose::export_picture) export_format(browser);
    path_field(browser);
    ImGui::SameLine();
    if (browser.button(verb_of(purpose), "OK")) browser.act(AcceptFileDialog{});
    ImGui::SameLine();
    if (browser.button("Cancel", "Cancel") || key(ImGuiKey_Escape)) browser.act(CloseFileDialog{});
    crumbs(browser);
    side(browser);
    ImGui::SameLine();
    list(browser);
    filters(browser);
}

}  // namespace

Actions file_browser(const EditorState& state, const PanelTools& tools) {
    const bool wanted = state.dialog.file && !state.file.question;
    const FilePurpose purpose = state.dialog.file ? state.dialog.file->purpose : FilePurpose::open;
    const ImVec2 room = ImGui::GetMainViewport()->WorkSize;
    ImGui::SetNextWindowSize({std::min(wide * tools.scale, room.x), std::min(high * tools.scale, room.y)},
                             ImGuiCond_Appearing);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    const std::string title = std::string(title_of(purpose)) + "###file dialog";
    if (!begin_modal(title.c_str(), wanted, ImGuiWindowFlags_None)) return {};
    Browser browser{*state.dialog.file, state, tools, purpose_name(purpose) + '/', {}};
    content(browser);
    ImGui::EndPopup();
    return browser.actions;
}

}  // namespace rinceau

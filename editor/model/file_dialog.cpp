#include "editor/model/file_dialog.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "editor/model/export_target.h"

namespace rinceau {
namespace {

std::string small_letters(std::string text) {
    for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

bool is_of_use(const FileDialog& dialog, const FolderEntry& entry) {
    if (entry.folder || dialog.all_kinds) return true;
    if (dialog.purpose == FilePurpose::export_picture)
        return small_letters(entry.name).ends_with(find_export_target(dialog.format).ending);
    const FileKind kind = kind_of_name(entry.name);
    return dialog.purpose == FilePurpose::save ? can_be_saved_as(kind) : kind != FileKind::other;
}

/// What names must hold; empty where the text is the name of the file to be.
std::string filter_of(const FileDialog& dialog) {
    return dialog.purpose == FilePurpose::open && !is_path_text(dialog.text) ? small_letters(dialog.text) : std::string();
}

}  // namespace

std::string purpose_name(FilePurpose purpose) {
    switch (purpose) {
        case FilePurpose::open:
            return "open";
        case FilePurpose::save:
            return "save";
        case FilePurpose::export_picture:
            break;
    }
    return "export";
}

std::vector<std::size_t> shown_entries(const FileDialog& dialog) {
    const std::string filter = filter_of(dialog);
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < dialog.entries.size(); ++i) {
        const FolderEntry& entry = dialog.entries[i];
        if (!dialog.hidden && entry.name.starts_with('.') && !filter.starts_with('.')) continue;
        if (!is_of_use(dialog, entry)) continue;
        if (small_letters(entry.name).find(filter) != std::string::npos) shown.push_back(i);
    }
    return shown;
}

const FolderEntry* selected_entry(const FileDialog& dialog) {
    const std::vector<std::size_t> shown = shown_entries(dialog);
    if (dialog.selected < 0 || dialog.selected >= static_cast<int>(shown.size())) return nullptr;
    return &dialog.entries[shown[static_cast<std::size_t>(dialog.selected)]];
}

FileDialog with_text(FileDialog dialog, std::string text) {
    dialog.text = std::move(text);
    dialog.mistake.clear();
    dialog.selected = filter_of(dialog).empty() || shown_entries(dialog).empty() ? -1 : 0;
    if (dialog.purpose == FilePurpose::save && can_be_saved_as(kind_of_name(dialog.text)))
        dialog.kind = kind_of_name(dialog.text);
    return dialog;
}

FileDialog with_row_moved(FileDialog dialog, int rows) {
    const int count = static_cast<int>(shown_entries(dialog).size());
    if (count == 0) return dialog;
    const int from = dialog.selected < 0 && rows > 0 ? -1 : std::max(dialog.selected, 0);
    return with_row(std::move(dialog), std::clamp(from + rows, 0, count - 1));
}

FileDialog with_row(FileDialog dialog, int row) {
    dialog.selected = row;
    dialog.mistake.clear();
    const FolderEntry* entry = selected_entry(dialog);
    if (entry == nullptr) {
        dialog.selected = -1;
    } else if (!entry->folder && dialog.purpose != FilePurpose::open) {
        dialog.text = entry->name;
    }
    return dialog;
}

FileDialog with_entries(FileDialog dialog, std::string folder, std::vector<FolderEntry> entries, bool cut_short) {
    std::ranges::sort(entries, [](const FolderEntry& a, const FolderEntry& b) {
        if (a.folder != b.folder) return a.folder;
        const std::string plain_a = small_letters(a.name);
        const std::string plain_b = small_letters(b.name);
        return plain_a != plain_b ? plain_a < plain_b : a.name < b.name;
    });
    dialog.folder = std::move(folder);
    dialog.entries = std::move(entries);
    dialog.cut_short = cut_short;
    dialog.listing = false;
    dialog.selected = -1;
    dialog.mistake.clear();
    return dialog;
}

FileDialog with_file_kind(FileDialog dialog, FileKind kind) {
    dialog.kind = kind;
    if (!dialog.text.empty()) dialog.text = with_kind(dialog.text, kind);
    dialog.selected = -1;
    return dialog;
}

FileDialog with_export_format(FileDialog dialog, const std::string& format) {
    const std::string before = find_export_target(dialog.format).ending;
    dialog.format = format;
    if (dialog.text.ends_with(before)) dialog.text.resize(dialog.text.size() - before.size());
    dialog.text += find_export_target(format).ending;
    dialog.selected = -1;
    return dialog;
}

bool is_path_text(const std::string& text) { return text.find('/') != std::string::npos || text.starts_with('~'); }

std::string chosen_path(const FileDialog& dialog) {
    const FolderEntry* entry = selected_entry(dialog);
    const bool row = entry != nullptr && (dialog.purpose == FilePurpose::open || entry->folder);
    std::string name = row ? entry->name : dialog.text;
    if (name.empty() || row) return name;
    if (dialog.purpose == FilePurpose::save && kind_of_name(name) == FileKind::other && !name.ends_with('/') && name != "~")
        name += ending_of(dialog.kind);
    return name;
}

}  // namespace rinceau

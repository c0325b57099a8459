#include "editor/model/command.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

namespace rinceau {
namespace {

std::string lower(std::string text) {
    for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

}  // namespace

bool is_enabled(const Command& command, const EditorState& state) {
    return command.enabled == nullptr || command.enabled(state);
}

std::string first_shortcut(const Command& command) { return command.shortcut.substr(0, command.shortcut.find(' ')); }

std::string shortcut_text(std::string shortcut) {
    for (auto blank = shortcut.find(' '); blank != std::string::npos; blank = shortcut.find(' ', blank + 1)) {
        shortcut.replace(blank, 1, " or ");
        blank += 3;  // its second blank
    }
    return shortcut;
}

const Command* command_of_key(const std::vector<Command>& commands, const std::vector<KeyChord>& meanings) {
    for (const KeyChord& meaning : meanings) {
        for (const Command& command : commands) {
            const auto chords = parse_chords(command.shortcut);
            if (std::ranges::find(chords, meaning) != chords.end()) return &command;
        }
    }
    return nullptr;
}

std::vector<const Command*> matching_commands(const std::vector<Command>& commands, const std::string& text) {
    const std::vector<std::string> words = words_of(lower(text));
    const auto holds_all = [&](const std::string& where) {
        return std::ranges::all_of(words, [&](const std::string& word) { return where.find(word) != std::string::npos; });
    };
    std::vector<const Command*> by_label, by_more;
    for (const Command& command : commands) {
        if (holds_all(lower(command.label))) {
            by_label.push_back(&command);
        } else if (holds_all(lower(command.menu + ' ' + command.label + ' ' + command.help))) {
            by_more.push_back(&command);
        }
    }
    by_label.insert(by_label.end(), by_more.begin(), by_more.end());
    return by_label;
}

std::vector<Command> all_commands() {
    std::vector<Command> all;
    for (const auto area : {file_commands, rules_commands, canvas_commands, tools_commands, analysis_commands,
                            growth_commands, surface_commands, shell_commands})
        for (Command& command : area()) all.push_back(std::move(command));
    return all;
}

const std::vector<Command>& commands() {
    static const std::vector<Command> all = all_commands();
    return all;
}

const Command* find_command(const std::string& name) {
    const auto found = std::ranges::find(commands(), name, &Command::name);
    return found == commands().end() ? nullptr : &*found;
}

}  // namespace rinceau

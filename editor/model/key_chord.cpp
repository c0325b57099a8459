#include "editor/model/key_chord.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace rinceau {
namespace {

using namespace std::string_view_literals;

constexpr std::array named_keys{"Backspace"sv, "Delete"sv, "Down"sv,   "End"sv,  "Enter"sv,
                                "Escape"sv,    "Home"sv,   "Insert"sv, "Left"sv, "PageDown"sv,
                                "PageUp"sv,    "Right"sv,  "Space"sv,  "Tab"sv,  "Up"sv};

bool is_function_key(std::string_view key) {
    const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    return (key.size() == 2 || key.size() == 3) && key[0] == 'F' && key[1] != '0' &&
           std::ranges::all_of(key.substr(1), is_digit);
}

bool is_key(std::string_view key) {
    if (key.size() == 1)
        return std::isgraph(static_cast<unsigned char>(key[0])) != 0 &&
               std::islower(static_cast<unsigned char>(key[0])) == 0;
    return is_function_key(key) || std::ranges::find(named_keys, key) != named_keys.end();
}

}  // namespace

std::optional<KeyChord> parse_chord(std::string_view text) {
    const auto takes = [&](std::string_view modifier) {
        if (!text.starts_with(modifier)) return false;
        text.remove_prefix(modifier.size());
        return true;
    };
    KeyChord chord;
    chord.ctrl = takes("Ctrl+");
    chord.shift = takes("Shift+");
    chord.alt = takes("Alt+");
    if (!is_key(text)) return std::nullopt;
    chord.key = text;
    return chord;
}

std::vector<KeyChord> parse_chords(std::string_view text) {
    std::vector<KeyChord> chords;
    while (!text.empty()) {
        const auto end = std::min(text.find(' '), text.size());
        if (const auto chord = parse_chord(text.substr(0, end))) chords.push_back(*chord);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return chords;
}

std::vector<KeyChord> meanings(const KeyChord& pressed, const std::string& position) {
    std::vector<KeyChord> all{pressed};
    const auto add = [&](const std::string& key, bool shift) { all.push_back({key, pressed.ctrl, shift, pressed.alt}); };
    if (pressed.key == "=") {
        add("+", pressed.shift);
        add("+", false);
    }
    if (position != pressed.key && position.size() == 1 && std::isdigit(static_cast<unsigned char>(position[0])) != 0)
        add(position, pressed.shift);
    return all;
}

bool belongs_to_text(const KeyChord& chord) {
    constexpr std::array edit_text{"A"sv,    "C"sv,     "V"sv,  "X"sv,    "Y"sv,    "Z"sv,   "Backspace"sv, "Delete"sv,
                                   "Left"sv, "Right"sv, "Up"sv, "Down"sv, "Home"sv, "End"sv, "Insert"sv,    "Enter"sv};
    if (is_function_key(chord.key)) return false;
    if (!chord.ctrl) return !chord.alt;
    return std::ranges::find(edit_text, chord.key) != edit_text.end();
}

}  // namespace rinceau

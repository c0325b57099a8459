#pragma once
// Keys as the commands name them: "Ctrl+Shift+S", "Delete", "+".

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rinceau {

/// A key with the keys that are held with it.
struct KeyChord {
    std::string key;  ///< "S", "0", "+", "F1", "Delete", "PageUp"
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

/// Of "Ctrl+Shift+S"; nothing if it names no key that a keyboard has, or a modifier twice or in another order than Ctrl,
/// Shift, Alt.
std::optional<KeyChord> parse_chord(std::string_view text);

/// Of a list with blanks between, as "Ctrl+Y Ctrl+Shift+Z"; what is no chord is left out.
std::vector<KeyChord> parse_chords(std::string_view text);

/// What pressing a key may have meant, likeliest first: `pressed` names the key as the keyboard's layout does; `position`
/// what is printed there on an American keyboard. A "+" is where "=" is, shifted or not; a digit may be where the layout
/// has another sign.
std::vector<KeyChord> meanings(const KeyChord& pressed, const std::string& position);

/// Is it for the text field that is being typed in, rather than for a command? So are letters, keys that move in text, and
/// Ctrl with A, C, V, X, Y, Z.
bool belongs_to_text(const KeyChord& chord);

}  // namespace rinceau

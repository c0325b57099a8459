#pragma once
// What the tools show of the document.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/editor_state.h"

namespace rinceau {

/// The seed that is set, or the one of the grammar.
std::uint64_t shown_seed(const EditorState& state);

/// Noise by kind: as it is set, or else as the shown grammar has it.
NoiseInGrammar shown_noise(const EditorState& state);

/// The symbol that is to be replaced: the one that is set, or the first terminal; empty = there is none.
std::string symbol_to_replace(const EditorState& state);

/// The address of the selected module; empty = there is none that could be replaced alone.
std::vector<int> address_to_replace(const EditorState& state);

/// How often a terminal is drawn in the picture.
struct TerminalUse {
    int count = 0;
    int mirrored = 0;
    int look = -1;  ///< the first one of PictureLook; -1 = none
};

/// By terminal of the shown grammar; all 0 while its picture is on the way.
std::vector<TerminalUse> terminal_uses(const EditorState& state);

}  // namespace rinceau

#pragma once
// What the tools show of the document.

#include <cstdint>
#include <optional>
#include <string>

#include "editor/model/editor_state.h"

namespace rinceau {

/// The seed that is set, or the one of the grammar.
std::uint64_t shown_seed(const EditorState& state);

/// Noise by kind: as it is set, or else as the shown grammar has it.
NoiseInGrammar shown_noise(const EditorState& state);

/// The symbol that is to be replaced: the one that is set, or the first terminal; empty = there is none.
std::string symbol_to_replace(const EditorState& state);

}  // namespace rinceau

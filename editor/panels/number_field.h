#pragma once
// One number of the grammar: name, drag field with unit, reset, lock.

#include <string>

#include "editor/panels/panel.h"

namespace rinceau {

/// A line with the number. Dragging previews, release records, Esc drops; a double click or Ctrl+click types. `next` is the
/// number that Tab goes on to; empty = none. Places: "rules/NAME", "rules/reset NAME", "rules/lock NAME".
void number_field(const EditorState& state, const PanelTools& tools, const GrammarNumber& number, const std::string& label,
                  const std::string& next, Actions& actions);

}  // namespace rinceau

#pragma once
// A picture for Context Free by its parts: what each module becomes is a shape of its own, with numbers for everything.
// Holds whatever can be derived. Internal to the folder.

#include <string>

#include "exports/cfdg_drawing.h"
#include "lsystem/derivation_graph.h"

namespace rinceau {

std::string cfdg_parts(const Grammar& grammar, const DerivationGraph& graph, NoteList& notes);

}  // namespace rinceau

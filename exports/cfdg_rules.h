#pragma once
// A grammar's rules as Context Free's shapes with parameters. Internal to the folder.

#include <optional>
#include <string>

#include "exports/cfdg_drawing.h"
#include "lsystem/derive.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// Nothing where a shape would have to say how it moves what stands behind it and no number says so beforehand (the Koch
/// curve): Context Free's shapes move nothing but what is inside them. With `live_random` draws by chance are written as
/// such, and paint order is kept within layers only as far as Context Free paints larger shapes first. `grammar`: plain
/// rules (lsystem/plain_rules.h) without exceptions, contexts and colour commands. Throws as derive() of the whole.
std::optional<std::string> cfdg_rules(const Grammar& grammar, const DeriveOptions& limits, bool live_random,
                                      NoteList& notes);

}  // namespace rinceau

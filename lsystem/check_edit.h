#pragma once
// The check that every edit goes through before it is written.

#include <functional>

#include "geometry/progress.h"
#include "lsystem/derive.h"
#include "lsystem/edit_result.h"

namespace rinceau {

struct CheckEditOptions {
    DeriveOptions derive;
    /// A result of more modules is taken as it is, so that the time is bounded; 0 = none is.
    std::uint64_t unchecked_above = 0;
    /// Makes a grammar as written ready for drawing: what it uses of other files is put in. Exceptions stay as they are.
    std::function<Grammar(const Grammar&)> for_drawing = [](const Grammar& grammar) { return grammar; };
};

/// The edit without exceptions at whose address something stood in `before` and nothing stands now, and with `changes` that
/// say so and how many elements are drawn, if the number is another one. Throws InputError and LimitError as derive() if the
/// edited grammar cannot be drawn, and InputError if it draws nothing though `before` did.
EditResult checked_edit(const Grammar& before, EditResult edit, const CheckEditOptions& options = {},
                        const Progress& progress = {});

}  // namespace rinceau

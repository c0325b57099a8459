#pragma once
// What the tools do to a document, as values: they may take their time, so that they are used outside update().

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "editor/model/document.h"
#include "lsystem/edit_replace.h"
#include "lsystem/randomize.h"
#include "lsystem/symmetrize.h"

namespace rinceau {

struct RandomizeEdit {
    RandomizeOptions options;
};
struct SymmetrizeEdit {
    SymmetrizeOptions options;
};
struct ReplaceEdit {
    Replacement replacement;
    ReplaceOptions options;  ///< but for `derive` and `resolve`, which are the document's
};

using ToolEdit = std::variant<RandomizeEdit, SymmetrizeEdit, ReplaceEdit>;

std::shared_ptr<const ToolEdit> shared_edit(ToolEdit edit);

/// What the edit is called in the history: "randomize", without a full stop.
std::string tool_label(const ToolEdit& edit);

struct ToolResult {
    std::shared_ptr<const Grammar> grammar;
    std::shared_ptr<const Grammar> resolved;
    std::vector<std::string> changes;  ///< as EditResult::changes; empty = nothing is different
};

/// The edit, without what is locked (lsystem/keep_locked.h), checked (lsystem/check_edit.h). Throws as the edits, keep_locked()
/// and checked_edit().
ToolResult use_tool(const Document& document, const ToolEdit& edit);

/// Is using a tool on this document surely done before a frame is?
bool is_quick_to_edit(const Document& document, std::size_t elements);

}  // namespace rinceau

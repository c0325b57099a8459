#pragma once
// Undo and redo: documents of the past and of the future.

#include <string>
#include <vector>

#include "editor/model/document.h"

namespace rinceau {

/// What an edit was called, and the document before it (past) or after it (future).
struct HistoryStep {
    std::string label;  ///< "set Row.count", without a full stop
    Document document;
};

struct History {
    std::vector<HistoryStep> past;    ///< oldest first
    std::vector<HistoryStep> future;  ///< the next to redo last
};

/// The history after an edit of `before`: nothing is left to redo. Keeps the newest 1000 steps.
History recorded(History history, const Document& before, std::string label);

/// The document before the last edit, and the history that goes with it; unchanged if there is none.
struct HistoryMove {
    Document document;
    History history;
    std::string label;  ///< of the edit that was undone or redone; empty = there was none
};
HistoryMove undone(const Document& current, History history);
HistoryMove redone(const Document& current, History history);

}  // namespace rinceau

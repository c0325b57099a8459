// Copies for emergencies, and the preferences.

#include <utility>

#include "editor/model/state_preferences.h"
#include "editor/model/update_file_parts.h"

namespace rinceau {
namespace {

using Kind = FileIntent::Kind;

void keep_copy(Update& update, double seconds) {
    EditorState& state = update.state;
    RecoveryState& recovery = state.recovery;
    if (!has_unsaved_changes(state)) {
        if (!recovery.kept) return;
        recovery.kept.reset();
        update.requests.push_back(RemoveRecovery{});
        return;
    }
    if (recovery.writing || (recovery.kept && same_version(*recovery.kept, state.document))) return;
    if (recovery.last && seconds < *recovery.last + state.recovery.interval) return;
    recovery.writing = true;
    recovery.last = seconds;
    update.requests.push_back(WriteRecovery{state.document, state.canvas.view, state.file.path, state.file.stamp});
}

void keep_preferences(Update& update) {
    Preferences now = current_preferences(update.state);
    if (now == update.state.recovery.written) return;
    update.state.recovery.written = now;
    update.requests.push_back(WritePreferences{std::move(now)});
}

void perform_one(Update& update, const Tick& action) {
    keep_copy(update, action.seconds);
    keep_preferences(update);
}

void perform_one(Update& update, const LookForRecoverables&) { update.requests.push_back(FindRecoverables{}); }

void perform_one(Update& update, const RecoverablesFound& action) { update.state.recovery.found = action.found; }

void perform_one(Update& update, const RecoveryWritten& action) {
    RecoveryState& recovery = update.state.recovery;
    recovery.writing = false;
    recovery.kept = action.document;
    if (std::exchange(recovery.failing, false)) tell(update, MessageKind::note, "The copy for emergencies is written again");
}

void perform_one(Update& update, const RecoveryFailed& action) {
    RecoveryState& recovery = update.state.recovery;
    recovery.writing = false;
    if (std::exchange(recovery.failing, true)) return;
    tell(update, MessageKind::warning,
         "The copy for emergencies cannot be written (" + action.message + "): save the document now and then");
}

void perform_one(Update& update, const OpenRecoverable& action) { ask_or_perform(update, {Kind::recover, action.file}); }

void forget(RecoveryState& recovery, const std::string& file) {
    std::erase_if(recovery.found, [&](const Recoverable& entry) { return entry.file == file; });
}

void perform_one(Update& update, const DiscardRecoverable& action) {
    forget(update.state.recovery, action.file);
    update.requests.push_back(DiscardRecovery{action.file});
}

void perform_one(Update& update, const PostponeRecovery&) { update.state.recovery.found.clear(); }

void perform_one(Update& update, const DocumentRecovered& action) {
    EditorState& state = update.state;
    state.file.path = action.path;
    state.file.stamp = action.stamp;
    state.file.saved = {};
    state.file.opening.reset();
    state.file.awaits_rules = false;
    state.recovery.found.clear();
    update.requests.push_back(HoldFile{action.path});
    replace_document(update, action.document);
    state.recovery.kept = state.document;
    if (action.view) show_view(state, *action.view);
    tell(update, MessageKind::note,
         (action.path.empty() ? "A document without a file" : action.path) + " is recovered; it is not saved yet");
}

void perform_one(Update& update, const RecoverableFailed& action) {
    update.state.file.opening.reset();
    tell(update, MessageKind::mistake, action.message);
}

void perform_one(Update& update, const PreferencesRead& action) {
    EditorState& state = update.state;
    apply_preferences(state, action.preferences);
    state.recovery.written = current_preferences(state);
    if (!action.mistake.empty()) tell(update, MessageKind::warning, action.mistake);
}

}  // namespace

void perform(Update& update, const RecoveryAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau

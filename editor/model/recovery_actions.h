#pragma once
// Work that survives a crash: copies for emergencies, and the preferences.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "editor/model/document.h"
#include "editor/model/file_stamp.h"
#include "editor/model/preferences.h"
#include "editor/model/view_transform.h"

namespace rinceau {

/// A copy for emergencies that another window left.
struct Recoverable {
    std::string file;           ///< of the copy
    std::string path;           ///< that the document was opened from; empty = it had no file
    std::int64_t modified = 0;  ///< seconds since 1970
    std::string mistake;        ///< why it cannot be opened; empty = it can
};

/// About once a second: seconds of a clock that never goes back.
struct Tick {
    double seconds = 0;
};
/// The program has begun: what was left behind is looked for.
struct LookForRecoverables {};
struct RecoverablesFound {
    std::vector<Recoverable> found;
};
/// The copy was written, or could not be.
struct RecoveryWritten {
    Document document;
};
struct RecoveryFailed {
    std::string message;
};
/// What the user does with what was left behind; asks first about unsaved changes.
struct OpenRecoverable {
    std::string file;
};
struct DiscardRecoverable {
    std::string file;
};
/// Later: the copies stay, and are offered at the next start.
struct PostponeRecovery {};
/// The copy is open, and this window's own now.
struct DocumentRecovered {
    std::string file;
    std::string path;
    Document document;
    std::optional<FileStamp> stamp;
    std::optional<ViewTransform> view;
};
struct RecoverableFailed {
    std::string file;
    std::string message;
};
/// Preferences as they were read; `mistake` says why they are the usual ones.
struct PreferencesRead {
    Preferences preferences;
    std::string mistake;
};

struct RecoveryAction
    : std::variant<Tick, LookForRecoverables, RecoverablesFound, RecoveryWritten, RecoveryFailed, OpenRecoverable,
                   DiscardRecoverable, PostponeRecovery, DocumentRecovered, RecoverableFailed, PreferencesRead> {
    using variant::variant;
    RecoveryAction(const RecoveryAction&);
    RecoveryAction(RecoveryAction&&) noexcept;
    RecoveryAction& operator=(const RecoveryAction&);
    RecoveryAction& operator=(RecoveryAction&&) noexcept;
    ~RecoveryAction();
};

}  // namespace rinceau

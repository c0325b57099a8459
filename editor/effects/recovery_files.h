#pragma once
// Copies for emergencies: one a window, in the user's state folder.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/effects/held_lock.h"
#include "editor/model/recovery_actions.h"

namespace rinceau {

/// The copy of this window, and those that other windows left when they ended without being closed.
class RecoveryFiles {
  public:
    /// `folder` is made when it is needed; empty = there is none.
    explicit RecoveryFiles(std::string folder);

    /// Puts it in the place of this window's copy, as a whole or not at all. Throws OutputError.
    void write(std::string_view bytes);
    /// This window's copy goes, if there is one.
    void remove();

    /// Copies of windows that do not run any more, the newest first.
    std::vector<Recoverable> left_behind() const;
    /// One of these becomes this window's copy. Throws InputError if it is gone, or another window has taken it meanwhile.
    void adopt(const std::string& file);
    /// One of these goes for good.
    static void discard(const std::string& file);

  private:
    void begin();

    std::string folder_;
    std::string own_;  ///< empty until there was something to keep
    std::optional<HeldLock> lock_;
};

}  // namespace rinceau

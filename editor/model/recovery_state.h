#pragma once
// Copies for emergencies.

#include <optional>
#include <vector>

#include "editor/model/recovery_actions.h"

namespace rinceau {

struct RecoveryState {
    double interval = 50;          ///< seconds between two copies: none is ever older than a minute
    std::optional<Document> kept;  ///< what this window's copy holds; none = there is no copy
    std::optional<double> last;    ///< time of the clock when a copy was last asked for
    bool writing = false;
    bool failing = false;            ///< the last copy could not be written, and this was told
    std::vector<Recoverable> found;  ///< what is offered to the user
    Preferences written;             ///< preferences as the file has them
};

}  // namespace rinceau

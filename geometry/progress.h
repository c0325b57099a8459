#pragma once
// Progress of long work, as a parameter.

#include <functional>
#include <string_view>

namespace rinceau {

/// Called now and then with the stage's name and the share of it that is done, in [0, 1].
/// May throw to cancel the work: the core is exception-safe and keeps nothing half done. May be empty.
using Progress = std::function<void(std::string_view stage, double fraction)>;

inline void report(const Progress& progress, std::string_view stage, double fraction) {
    if (progress) progress(stage, fraction);
}

}  // namespace rinceau

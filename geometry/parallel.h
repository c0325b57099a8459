#pragma once
// Work on all processors whose result does not depend on their number.

#include <cstddef>
#include <functional>
#include <string_view>

#include "geometry/progress.h"

namespace rinceau {

/// Calls `work(k)` once for each k = 0 .. count - 1, in no order, on `threads` threads (0 = one per processor), the calling
/// one among them, or on as many as the system gives; returns when all is done. The calls must not touch what another one
/// changes. If some throw, one of their exceptions is thrown on; calls that were not begun by then may be left out.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// The same for long work that tells how far it is and ends when `progress` throws. What the calling thread's calls tell
/// reaches `progress`; between calls, and while it waits for the other threads, it tells again what was told last, `stage`
/// and 0 at first. On the other threads telling only sees whether to end.
void for_each_index(std::size_t count, int threads, std::string_view stage, const Progress& progress,
                    const std::function<void(std::size_t, const Progress&)>& work);

}  // namespace rinceau

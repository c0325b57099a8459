#pragma once
// Work on all processors whose result does not depend on their number.

#include <cstddef>
#include <functional>

namespace rinceau {

/// Calls `work(k)` once for each k = 0 .. count - 1, in no order, on `threads` threads (0 = one per processor), the calling
/// one among them; returns when all is done. The calls must not touch what another one changes. If some throw, one of their
/// exceptions is thrown on; calls that were not begun by then may be left out.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace rinceau

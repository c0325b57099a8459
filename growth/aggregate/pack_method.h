#pragma once
// Ways to fill an aggregate. A header of its own, so that panels need no more of growth.

#include <cstdint>

namespace rinceau {

/// darts: section 3.2. gaps: section 4. settle: candidates as in gaps, slid and turned into their gap before they are tried.
enum class PackMethod : std::uint8_t { naive, gaps, settle };

/// best: shapes also grow to the largest scale that fits, and all is shaken and filled again.
enum class PackQuality : std::uint8_t { fast, best };

}  // namespace rinceau

#pragma once
// How the elements of an arrangement are turned. A header of its own, so that panels need no more of growth.

#include <cstdint>

namespace rinceau {

/// Ijiri et al. 2008, section 5.3: elements keep their angle; rings are turned to fit best (eq. 4); the exemplar's x axis
/// follows the flow.
enum class RotationMode : std::uint8_t { fixed, rotate, flow };

}  // namespace rinceau

#pragma once
// Rings about one centre belong together: mandalas and polar lattices.

#include "analyzer/arrangement.h"

namespace rinceau {

/// The arrangements, in their order; rings whose centres, phases, radii, sizes and directions agree but for what they may
/// err by get the same ones: phases modulo half a step, radii evenly spaced where bodies of one kind stand in three rings
/// or more. Others are left alone. `forms`: of the kinds of bodies.
std::vector<Arrangement> aligned_rings(std::vector<Arrangement> arrangements, std::span<const BodyForm> forms);

}  // namespace rinceau

#pragma once
// A drawing of definitions and uses as one of real elements and clones of them, for programs in which people edit originals
// on the page.

#include <tinyxml2.h>

namespace rinceau {

/// What the definitions of the document draw is moved to where it is used first; the other uses become clones of that, with
/// transforms to match. The picture stays the same. Definitions that draw through others (gradients, clips, symbols) stay.
void make_originals_real(tinyxml2::XMLDocument& svg);

}  // namespace rinceau

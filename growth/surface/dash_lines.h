#pragma once
// Lines cut into their dashes.

#include <vector>

#include "scene/path.h"
#include "scene/style.h"

namespace rinceau {

/// The dashes of a stroke as open paths of straight lines, curves within `deviation`; without dashes the paths themselves.
/// Dashes so short that there are more than 100,000 stay one line: nobody would see them.
std::vector<Path> dash_lines(const std::vector<Path>& paths, const Stroke& stroke, double deviation);

}  // namespace rinceau

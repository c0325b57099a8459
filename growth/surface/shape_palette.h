#pragma once
// The colours that shape grammars name by number.

#include "scene/style.h"

namespace rinceau {

/// Colour(n): 0 white, 1 green, 2 red, 3 blue, 4 ochre, 5 brown, 6 grey, 7 black, 8 light green, 9 violet, 10 orange, 11
/// teal; other numbers wrap around, fractions are rounded down.
Color palette_color(double number);

/// Red, green and blue from 0 to 255, rounded; what lies outside is clamped.
Color color_of_channels(double red, double green, double blue);

}  // namespace rinceau

#pragma once
// Pictures of SVG documents, to see whether two of them look the same.

#include <string>

namespace rinceau {

/// The share (0..1) of inked pixels of either picture, `width` pixels wide over white, that differ by more than an eighth of
/// the range from every pixel of the other one within one pixel. 1 if the pictures differ in height.
double picture_difference(const std::string& svg, const std::string& other_svg, int width);

}  // namespace rinceau

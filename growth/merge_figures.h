#pragma once
// Figures of several drawings as those of one.

#include <span>
#include <string>
#include <vector>

#include "growth/figures.h"

namespace rinceau {

/// All figures, drawing after drawing, on the first one's canvas. Figures of drawing k are called names[k], with a number
/// behind it where it has several; their terminals after their figure, with a letter behind it where it has several parts.
/// Characters that no symbol may have become '_'; what clashes gets a number. Warnings are joined; instances are left out,
/// for each drawing has a plane of its own.
FiguredDrawing merged_figures(std::span<const FiguredDrawing> drawings, std::span<const std::string> names);

}  // namespace rinceau

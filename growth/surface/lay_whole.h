#pragma once
// A whole drawing laid through one chart: nothing of it can come apart.

#include <optional>

#include "growth/surface/lay_elements.h"
#include "growth/surface/surface_field.h"

namespace rinceau {

struct LayWholeOptions {
    const FieldOnSurface* field = nullptr;  ///< the chart is bent along it
    double follow = 0.4;                    ///< of the field's turning, at most
    double stretch = 1.5;                   ///< that an element may have; half of it above 1 is tried first without a field
    bool compact = false;                   ///< is_compact(): rather stretched up to most_compact_stretch than in pieces
    bool may_be_smaller = false;            ///< rather that than stretched by more than half, without a field
};

/// Neighbours that touch hide the stretch, gaps between them would be seen.
constexpr double most_compact_stretch = 2;

/// All of the chosen elements or nothing. With a field, bent along it as far as that goes without a fold; if it does not go
/// at all, compact drawings are laid straight and others are not laid.
std::optional<std::vector<LaidShape>> lay_whole(ElementLayer& layer, const DrawingStand& middle, const DrawnDisc& disc,
                                                std::span<const DrawnElement> elements, std::span<const int> chosen,
                                                const LayWholeOptions& options);

/// Those of the chosen elements that lie well in a chart of at most `radius` (of the drawing): the drawing ends where the
/// chart does.
std::vector<LaidShape> lay_part(ElementLayer& layer, const DrawingStand& middle, double radius,
                                std::span<const DrawnElement> elements, std::span<const int> chosen);

}  // namespace rinceau

#pragma once
// The looks of a picture, ready to be drawn: shapes, paints and gradients. Pure.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "editor/gl/gradient_table.h"
#include "editor/gl/look_paint.h"
#include "editor/gl/shape_store.h"
#include "editor/model/derived_picture.h"

namespace rinceau {

struct LookEntry {
    std::shared_ptr<Shape> shape;  ///< null if nothing is painted, or if it is verbatim
    LookPaint paint;
    std::array<std::uint32_t, 2> gradients{};     ///< numbers by LookPart; 0 = solid
    std::array<Affine, 2> to_unit;                ///< the shape's vertices -> the unit gradient, by LookPart
    std::shared_ptr<const std::string> verbatim;  ///< null if it is an outline
};

struct LookTable {
    std::shared_ptr<const DerivedPicture> picture;
    std::vector<LookEntry> looks;
    GradientTable gradients;
    bool has_verbatim = false;
};

/// Finds the shapes that earlier pictures had.
LookTable look_table(const std::shared_ptr<const DerivedPicture>& picture, ShapeStore& store);

}  // namespace rinceau

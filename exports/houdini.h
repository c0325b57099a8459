#pragma once
// Houdini's L-System SOP: premise and rules as text to be pasted into the node.

#include "exports/export.h"

namespace rinceau {

/// Houdini's turtle scales its default step only: the scale is an argument, and lengths are multiplied by it. Symbols and
/// parameters are single letters. Shapes are drawn by rules of their own: polygons and lines, curves within flatness_share
/// of the shape's size. Contexts, and functions whose meaning in Houdini is not documented, are written out.
Export to_houdini(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau

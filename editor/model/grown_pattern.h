#pragma once
// What has grown and is not yet the document: shown over the canvas, grown on, used or dropped.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "editor/model/derived_picture.h"
#include "editor/model/document.h"
#include "editor/model/growth_settings.h"
#include "editor/model/growth_source.h"
#include "growth/arrangement/element_arrangement.h"

namespace rinceau {

struct GrownPattern {
    GrowthTab kind = GrowthTab::arrangement;
    std::shared_ptr<const GrowthSource> source;             ///< null: nothing has grown yet
    std::shared_ptr<const ElementArrangement> arrangement;  ///< null of an aggregate
    std::vector<PlacedFigure> placed;
    std::vector<std::array<Point, 2>> edges;        ///< between neighbours of an arrangement
    std::shared_ptr<const DerivedPicture> picture;  ///< of what is placed, on its canvas; never null
    std::string told;                               ///< how much it is, in words
};

/// An empty canvas to paint on.
GrownPattern blank_pattern(const Box& canvas);

/// The box, `factor` times as wide and high about the same middle.
Box widened(const Box& box, double factor);

/// The picture of what is placed. `before` may be a picture of the same figures, whose grammar is shared if the canvas is
/// the same, or null.
std::shared_ptr<const DerivedPicture> picture_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed,
                                                 const Box& canvas, const std::shared_ptr<const DerivedPicture>& before);

/// The canvas with room for all that is placed: it grows by steps, so that it stays the same for a while.
Box roomy_canvas(const Box& canvas, const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed);

/// The document with what has grown as its grammar. Throws as with_grammar().
Document grown_document(const Document& document, const GrownPattern& pattern);

}  // namespace rinceau

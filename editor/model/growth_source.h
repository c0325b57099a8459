#pragma once
// The document as growth takes it: figures, and the exemplar of an arrangement.

#include <memory>
#include <optional>
#include <string>

#include "editor/model/source_question.h"
#include "geometry/progress.h"
#include "growth/arrangement/exemplar.h"
#include "growth/figures.h"

namespace rinceau {

struct GrowthSource {
    SourceQuestion question;
    std::shared_ptr<const FiguredDrawing> drawing;  ///< null: `mistake` says why
    std::optional<Box> tile;                        ///< the drawing repeats with this box, and has each element once
    std::shared_ptr<const Exemplar> exemplar;       ///< null: `mistake` says why; the figures may still be packed
    std::string mistake;
};

/// Takes the figures from `known` if they are those that are asked for. What is wrong with the drawing is said in the
/// result; throws what `progress` throws.
GrowthSource growth_source(const SourceQuestion& question, const std::shared_ptr<const GrowthSource>& known,
                           const Progress& progress = {});

}  // namespace rinceau

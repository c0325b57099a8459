#pragma once
// The document as growth takes it: figures, and the exemplar of an arrangement.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/progress.h"
#include "growth/arrangement/exemplar.h"
#include "growth/figures.h"

namespace rinceau {

/// What is to be read, and how.
struct SourceQuestion {
    std::shared_ptr<const Grammar> grammar;  ///< with all that it uses
    std::string raised;                      ///< GrowthSettings
    bool group = true;
    std::vector<std::pair<int, int>> flips;  ///< ExemplarOptions
    friend bool operator==(const SourceQuestion&, const SourceQuestion&) = default;
};

struct GrowthSource {
    SourceQuestion question;
    std::shared_ptr<const FiguredDrawing> drawing;  ///< null: `mistake` says why
    std::shared_ptr<const Exemplar> exemplar;       ///< null: `mistake` says why; the figures may still be packed
    std::string mistake;
};

/// Takes the figures from `known` if they are those that are asked for. What is wrong with the drawing is said in the
/// result; throws what `progress` throws.
GrowthSource growth_source(const SourceQuestion& question, const std::shared_ptr<const GrowthSource>& known,
                           const Progress& progress = {});

}  // namespace rinceau

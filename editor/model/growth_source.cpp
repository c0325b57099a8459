#include "editor/model/growth_source.h"

#include <stdexcept>
#include <utility>

#include "growth/arrangement/tile_of_drawing.h"

namespace rinceau {
namespace {

constexpr const char* label = "The drawing";

bool same_figures(const SourceQuestion& a, const SourceQuestion& b) {
    return a.grammar == b.grammar && a.raised == b.raised && a.group == b.group;
}

/// Puts the figures, and the tile that they are best read as, into the source.
void read_figures(GrowthSource& source, const Progress& progress) {
    FigureOptions options{.group = source.question.group};
    if (!source.question.raised.empty()) options.raised = {source.question.raised};
    FiguredDrawing drawing = figures_of(*source.question.grammar, options, progress);
    source.tile = sensible_tile(drawing);
    if (source.tile) drawing = as_tile(drawing, *source.tile);
    source.drawing = std::make_shared<const FiguredDrawing>(std::move(drawing));
}

}  // namespace

GrowthSource growth_source(const SourceQuestion& question, const std::shared_ptr<const GrowthSource>& known,
                           const Progress& progress) {
    GrowthSource source{.question = question};
    try {
        if (known && known->drawing && same_figures(known->question, question)) {
            source.drawing = known->drawing;
            source.tile = known->tile;
        } else {
            read_figures(source, progress);
        }
        report(progress, "neighbours", 0);
        source.exemplar = std::make_shared<const Exemplar>(
            make_exemplar(*source.drawing, {.tile = source.tile, .flips = question.flips}, label));
    } catch (const std::runtime_error& error) {
        source.mistake = error.what();
    }
    return source;
}

}  // namespace rinceau

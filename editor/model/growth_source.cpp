#include "editor/model/growth_source.h"

#include <stdexcept>

namespace rinceau {
namespace {

constexpr const char* label = "The drawing";

bool same_figures(const SourceQuestion& a, const SourceQuestion& b) {
    return a.grammar == b.grammar && a.raised == b.raised && a.group == b.group;
}

std::shared_ptr<const FiguredDrawing> figures(const SourceQuestion& question, const Progress& progress) {
    FigureOptions options{.group = question.group};
    if (!question.raised.empty()) options.raised = {question.raised};
    return std::make_shared<const FiguredDrawing>(figures_of(*question.grammar, options, progress));
}

}  // namespace

GrowthSource growth_source(const SourceQuestion& question, const std::shared_ptr<const GrowthSource>& known,
                           const Progress& progress) {
    GrowthSource source{question, nullptr, nullptr, {}};
    try {
        const bool at_hand = known && known->drawing && same_figures(known->question, question);
        source.drawing = at_hand ? known->drawing : figures(question, progress);
        report(progress, "neighbours", 0);
        source.exemplar = std::make_shared<const Exemplar>(make_exemplar(*source.drawing, {.flips = question.flips}, label));
    } catch (const std::runtime_error& error) {
        source.mistake = error.what();
    }
    return source;
}

}  // namespace rinceau

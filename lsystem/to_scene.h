#pragma once
// Placements as a drawing.

#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/interpret.h"
#include "lsystem/text_pieces.h"
#include "scene/element.h"

namespace rinceau {

/// Each placement as an element of its own, in paint order: paths and style carried to the scene by the pose.
Scene to_scene(const Grammar& grammar, const std::vector<Placement>& placements);

enum class ColorBy : unsigned char { none, rule, terminal, level };

struct GrammarSvgOptions {
    ColorBy color_by = ColorBy::none;  ///< paint each placement by its production, terminal or address length instead
};

/// The picture as SVG: one <symbol>/<g> definition per (terminal, style) used more than once and a <use> per placement;
/// what is placed once stands inline. Numbers keep 1e-4 px at the picture's size or better.
std::string grammar_svg(const Grammar& grammar, const std::vector<Placement>& placements,
                        const GrammarSvgOptions& options = {});

/// The text of grammar_svg for interpret(grammar, derivation), as it is derived, in pieces. The grammar is derived once to
/// see what is drawn, and then once for each layer: memory is proportional to the depth of the derivation and to the
/// different things that it draws; with more than 8 layers also to the placements. Color_by level needs addresses. Throws as
/// interpret(), before the first piece, and as the sink.
void write_grammar_svg(const Grammar& grammar, const InterpretOptions& derivation, const GrammarSvgOptions& options,
                       const TextSink& sink, const Progress& progress = {});

}  // namespace rinceau

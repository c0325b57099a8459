#pragma once
// What growth works with: the things in a drawing that a person sees as one element each, whatever number of shapes they
// are drawn with, and where their copies stand. Both growth modules of the plane begin here.

#include <string>
#include <vector>

#include "geometry/progress.h"
#include "lsystem/grammar.h"
#include "lsystem/interpret.h"
#include "scene/painted_region.h"

namespace rinceau {

/// One thing that is repeated: a terminal, all that a raised non-terminal draws, or shapes that belong together because
/// they touch.
struct Figure {
    /// The grammar's; of a group, the symbols of its parts, each once, joined by '+'. No two figures have the same: a second
    /// one of the name has ".2" behind it.
    std::string symbol;
    std::vector<Placement> parts;  ///< in paint order; poses lead from the terminal's frame to the figure's
    /// What it paints, in its own frame, whose origin is the centre of the box of this region. Never without area.
    Region outline;
    double radius = 0;  ///< of the circle about the origin that holds the outline
};

struct FigureInstance {
    int figure = 0;
    Similarity pose;  ///< figure frame -> scene
    /// False: the picture's edge or a clip cuts it, or it is kept as SVG text. It says where a neighbour stands, and is
    /// never a thing to be repeated.
    bool whole = true;
};

/// A drawing as figures. Instances are in paint order of their lowest parts.
struct FiguredDrawing {
    Grammar grammar;  ///< whose terminals and styles the parts name
    std::vector<Figure> figures;
    std::vector<FigureInstance> instances;
    std::vector<std::string> warnings;
};

struct FigureOptions {
    /// Non-terminals whose every expansion is one figure ("--element P2"). An outer one takes what an inner one would.
    std::vector<std::string> raised;
    /// Shapes outside of raised symbols are joined where one lies inside another or they touch, and where an expansion of a
    /// group holds shapes that are nearer to each other than to anything else.
    bool group = true;
    /// Largest distance of an outline from what is drawn, as a share of the figure's diagonal.
    double deviation = 0.002;
    /// The whole drawing is a single figure: a silhouette made of several shapes.
    bool one_figure = false;
};

/// What the grammar draws as figures. Throws InputError for a raised symbol that the grammar does not expand (it names those
/// that can be raised), and as interpret().
FiguredDrawing figures_of(const Grammar& grammar, const FigureOptions& options = {}, const Progress& progress = {});

/// A copy of a figure somewhere else.
struct PlacedFigure {
    int figure = 0;
    Similarity pose;                ///< figure frame -> scene
    std::vector<Repaint> repaints;  ///< of the figure's parts, one each; empty = as drawn
};

/// The placements of what is placed, in the order given: for grammar_svg and flat grammars of figures.grammar's terminals.
std::vector<Placement> placements_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed);

/// A grammar that draws what is placed and nothing else: a production for each figure of several parts, and an axiom that
/// lists the figures. Terminals and styles that are not used are left out.
Grammar grammar_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed, const Box& canvas);

}  // namespace rinceau

#pragma once
// The shapes of a grammar from what its text says of them: shape leaf = outline "leaf.svg" height = 0.3.

#include <functional>

#include "growth/surface/grammar_shape.h"
#include "growth/surface/named_file.h"
#include "growth/surface/shape_grammar.h"

namespace rinceau {

/// The value of a setting, an expression of the grammar's params. Throws InputError.
using NumberOfSetting = std::function<double(const Expression& expression)>;

/// A shape that fills the unit scope, its mesh closed. Kinds, with their settings and defaults:
///   box                                             standing
///   tile       round = 0.12, bevel = 0.08, detail = 3 (edges a corner)
///   cylinder   detail = 12                          along x
///   sphere, ellipsoid  detail = 16                  about the position
///   torus      tube = 0.14 (radius), detail = 24    about the position
///   disc, ellipse      height = 1, detail = 24
///   cone       detail = 16;  pyramid
///   prism      sides = 6, height = 1
///   star       points = 5, inner = 0.45, height = 1
///   leaf       height = 1, detail = 8 (edges a side)
///   arrow      shaft = 0.4, head = 0.45, height = 1
///   glyph      lines = 1, gap = 0.1, height = 1, detail = 48
///   outline "x.svg"  height = 1, deviation = 0.004, fit = page (its page fills the scope) or ink (what is drawn does)
///   mesh "x.obj" (.off, .ply)  up = z or y, the whole scaled to the scope
/// and for all of them collide = box, disc, hull or outline, colour = "#rrggbb", and where there is detail or deviation
/// also faces = n, which chooses it. Throws InputError, with the place of the source or of the file, for kinds, settings and
/// values that are none of these, and for files without anything to make a shape of.
GrammarShape make_shape(const ShapeSource& source, const ReadNamedFile& read_file, const NumberOfSetting& number_of);

}  // namespace rinceau

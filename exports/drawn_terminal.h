#pragma once
// A terminal in one style, as programs with lines and filled polygons in plain colours draw it. Internal to the folder.

#include <optional>
#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

using Polygon = std::vector<Point>;

/// In the terminal's own frame: y up, heading = +y.
struct DrawnTerminal {
    std::optional<Color> fill;
    std::vector<Polygon> polygons;  ///< filled one by one; holes are cut in from the outside along a slit
    std::optional<Color> line;
    double width = 1;
    bool fixed_width = false;    ///< whatever the scale
    std::vector<Path> outlines;  ///< of the lines
    bool line_first = false;
};

/// Share of a terminal's size by which its polygons and polylines may differ from its curves.
constexpr double flatness_share = 1.0 / 2000;

/// The length that flatness_share refers to: the diagonal of the outline's box.
double outline_size(const Terminal& terminal);

/// Nothing is drawn of a fragment (Terminal::verbatim).
DrawnTerminal drawn_terminal(const Terminal& terminal, const Style& style);

/// Corners of the path, curves flattened; a closed path ends where it began.
Polygon polyline_of(const Path& path, double deviation);

/// Throws InputError if all terminals are fragments of SVG: `format` would draw nothing.
void expect_outlines(const Grammar& grammar, const std::string& format);

/// One sentence for each thing of the grammar's styles, terminals and layers that lines and polygons in plain colours cannot
/// hold: gradients, opacities, dashes, pens, fragments, layers, .. `format` begins the sentences: "L-Py".
std::vector<std::string> drawing_notes(const Grammar& grammar, const std::string& format);

}  // namespace rinceau

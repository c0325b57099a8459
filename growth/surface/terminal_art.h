#pragma once
// What a drawn terminal paints, as flat triangles in few colours: ready to be laid on a surface.

#include <array>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/interpret.h"
#include "lsystem/style_table.h"
#include "scene/painted_region.h"

namespace rinceau {

/// One colour; its triangles cover the region without overlap.
struct ArtLayer {
    Color color;
    int level = 0;       ///< 0 = painted first, 1 = above it
    double opacity = 1;  ///< that `color` was mixed with the ground by
    std::vector<Point> points;
    std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise
    std::vector<std::array<int, 2>> borders;    ///< edges of one triangle, which lies on their left
    double area = 0;                            ///< of all triangles
};

/// In the terminal's frame. No layers: it paints nothing that can be laid.
struct TerminalArt {
    std::vector<ArtLayer> layers;
    Box box;
    std::vector<Point> hull;  ///< convex, counter-clockwise, about all layers
};

/// What could not be kept, counted.
struct ArtLosses {
    long gradients = 0;    ///< placements painted in the gradient's mean colour
    long translucent = 0;  ///< placements painted in one colour, mixed with the ground's
    long verbatim = 0;     ///< placements of fragments of SVG, left out
    long empty = 0;        ///< placements that paint nothing
};

/// The colour of an opaque body under a drawing that lets it through.
constexpr Color ground_color{225, 222, 214};

/// The art of placements, made once for each terminal, style, colours and size. Refers to the grammar, which must outlive
/// it.
class ArtStore {
  public:
    /// `deviation`: how far triangles may lie from a curve, as a share of the drawn thing's radius; never less than
    /// `finest`, a length of the drawing.
    ArtStore(const Grammar& grammar, double deviation, double finest);

    const TerminalArt& art(const Placement& placement);
    const ArtLosses& losses() const { return losses_; }

  private:
    using Key = std::tuple<int, int, std::array<int, 2>, int, double>;
    struct Known {
        TerminalArt art;
        bool gradient = false, translucent = false;
    };
    Known made(const Placement& placement, double scale) const;

    const Grammar* grammar_;
    StyleTable styles_;
    double deviation_;
    double finest_;
    std::map<Key, std::unique_ptr<Known>> known_;
    ArtLosses losses_;
};

/// The mean of a gradient's stops over its unit, in linear order; opacities weigh.
Color mean_color(const Gradient& gradient);

}  // namespace rinceau

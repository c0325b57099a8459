#pragma once
// Elements of a drawing laid on a surface together, through one chart about their middle.

#include <span>
#include <vector>

#include "growth/surface/laid_shape.h"
#include "growth/surface/surface_turtle.h"

namespace rinceau {

/// An element with what it paints; art is nullptr if it is not to be laid.
struct DrawnElement {
    const TerminalArt* art = nullptr;
    Similarity pose;          ///< terminal -> drawing
    std::vector<Point> hull;  ///< of the art, in the drawing
    Box box;
};

DrawnElement drawn_element(const TerminalArt& art, const Similarity& pose);

/// A disc of the drawing about the middle of the box of some elements.
struct DrawnDisc {
    Point centre;
    double radius = 0;
    double largest = 0;  ///< radius of the largest of them, about its own middle
};
DrawnDisc disc_of(std::span<const DrawnElement> elements, std::span<const int> chosen);

/// The narrowest rectangle about an element.
struct DrawnStrip {
    Point centre;
    Complex along{1, 0};  ///< of length 1
    double half_length = 0, half_width = 0;
};
DrawnStrip strip_of(const DrawnElement& element);

/// The chart, with the drawing's place at its origin and the drawing's x along its own.
struct ElementChart {
    DrawingChart chart;
    DrawingStand middle;
    double scale = 1;  ///< chart length of a unit of the drawing

    Point of(Point drawn) const { return scale * (drawn - middle.drawn); }
};

/// Makes charts and lays elements through them. Refers to the surface, which must outlive it.
class ElementLayer {
  public:
    ElementLayer(const SurfaceMesh& surface, double scale, bool rims)
        : surface_(&surface), scale_(scale), rims_(rims), patches_(surface) {}

    /// `radius` in the drawing.
    ElementChart polar_chart(const DrawingStand& middle, double radius);
    /// The same with its stretch shared out; wider, as what lies within the radius moves.
    ElementChart relaxed_polar_chart(const DrawingStand& middle, double radius);

    /// For a whole drawing: relaxed, and only what lies under it (`drawn`, a box of the drawing) and about it; without faces
    /// that the polar map has torn, so that it may reach round the body.
    ElementChart sheet_chart(const DrawingStand& middle, double radius, const Box& drawn);
    /// The same chart bent along a field (relax_chart.h).
    ElementChart bent(const ElementChart& chart, const FieldOnSurface& field, double follow) const;

    /// Only the faces along the strip through the middle, relaxed: a narrow strip of any surface lies nearly flat.
    ElementChart strip_chart(const DrawingStand& middle, double radius, const DrawnStrip& strip);

    struct Size {
        double factor = 1;  ///< of the elements, about `about`
        Point about;        ///< place in the drawing
    };
    struct Result {
        LayFault fault = LayFault::none;  ///< of the first element found that cannot be laid; then there are no shapes
        std::vector<LaidShape> shapes;    ///< as chosen
    };
    /// All of the chosen elements, or none.
    Result lay(const ElementChart& chart, std::span<const DrawnElement> elements, std::span<const int> chosen,
               double stretch, const Size& size = {1, {}});

    double scale() const { return scale_; }
    const SurfaceMesh& surface() const { return *surface_; }

  private:
    LayFault lay_one(const ElementChart& chart, const DrawnElement& element, double stretch, const Size& size,
                     LaidShape& shape);

    const SurfaceMesh* surface_;
    double scale_;
    bool rims_;
    PatchMaker patches_;
    ChartVisits visits_;
};

}  // namespace rinceau

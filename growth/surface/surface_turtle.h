#pragma once
// A drawing's turtle on a surface.

#include <optional>
#include <vector>

#include "growth/surface/trace.h"
#include "growth/surface/turtle_script.h"

namespace rinceau {

/// Where the drawing's place `drawn` stands on the surface, and how the drawing lies about it. Turns, scales and mirrors are
/// those of the turtle in the drawing; on the surface only its moves differ.
struct DrawingStand {
    SurfacePoint at;
    Complex turn{1, 0};  ///< of length 1: takes a direction of the drawing to one of the frame of at's face
    Point drawn;
};

struct TurtleWays {
    const FieldOnSurface* field = nullptr;  ///< nullptr = straight
    double follow = 0.4;                    ///< of the field's turning (TraceOptions::follow)
    double scale = 1;                       ///< surface length of a unit of the drawing
};

/// The stand after a move to another place of the drawing: along the field, or straight. Nothing if a border is in the way.
std::optional<DrawingStand> moved(const SurfaceMesh& surface, const TurtleWays& ways, const DrawingStand& from, Point to);

/// The turtle of a script: it stands, moves, and remembers. After a border or a stop it does nothing until the bracket ends.
class SurfaceTurtle {
  public:
    SurfaceTurtle(const SurfaceMesh& surface, const TurtleWays& ways, const DrawingStand& start)
        : surface_(&surface), ways_(ways), stand_(start) {}

    const DrawingStand& stand() const { return stand_; }
    /// Does it still draw?
    bool goes() const { return !stopped_; }
    /// False if a border is in the way: it stops.
    bool move(Point to);
    /// Stands elsewhere, of the same place in the drawing.
    void set(const DrawingStand& stand) { stand_ = stand; }
    void push() { stack_.push_back({stand_, stopped_}); }
    void pop();
    void stop() { stopped_ = true; }

  private:
    struct Saved {
        DrawingStand stand;
        bool stopped = false;
    };
    const SurfaceMesh* surface_;
    TurtleWays ways_;
    DrawingStand stand_;
    bool stopped_ = false;
    std::vector<Saved> stack_;
};

}  // namespace rinceau

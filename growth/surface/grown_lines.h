#pragma once
// Lines that a grammar draws on a surface, piece by piece, and where they end at others (Li et al. 2010, section 4.4.2).

#include <optional>
#include <vector>

#include "growth/surface/line_space.h"
#include "growth/surface/shape_scope.h"
#include "growth/surface/surface_pattern.h"

namespace rinceau {

/// What Line(merge) says, and how wide the pieces are.
struct LinePen {
    bool merge = false;
    double width = 0;
    Color color{204, 204, 204};
};

class GrownLines {
  public:
    explicit GrownLines(const SurfaceMesh& surface) : surface_(&surface) {}

    /// Draws along `path` (points on the surface, its pieces within faces), going on with the scope's line if the scope
    /// still stands at its end, otherwise with a new one, and leaves the scope at the end. With pen.merge the line ends at
    /// the first other line that it meets, on that line: then this is true and the scope has no line any more.
    bool draw(ShapeScope& scope, const std::vector<SurfacePoint>& path, const LinePen& pen);

    /// Moves the end of the scope's line, if the scope stands there, to another place near it.
    void end_at(const ShapeScope& scope, SurfacePoint place);

    const std::vector<PatternLine>& lines() const { return lines_; }
    long points() const { return points_; }

    /// Between begin_set() and keep_set() or drop_set() new pieces are no obstacles, and can be taken back.
    void begin_set();
    void keep_set();
    void drop_set();

  private:
    struct Piece {
        SpacePoint from, to;
        double width;
        int line;
    };
    struct SetLine {
        int line;
        std::size_t points;
        int segments;
        SurfacePoint last;
    };
    const SurfaceMesh* surface_;
    LineSpace space_;
    std::vector<PatternLine> lines_;
    long points_ = 0;
    bool in_set_ = false;
    std::size_t lines_before_ = 0;
    std::vector<SetLine> changed_;  ///< lines from before the set, as they were
    std::vector<Piece> waiting_;

    bool stands_at_end(const ShapeScope& scope, SpacePoint position) const;
    /// How a line from before the set was, the first time that the set changes it.
    void remember(int index);
    void move_end(PatternLine& line, SurfacePoint place);
    PatternLine& line_of(ShapeScope& scope, SurfacePoint start, const LinePen& pen);
    void append(PatternLine& line, SurfacePoint at, SpacePoint point, double width);
    int own_neighbours(const PatternLine& line, double width) const;
};

}  // namespace rinceau

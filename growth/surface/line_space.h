#pragma once
// Where lines meet lines (Li et al. 2010, section 4.4.2).

#include <memory>
#include <optional>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

struct LineMeeting {
    int line = 0;
    int piece = 0;     ///< of that line, in the order in which they were added
    double share = 0;  ///< of the new piece, in [0, 1], where it meets
    SpacePoint point;  ///< on the line that was there
};

/// Straight pieces of lines.
class LineSpace {
  public:
    LineSpace();
    ~LineSpace();
    LineSpace(LineSpace&&) noexcept;
    LineSpace& operator=(LineSpace&&) noexcept;

    /// The first meeting along a new piece with pieces of other lines, or with earlier ones of its own that are not the last
    /// `skip` of it.
    std::optional<LineMeeting> first_meeting(SpacePoint from, SpacePoint to, double width, int line, int skip) const;
    void add(SpacePoint from, SpacePoint to, double width, int line);

  private:
    struct Pieces;
    std::unique_ptr<Pieces> pieces_;
};

}  // namespace rinceau

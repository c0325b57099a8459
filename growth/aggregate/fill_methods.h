#pragma once
// One try of each way to fill a domain (Sakurai & Miyata 2014, sections 3.2, 4.1 and 4.2). With `growing`, what has found a
// place grows to the largest scale that fits there.

#include <vector>

#include "growth/aggregate/cell_lists.h"
#include "growth/aggregate/packing.h"

namespace rinceau {

/// Section 3.2: anywhere, at any angle.
void try_dart(Packing& packing, bool growing);

/// Section 4.1: darts whose bounding circles keep apart.
class SparseStart {
  public:
    explicit SparseStart(const Packing& packing);
    void try_circle(Packing& packing);

  private:
    bool is_apart(const Packing& packing, Point at, double radius) const;
    CellLists circles_;  ///< owners: what is placed, in the cell of its origin
    double reach_ = 0;   ///< the largest radius
};

/// Section 4.2: 100 points from the field, then a placement at each; the field is made anew for the next 100.
class GapRound {
  public:
    /// False if there is no gap left.
    bool try_point(Packing& packing, bool growing);

  private:
    std::vector<Point> points_;  ///< P, last one first
};

/// A point from the field as it is now, and a shape that settles about it; with `growing`, it also shrinks to fit. False if
/// there is no gap left.
bool try_settled(Packing& packing, bool growing);

}  // namespace rinceau

#pragma once
// Whose turn it is: shapes take turns so that each keeps its share (Sakurai & Miyata 2014, section 3.2: "cyclically").

#include <cstddef>
#include <vector>

namespace rinceau {

/// The shape that is farthest behind its share is next; equal shares make that the paper's cycle. One that finds no place
/// holds up all others, so after some cancellations the next one may go first, as long as no share is missed by more than
/// allowed.
class ShapeTurn {
  public:
    /// `shares` are positive or 0 and not all 0; they need not add up to 1. `tolerance`: relative, 1 and more = no limit.
    ShapeTurn(std::vector<double> shares, double tolerance);

    int next() const { return next_; }
    void placed(int shape);
    void cancelled();

  private:
    bool within_tolerance(std::size_t shape) const;
    double shortfall(std::size_t shape) const;
    void choose();

    std::vector<double> shares_;
    double tolerance_ = 0;
    std::vector<double> counts_;
    double total_ = 0;
    std::vector<bool> passed_over_;  ///< could not be placed since the last one was
    int next_ = 0;
    int cancellations_ = 0;  ///< in a row, of the shape whose turn it is
};

}  // namespace rinceau

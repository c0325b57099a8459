#pragma once
// Colours by number, for formats that have a table of them. Internal to the folder.

#include <vector>

#include "scene/style.h"

namespace rinceau {

/// Numbers from `first` up to `last`; when all are given away, a colour gets the number of the nearest.
class Palette {
  public:
    Palette(int first, int last) : first_(first), last_(last) {}
    int number_of(Color color);
    /// The color of first_, first_ + 1, ..
    const std::vector<Color>& colors() const { return colors_; }
    /// Did a colour get another's number?
    bool overflowed() const { return overflowed_; }

  private:
    int first_;
    int last_;
    std::vector<Color> colors_;
    bool overflowed_ = false;
};

}  // namespace rinceau

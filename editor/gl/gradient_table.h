#pragma once
// Gradients as the graphics card looks them up: a row of colours and a few numbers each. Pure.

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "scene/style.h"

namespace rinceau {

/// Colours along a gradient: `ramp_colors` of the way from 0 to 1, and before and after them what lies beyond.
constexpr int ramp_colors = 512;
constexpr int ramp_texels = ramp_colors + 2;
using GradientRamp = std::array<std::array<std::uint8_t, 4>, ramp_texels>;  ///< not multiplied by opacity

GradientRamp gradient_ramp(const std::vector<GradientStop>& stops);

/// What of a gradient is the same wherever it lies.
struct GradientEntry {
    int ramp = 0;  ///< row
    GradientKind kind = GradientKind::linear;
    GradientSpread spread = GradientSpread::pad;
    Point focus;
    double focal_radius = 0;
};

class GradientTable {
  public:
    static constexpr std::size_t most_ramps = 8192;  ///< rows of a texture that every OpenGL 3.3 has

    /// The number of a gradient, from 1; equal gradients in different places share it. Beyond most_ramps, the last row is
    /// used.
    std::uint32_t number(const Gradient& gradient);

    const std::vector<GradientRamp>& ramps() const { return ramps_; }
    const std::vector<GradientEntry>& entries() const { return entries_; }
    bool overflows() const { return overflows_; }

  private:
    using StopKey = std::vector<double>;
    int ramp(const std::vector<GradientStop>& stops);

    std::map<StopKey, int> ramp_numbers_;
    std::map<std::array<double, 6>, std::uint32_t> entry_numbers_;
    std::vector<GradientRamp> ramps_;
    std::vector<GradientEntry> entries_;
    bool overflows_ = false;
};

}  // namespace rinceau

// After McGuire et al. 2011, The Alchemy screen-space ambient obscurance algorithm: a tap hides as much as it stands above
// the sample's tangent plane, seen from the sample, less with distance.

#include "growth/mesh/depth_occlusion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/angle.h"
#include "geometry/index.h"
#include "geometry/parallel.h"

namespace rinceau {
namespace {

constexpr int taps = 16;
constexpr int tile = 4;              // the taps' turns repeat after so many samples each way
constexpr double least_rise = 0.08;  // sine above the tangent plane; below it is rounding and the bend of the surface
constexpr double strength = 3;     // so that the inner edge of a box gets about half of the light

constexpr double nothing = -std::numeric_limits<double>::infinity();

/// A tap's place: right and up, in samples.
struct Tap {
    double right = 0, up = 0;
};

/// A spiral of two and a half turns for each turn of the tile; denser in the middle, where contact is.
std::vector<std::array<Tap, taps>> turned_taps(double radius) {
    constexpr double spiral_turns = 2.5;
    std::vector<std::array<Tap, taps>> all;
    for (int i = 0; i < tile * tile; ++i) {
        // Neighbours of the tile differ much: steps of 5 are coprime to 16.
        const double turn = two_pi * ((5 * i) % (tile * tile)) / (tile * tile);
        std::array<Tap, taps> list{};
        for (int k = 0; k < taps; ++k) {
            const double share = (k + 0.5 + 0.5 * (i % 2)) / taps;
            const double reach = std::max(1.0, radius * std::pow(share, 1.5));
            const double angle = turn + two_pi * spiral_turns * share;
            list[static_cast<std::size_t>(k)] = {reach * std::cos(angle), reach * std::sin(angle)};
        }
        all.push_back(list);
    }
    return all;
}

class SkyFinder {
  public:
    SkyFinder(const DepthImage& image, double radius) : image_(image), radius_(radius), taps_(turned_taps(radius)) {}

    std::vector<float> find() {
        constexpr int all_processors = 0;
        raw_.assign(image_.depth.size(), 1);
        const auto rows = static_cast<std::size_t>(image_.height);
        for_each_index(rows, all_processors, [&](std::size_t row) { find_row(static_cast<int>(row)); });
        std::vector<float> smooth(raw_.size(), 1);
        for_each_index(rows, all_processors, [&](std::size_t row) { smooth_row(static_cast<int>(row), smooth); });
        return smooth;
    }

  private:
    const DepthImage& image_;
    double radius_;
    std::vector<std::array<Tap, taps>> taps_;
    std::vector<float> raw_;

    std::size_t at(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(column);
    }

    void find_row(int row) {
        for (int column = 0; column < image_.width; ++column) {
            const std::size_t i = at(row, column);
            if (image_.depth[i] == nothing) continue;
            const auto turn = table_index(row % tile, column % tile, tile);
            double hidden = 0;
            for (const Tap& tap : taps_[turn]) hidden += hidden_by(tap, row, column, i);
            raw_[i] = static_cast<float>(std::max(0.0, 1 - strength * hidden / taps));
        }
    }

    double hidden_by(const Tap& tap, int row, int column, std::size_t i) const {
        const int x = column + static_cast<int>(std::lround(tap.right)), y = row - static_cast<int>(std::lround(tap.up));
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return 0;
        const double above = image_.depth[at(y, x)] - image_.depth[i];
        if (!(above > -radius_)) return 0;  // far below, or nothing there
        const auto& n = image_.normals[i];
        const double right = x - column, up = row - y, square = right * right + up * up + above * above;
        if (square == 0) return 0;
        const double rise =
            (right * static_cast<double>(n[0]) + up * static_cast<double>(n[1]) + above * static_cast<double>(n[2])) /
            std::sqrt(square);
        const double far = square / (radius_ * radius_);
        return std::max(0.0, rise - least_rise) / (1 + far);
    }

    /// The mean over a tile, of what lies in about the same depth.
    void smooth_row(int row, std::vector<float>& smooth) const {
        const double reach = radius_ / 4;
        for (int column = 0; column < image_.width; ++column) {
            const std::size_t i = at(row, column);
            if (image_.depth[i] == nothing) continue;
            float sum = 0, count = 0;
            for (int y = std::max(0, row - tile / 2); y < std::min(image_.height, row + tile / 2); ++y)
                for (int x = std::max(0, column - tile / 2); x < std::min(image_.width, column + tile / 2); ++x)
                    if (const std::size_t j = at(y, x); std::abs(image_.depth[j] - image_.depth[i]) <= reach) {
                        sum += raw_[j];
                        count += 1;
                    }
            smooth[i] = count > 0 ? sum / count : raw_[i];
        }
    }
};

}  // namespace

std::vector<float> open_sky(const DepthImage& image, double radius) { return SkyFinder(image, radius).find(); }

}  // namespace rinceau

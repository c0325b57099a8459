// Felzenszwalb & Huttenlocher, section 2.1 (lower envelope of parabolas), along columns, then along rows.

#include "growth/distance_transform.h"

#include <cstddef>
#include <limits>

namespace rinceau {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One line at a time; its buffers are kept from line to line.
class LineTransform {
  public:
    explicit LineTransform(std::size_t longest) : apex_(longest), begin_(longest + 1), values_(longest) {}

    /// values[i * stride] <- min over j of (i - j)^2 + values[j * stride], for i < count.
    void apply(double* values, std::size_t count, std::size_t stride) {
        std::size_t parabolas = 0;
        for (std::size_t j = 0; j < count; ++j) {
            values_[j] = values[j * stride];
            if (values_[j] == infinity) continue;
            double from = -infinity;
            while (parabolas > 0 && (from = meeting(apex_[parabolas - 1], j)) <= begin_[parabolas - 1]) --parabolas;
            begin_[parabolas] = parabolas == 0 ? -infinity : from;
            apex_[parabolas++] = j;
        }
        if (parabolas == 0) return;
        begin_[parabolas] = infinity;
        for (std::size_t i = 0, k = 0; i < count; ++i) {
            while (begin_[k + 1] < static_cast<double>(i)) ++k;
            const double away = static_cast<double>(i) - static_cast<double>(apex_[k]);
            values[i * stride] = away * away + values_[apex_[k]];
        }
    }

  private:
    /// Where the parabolas of two apexes, left one first, meet.
    double meeting(std::size_t left, std::size_t right) const {
        const double l = static_cast<double>(left), r = static_cast<double>(right);
        return 0.5 * (l + r + (values_[right] - values_[left]) / (r - l));
    }

    std::vector<std::size_t> apex_;  ///< of the envelope's parabolas, from left to right
    std::vector<double> begin_;      ///< where each is the lowest
    std::vector<double> values_;     ///< the line's
};

}  // namespace

std::vector<double> squared_distances(std::span<const std::uint8_t> marked, int columns, int rows) {
    const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows);
    std::vector<double> distances(width * height, infinity);
    for (std::size_t i = 0; i < distances.size(); ++i)
        if (marked[i] != 0) distances[i] = 0;
    LineTransform line(width > height ? width : height);
    for (std::size_t column = 0; column < width; ++column) line.apply(distances.data() + column, height, width);
    for (std::size_t row = 0; row < height; ++row) line.apply(distances.data() + row * width, width, 1);
    return distances;
}

}  // namespace rinceau

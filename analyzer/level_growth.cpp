#include "analyzer/level_growth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

constexpr double smallest_growth = 1.05, largest_growth = 30;
constexpr double fits_roughly = 0.05;  // of the blocks' size
constexpr std::size_t most_growths = 400;

struct Pair {
    Similarity lower, upper;  ///< M(n, i) and M(n+1, i)
};

using Row = Eigen::Matrix<double, 1, 4>;  // of (Re h, Im h, Re t, Im t)

/// Rows of c * h, or of c * conj(h), real and imaginary part; shifted to columns 2 and 3 for t.
void add_product(Row& re, Row& im, Complex c, bool conjugate, int column) {
    const double sign = conjugate ? -1 : 1;
    re(column) += c.x;
    re(column + 1) += -sign * c.y;
    im(column) += c.y;
    im(column + 1) += sign * c.x;
}

/// H(z) = h z + t, or h conj(z) + t, by least squares from H M = M' H.
Similarity solved(const std::vector<Pair>& pairs, bool mirrored, Point centre, double extent) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    const auto add = [&](const Row& row, double value, double weight) {
        normal += weight * row.transpose() * row;
        right += weight * value * row.transpose();
    };
    const auto add_complex = [&](const Row& re, const Row& im, Complex value, double weight) {
        add(re, value.x, weight);
        add(im, value.y, weight);
    };
    for (const Pair& pair : pairs) {
        const Similarity &m = pair.lower, &n = pair.upper;
        // Places: h b + t = a' t + b' (a' conj(t) if the maps are mirrored, h conj(b) if H is).
        Row re = Row::Zero(), im = Row::Zero();
        add_product(re, im, flipped_if(mirrored, m.translation), false, 0);
        add_product(re, im, {1, 0}, false, 2);
        add_product(re, im, Complex{0, 0} - n.linear, n.mirrored, 2);
        add_complex(re, im, n.translation, 1);
        if (!m.mirrored) continue;
        // Angles of mirrored maps: h a = a' conj(h), or h conj(a) = a' conj(h).
        re = im = Row::Zero();
        add_product(re, im, flipped_if(mirrored, m.linear), false, 0);
        add_product(re, im, Complex{0, 0} - n.linear, true, 0);
        add_complex(re, im, {0, 0}, extent * extent);
    }
    // Where the maps say nothing about it, the centre stays.
    constexpr double faint = 1e-9;
    Row re = Row::Zero(), im = Row::Zero();
    add_product(re, im, flipped_if(mirrored, centre), false, 0);
    add_product(re, im, {1, 0}, false, 2);
    add_complex(re, im, centre, faint);
    const Eigen::Vector4d x = normal.fullPivLu().solve(right);
    return {{x(0), x(1)}, {x(2), x(3)}, mirrored};
}

/// How far two maps take the neighbourhood of a point to different places.
double difference(const Similarity& a, const Similarity& b, Point near, double extent) {
    if (a.mirrored != b.mirrored) return HUGE_VAL;
    return abs(apply(a, near) - apply(b, near)) + extent * abs(a.linear - b.linear);
}

class GrowthFinder {
  public:
    GrowthFinder(const LevelCopies& copies, Point centre, double extent)
        : copies_(copies), centre_(centre), extent_(extent), levels_(copies.size()), blocks_(copies[0].size()) {}

    std::vector<LevelGrowth> run() {
        std::vector<LevelGrowth> found;
        // Two blocks on two levels, or the only one on three, determine the map.
        const std::size_t pivots = std::min<std::size_t>(2, blocks_), depth = pivots == 2 ? 2 : 3;
        if (levels_ < depth) return found;
        choices_.assign(pivots * depth, 0);
        do {
            for (const bool mirrored : {false, true}) {
                if (auto growth = agreeing(solved(pairs_of_choices(pivots, depth), mirrored, centre_, extent_))) {
                    found.push_back(std::move(*growth));
                }
            }
        } while (found.size() < most_growths && next_choice(pivots, depth));
        return found;
    }

  private:
    const LevelCopies& copies_;
    Point centre_;
    double extent_;
    std::size_t levels_, blocks_;
    std::vector<std::size_t> choices_;

    /// The first block and the last: the farthest apart.
    const std::vector<BlockCopy>& options(std::size_t pivot, std::size_t depth) const {
        return copies_[levels_ - 1 - depth][pivot == 0 ? 0 : blocks_ - 1];
    }

    bool next_choice(std::size_t pivots, std::size_t depth) {
        for (std::size_t at = 0; at < pivots * depth; ++at) {
            if (++choices_[at] < options(at / depth, at % depth).size()) return true;
            choices_[at] = 0;
        }
        return false;
    }

    std::vector<Pair> pairs_of_choices(std::size_t pivots, std::size_t depth) const {
        std::vector<Pair> pairs;
        for (std::size_t pivot = 0; pivot < pivots; ++pivot) {
            for (std::size_t d = 0; d + 1 < depth; ++d) {
                pairs.push_back({options(pivot, d + 1)[choices_[pivot * depth + d + 1]].map,
                                 options(pivot, d)[choices_[pivot * depth + d]].map});
            }
        }
        return pairs;
    }

    std::optional<LevelGrowth> agreeing(const Similarity& rough) const {
        if (!usable(rough)) return std::nullopt;
        LevelGrowth growth{rough, {}};
        if (!choose(growth)) return std::nullopt;
        std::vector<Pair> pairs;
        for (std::size_t n = 0; n + 1 < levels_; ++n) {
            for (std::size_t i = 0; i < blocks_; ++i) {
                pairs.push_back({growth.chosen[n][i].map, growth.chosen[n + 1][i].map});
            }
        }
        growth.growth = solved(pairs, rough.mirrored, centre_, extent_);
        if (!usable(growth.growth)) return std::nullopt;
        return growth;
    }

    static bool usable(const Similarity& growth) {
        const double scale = scale_of(growth);
        return std::isfinite(scale) && scale >= smallest_growth && scale <= largest_growth;
    }

    /// On the highest level the copy that the lower ones agree with best, on those the nearest to what it says.
    bool choose(LevelGrowth& growth) const {
        growth.chosen.assign(levels_, std::vector<BlockCopy>(blocks_));
        for (std::size_t i = 0; i < blocks_; ++i) {
            double least = fits_roughly * static_cast<double>(levels_);
            bool any = false;
            for (const BlockCopy& top : copies_[levels_ - 1][i]) {
                std::vector<BlockCopy> column{top};
                double sum = 0;
                Similarity expected = top.map;
                for (std::size_t n = levels_ - 1; n-- > 0;) {
                    expected = inverse(growth.growth) * expected * growth.growth;
                    const double extent = extent_ * std::pow(scale_of(growth.growth), static_cast<double>(n));
                    const auto off = [&](const BlockCopy& copy) { return difference(copy.map, expected, centre_, extent); };
                    const BlockCopy& nearest = *std::ranges::min_element(copies_[n][i], {}, off);
                    sum += off(nearest) / extent;
                    column.push_back(nearest);
                }
                // Of equal ones the unmirrored, forward one.
                sum += top.map.mirrored || top.reversed ? 0.01 : 0;
                if (sum >= least) continue;
                least = sum;
                any = true;
                for (std::size_t n = 0; n < levels_; ++n) growth.chosen[levels_ - 1 - n][i] = column[n];
            }
            if (!any) return false;
        }
        return true;
    }
};

}  // namespace

std::vector<LevelGrowth> level_growths(const LevelCopies& copies, Point centre, double extent) {
    return GrowthFinder(copies, centre, extent).run();
}

}  // namespace rinceau

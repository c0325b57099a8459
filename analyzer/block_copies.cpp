#include "analyzer/block_copies.h"

#include <algorithm>
#include <cmath>

#include "analyzer/group_frame.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

class BlockMatcher {
  public:
    BlockMatcher(const SearchState& state, std::span<const int> block, std::span<const int> other, double slack)
        : state_(state), block_(block), other_(other), slack_(slack) {}

    std::vector<BlockCopy> run() const {
        std::vector<BlockCopy> copies;
        if (block_.size() == 1) {
            for (const Similarity& gauge : state_.part(state_.item(other_[0]).part).symmetry.elements) {
                copies.push_back({pose(other_[0]) * gauge * inverse(pose(block_[0])), false});
            }
            return copies;
        }
        const std::size_t far = farthest();
        for (const bool reversed : {false, true}) {
            for (const bool mirrored : {false, true}) {
                BlockCopy copy{map_of_two(far, reversed, mirrored), reversed};
                // A rough fit through two items first, then the best one through all.
                constexpr double rough = 3;
                if (!fits(copy, rough * slack_)) continue;
                copy.map = refined(copy);
                if (fits(copy, slack_)) copies.push_back(copy);
            }
        }
        return copies;
    }

  private:
    const SearchState& state_;
    std::span<const int> block_;
    std::span<const int> other_;
    double slack_;

    const Similarity& pose(int item) const { return state_.item(item).pose; }
    int image(std::size_t k, bool reversed) const { return other_[reversed ? other_.size() - 1 - k : k]; }

    std::size_t farthest() const {
        std::size_t best = 0;
        double most = 0;
        for (std::size_t k = 1; k < block_.size(); ++k) {
            const double distance = abs(pose(block_[k]).translation - pose(block_[0]).translation);
            if (distance > most) {
                most = distance;
                best = k;
            }
        }
        return best;
    }

    Similarity map_of_two(std::size_t far, bool reversed, bool mirrored) const {
        const Point a = pose(block_[0]).translation, b = pose(block_[far]).translation;
        const Point to_a = pose(image(0, reversed)).translation, to_b = pose(image(far, reversed)).translation;
        if (far == 0 || abs(to_b - to_a) == 0) return {};
        const Complex linear = (to_b - to_a) / flipped_if(mirrored, b - a);
        return {linear, to_a - linear * flipped_if(mirrored, a), mirrored};
    }

    bool fits(const BlockCopy& copy, double slack) const {
        const Point start = apply(copy.map, pose(block_[0]).translation);
        for (std::size_t k = 0; k < block_.size(); ++k) {
            const Similarity predicted = copy.map * pose(block_[k]);
            const Item& there = state_.item(image(k, copy.reversed));
            const PoseTolerance& tolerance = state_.tolerance;
            const double shift = tolerance.shift(scale_of(predicted), abs(predicted.translation - start));
            if (abs(predicted.translation - there.pose.translation) > slack * shift) return false;
            const Part& part = state_.part(there.part);
            if (matching_gauge(part, there.pose, predicted, slack * tolerance.turn(part.radius)) < 0) return false;
        }
        return true;
    }

    Similarity refined(const BlockCopy& copy) const {
        std::vector<Similarity> from, to;
        std::vector<double> radii;
        for (std::size_t k = 0; k < block_.size(); ++k) {
            const Item& there = state_.item(image(k, copy.reversed));
            from.push_back(pose(block_[k]));
            to.push_back(nearest_pose(state_.part(there.part), there.pose, copy.map * from.back()));
            radii.push_back(1);
        }
        return group_pose(from, to, radii);
    }
};

}  // namespace

std::vector<BlockCopy> block_copies(const SearchState& state, std::span<const int> block, std::span<const int> other,
                                    double slack) {
    return BlockMatcher(state, block, other, slack).run();
}

}  // namespace rinceau

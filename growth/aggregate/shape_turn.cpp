#include "growth/aggregate/shape_turn.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rinceau {
namespace {

constexpr int patience = 20;  // cancellations until another shape may go first

}  // namespace

ShapeTurn::ShapeTurn(std::vector<double> shares, double tolerance)
    : shares_(std::move(shares)), tolerance_(tolerance), counts_(shares_.size(), 0), passed_over_(shares_.size(), false) {
    const double sum = std::accumulate(shares_.begin(), shares_.end(), 0.0);
    for (double& share : shares_) share /= sum;
    choose();
}

double ShapeTurn::shortfall(std::size_t shape) const { return shares_[shape] * (total_ + 1) - counts_[shape]; }

/// Would all shares be kept if it were placed? A whole shape more or less is always allowed, or nothing could ever begin.
bool ShapeTurn::within_tolerance(std::size_t shape) const {
    if (tolerance_ >= 1) return true;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
        const double wanted = shares_[i] * (total_ + 1);
        const double count = counts_[i] + (i == shape ? 1 : 0);
        if (std::abs(count - wanted) > tolerance_ * wanted + 1) return false;
    }
    return true;
}

void ShapeTurn::choose() {
    const auto best_of = [this](bool all) {
        int best = -1;
        for (std::size_t i = 0; i < shares_.size(); ++i) {
            if (shares_[i] <= 0 || (!all && (passed_over_[i] || !within_tolerance(i)))) continue;
            if (best < 0 || shortfall(i) > shortfall(static_cast<std::size_t>(best))) best = static_cast<int>(i);
        }
        return best;
    };
    next_ = best_of(false);
    if (next_ >= 0) return;
    // Nobody else may go: begin anew with the one that is farthest behind.
    passed_over_.assign(passed_over_.size(), false);
    next_ = best_of(true);
}

void ShapeTurn::placed(int shape) {
    counts_[static_cast<std::size_t>(shape)] += 1;
    total_ += 1;
    cancellations_ = 0;
    passed_over_.assign(passed_over_.size(), false);
    choose();
}

void ShapeTurn::cancelled() {
    if (++cancellations_ < patience || tolerance_ <= 0) return;
    cancellations_ = 0;
    passed_over_[static_cast<std::size_t>(next_)] = true;
    choose();
}

}  // namespace rinceau

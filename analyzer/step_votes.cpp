#include "analyzer/step_votes.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

VoteCoordinates step_coordinates(const Similarity& step, const VoteCell& cell) {
    // Far places have larger cells because the source's angular error moves them.
    const double size = abs(step.linear);
    const double place = 1 / (cell.place * std::max(1.0, size) * (1 + cell.per_distance * abs(step.translation)));
    const Complex direction = step.linear / size;
    return {step.translation.x * place, step.translation.y * place, direction.x / cell.spin,
            (direction.y + 2 * std::log(size)) / cell.spin};
}

VoteCoordinates linear_coordinates(const StepVote& vote, const VoteCell& cell) {
    constexpr double finer = 0.25;  // a chain walked backwards exchanges the two changes: near values must stay apart
    const double advance = abs(vote.step.translation);
    return {advance / (cell.place * (1 + cell.per_distance * advance)), std::log(scale_of(vote.step)) / cell.spin,
            vote.turn_change / (finer * cell.spin), vote.spin_change / (finer * cell.spin)};
}

std::uint64_t StepVotes::key(const std::array<std::int64_t, 4>& at, bool mirrored) const {
    std::uint64_t hash = mirrored ? 0x9E3779B97F4A7C15ULL : 0x2545F4914F6CDD1DULL;
    for (const std::int64_t part : at) {
        hash ^= static_cast<std::uint64_t>(part) + 0x9E3779B97F4A7C15ULL + (hash << 6U) + (hash >> 2U);
    }
    return hash;
}

void StepVotes::add(const StepVote& vote, const VoteCoordinates& at) {
    for (const double c : at) {
        if (!std::isfinite(c) || std::abs(c) > 1e15) return;
    }
    ++count_;
    // Look in the 2^4 nearest cells for a cluster whose seed lies within one cell.
    std::array<std::int64_t, 4> base{};
    std::array<std::int64_t, 4> side{};
    for (std::size_t k = 0; k < 4; ++k) {
        const double low = std::floor(at[k]);
        base[k] = static_cast<std::int64_t>(low);
        side[k] = at[k] - low < 0.5 ? -1 : 1;
    }
    int best = -1;
    double best_distance = 1;
    for (unsigned corner = 0; corner < 16; ++corner) {
        std::array<std::int64_t, 4> cell = base;
        for (std::size_t k = 0; k < 4; ++k) {
            if ((corner >> k) & 1U) cell[k] += side[k];
        }
        const auto found = bins_at_.find(key(cell, vote.step.mirrored));
        if (found == bins_at_.end()) continue;
        for (const int b : found->second) {
            const Bin& bin = bins_[static_cast<std::size_t>(b)];
            if (bin.mirrored != vote.step.mirrored) continue;
            double distance = 0;
            for (std::size_t k = 0; k < 4; ++k) distance = std::max(distance, std::abs(bin.seed[k] - at[k]));
            if (distance < best_distance || (distance == best_distance && b < best)) {
                best_distance = distance;
                best = b;
            }
        }
    }
    if (best < 0) {
        best = static_cast<int>(bins_.size());
        bins_.push_back({at, vote.step.mirrored, {}});
        bins_at_[key(base, vote.step.mirrored)].push_back(best);
    }
    bins_[static_cast<std::size_t>(best)].votes.push_back(vote);
}

static StepCluster cluster_of(const std::vector<StepVote>& votes) {
    StepCluster cluster;
    cluster.votes = votes;
    cluster.step = {{0, 0}, {0, 0}, votes.front().step.mirrored};
    double log_size = 0;
    const double share = 1.0 / static_cast<double>(votes.size());
    for (const StepVote& vote : votes) {
        const double size = abs(vote.step.linear);
        cluster.step.linear += vote.step.linear / size;
        cluster.step.translation += share * vote.step.translation;
        cluster.turn_change += share * vote.turn_change;
        cluster.spin_change += share * vote.spin_change;
        log_size += std::log(size);
    }
    const double direction = abs(cluster.step.linear);
    if (direction > 0) cluster.step.linear = cluster.step.linear * (std::exp(log_size * share) / direction);
    return cluster;
}

std::vector<StepCluster> StepVotes::clusters(std::size_t least, std::size_t most) const {
    std::vector<std::size_t> order;
    for (std::size_t b = 0; b < bins_.size(); ++b) {
        if (bins_[b].votes.size() >= least) order.push_back(b);
    }
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return bins_[a].votes.size() > bins_[b].votes.size(); });
    if (order.size() > most) order.resize(most);
    std::vector<StepCluster> clusters;
    clusters.reserve(order.size());
    for (const std::size_t b : order) clusters.push_back(cluster_of(bins_[b].votes));
    return clusters;
}

}  // namespace rinceau

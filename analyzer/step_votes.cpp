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

namespace {

using Cell = std::array<std::int64_t, 4>;

/// Different cells may share a key: who looks there compares coordinates.
std::uint64_t key_of(const Cell& cell, bool mirrored) {
    std::uint64_t key = mirrored ? 0x9E3779B97F4A7C15ULL : 0x2545F4914F6CDD1DULL;
    for (const std::int64_t part : cell) {
        key ^= static_cast<std::uint64_t>(part) + 0x9E3779B97F4A7C15ULL + (key << 6U) + (key >> 2U);
    }
    return key;
}

Cell cell_of(const VoteCoordinates& at) {
    Cell cell{};
    for (std::size_t k = 0; k < at.size(); ++k) cell[k] = static_cast<std::int64_t>(std::floor(at[k]));
    return cell;
}

}  // namespace

int StepVotes::nearest_bin(const VoteCoordinates& at, bool mirrored) const {
    // A seed within one cell lies in one of the 2^4 nearest cells.
    const Cell base = cell_of(at);
    Cell side{};
    for (std::size_t k = 0; k < at.size(); ++k) side[k] = at[k] - static_cast<double>(base[k]) < 0.5 ? -1 : 1;
    int best = IndexMap::none;
    double best_distance = 1;
    for (unsigned corner = 0; corner < 16; ++corner) {
        Cell cell = base;
        for (std::size_t k = 0; k < cell.size(); ++k) {
            if ((corner >> k) & 1U) cell[k] += side[k];
        }
        int b = last_in_cell_.find(key_of(cell, mirrored));
        for (; b != IndexMap::none; b = bins_[static_cast<std::size_t>(b)].next_in_cell) {
            const Bin& bin = bins_[static_cast<std::size_t>(b)];
            if (bin.mirrored != mirrored) continue;
            double distance = 0;
            for (std::size_t k = 0; k < at.size(); ++k) distance = std::max(distance, std::abs(bin.seed[k] - at[k]));
            if (distance < best_distance || (distance == best_distance && b < best)) {
                best_distance = distance;
                best = b;
            }
        }
    }
    return best;
}

int StepVotes::new_bin(const VoteCoordinates& at, bool mirrored) {
    const int bin = static_cast<int>(bins_.size());
    const std::uint64_t key = key_of(cell_of(at), mirrored);
    bins_.push_back({at, mirrored, last_in_cell_.find(key)});
    last_in_cell_.set(key, bin);
    return bin;
}

void StepVotes::add(const StepVote& vote, const VoteCoordinates& at) {
    for (const double c : at) {
        if (!std::isfinite(c) || std::abs(c) > 1e15) return;
    }
    int found = nearest_bin(at, vote.step.mirrored);
    if (found == IndexMap::none) found = new_bin(at, vote.step.mirrored);
    Bin& bin = bins_[static_cast<std::size_t>(found)];
    const double size = abs(vote.step.linear);
    ++bin.votes;
    bin.direction += vote.step.linear / size;
    bin.translation += vote.step.translation;
    bin.log_size += std::log(size);
    bin.turn_change += vote.turn_change;
    bin.spin_change += vote.spin_change;
    votes_.push_back({found, {vote.source, vote.target}});
}

StepCluster StepVotes::cluster_of(const Bin& bin) const {
    const double share = 1.0 / bin.votes;
    const double length = abs(bin.direction);
    const double size = length > 0 ? std::exp(bin.log_size * share) / length : 1;
    StepCluster cluster;
    cluster.step = {bin.direction * size, share * bin.translation, bin.mirrored};
    cluster.turn_change = share * bin.turn_change;
    cluster.spin_change = share * bin.spin_change;
    cluster.votes.reserve(static_cast<std::size_t>(bin.votes));
    return cluster;
}

std::vector<StepCluster> StepVotes::clusters(std::size_t least, std::size_t most) const {
    const auto votes_of = [&](std::size_t b) { return static_cast<std::size_t>(bins_[b].votes); };
    std::vector<std::size_t> order;
    for (std::size_t b = 0; b < bins_.size(); ++b) {
        if (votes_of(b) >= least) order.push_back(b);
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return votes_of(a) > votes_of(b); });
    if (order.size() > most) order.resize(most);
    std::vector<StepCluster> clusters;
    clusters.reserve(order.size());
    std::vector<int> cluster_of_bin(bins_.size(), -1);
    for (const std::size_t b : order) {
        cluster_of_bin[b] = static_cast<int>(clusters.size());
        clusters.push_back(cluster_of(bins_[b]));
    }
    for (const Cast& vote : votes_) {
        const int cluster = cluster_of_bin[static_cast<std::size_t>(vote.bin)];
        if (cluster >= 0) clusters[static_cast<std::size_t>(cluster)].votes.push_back(vote.voters);
    }
    return clusters;
}

}  // namespace rinceau

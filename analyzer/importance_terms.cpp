#include "analyzer/importance_terms.h"

#include <algorithm>

namespace rinceau {

namespace {

struct Circle {
    Point middle;
    double radius = 0;
};

/// Of the elements below an item, evenly chosen.
std::vector<Circle> circles_of(const SearchState& state, int item) {
    constexpr std::size_t most = 16;
    std::vector<int> leaves, open{item};
    while (!open.empty()) {
        const int at = open.back();
        open.pop_back();
        if (state.item(at).members.empty()) leaves.push_back(at);
        for (const int member : state.item(at).members) {
            if (member >= 0) open.push_back(member);
        }
    }
    std::vector<Circle> circles;
    const std::size_t stride = (leaves.size() + most - 1) / most;
    for (std::size_t k = 0; k < leaves.size(); k += std::max<std::size_t>(1, stride)) {
        const Item& leaf = state.item(leaves[k]);
        circles.push_back({leaf.pose.translation, scale_of(leaf.pose) * state.part(leaf.part).radius});
    }
    return circles;
}

double distance_between(const SearchState& state, int first, int second) {
    double least = state.diagonal;
    const std::vector<Circle> others = circles_of(state, second);
    for (const Circle& a : circles_of(state, first)) {
        for (const Circle& b : others) least = std::min(least, abs(a.middle - b.middle) - a.radius - b.radius);
    }
    return std::max(0.0, least) / state.diagonal;
}

double similarity_of(const SearchState& state, const Chain& chain, std::size_t link, const Similarity& step) {
    const Item& a = state.item(chain.items[link]);
    const Item& b = state.item(chain.items[link + 1]);
    if (a.part != b.part) return 0;
    const Point predicted = apply(chain.frames[link] * step, {});
    const double miss = abs(predicted - chain.frames[link + 1].translation) / scale_of(b.pose);
    return 1 / (1 + miss / state.tolerance.size);
}

}  // namespace

ImportanceTerms importance_terms(const SearchState& state, const std::vector<Chain>& chains, const Similarity& step) {
    ImportanceTerms terms;
    double pairs = 0;
    for (const Chain& chain : chains) {
        terms.elements += static_cast<double>(chain.items.size());
        for (std::size_t k = 0; k + 1 < chain.items.size(); ++k) {
            pairs += 1;
            terms.nearness += 1 - distance_between(state, chain.items[k], chain.items[k + 1]);
            terms.similarity += similarity_of(state, chain, k, step);
        }
    }
    if (pairs == 0) return {};
    terms.nearness /= pairs;
    terms.similarity /= pairs;
    terms.length = terms.elements / static_cast<double>(chains.size());
    return terms;
}

}  // namespace rinceau

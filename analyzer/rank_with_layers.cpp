#include "analyzer/rank_with_layers.h"

#include <algorithm>

#include "analyzer/paint_order.h"
#include "geometry/parallel.h"

namespace rinceau {

namespace {

constexpr const char* stage = "rules";
constexpr double little = 0.03;  // of the cost of the rules
constexpr std::size_t most_tried = 4;

double layer_bits(const Description& description, const Overlaps& overlaps) {
    const Grammar layered = with_paint_order(description.exact, description.written.element_of_leaf, overlaps);
    return bits_of(description, layered).grammar - description.bits.grammar;
}

}  // namespace

std::vector<Description> ranked_with_layers(std::vector<Description> descriptions, const Overlaps& overlaps, int threads,
                                            const Progress& progress) {
    if (descriptions.size() < 2) return descriptions;
    const double first = descriptions.front().cost;
    const double layers = layer_bits(descriptions.front(), overlaps);
    if (layers <= little * first) return descriptions;
    std::vector<std::size_t> tried;
    for (std::size_t d = 1; d < descriptions.size() && tried.size() < most_tried; ++d) {
        if (descriptions[d].cost < first + layers) tried.push_back(d);
    }
    std::vector<double> costs(tried.size());
    for_each_index(tried.size(), threads, stage, progress, [&](std::size_t k, const Progress&) {
        const Description& description = descriptions[tried[k]];
        costs[k] = std::max(first, description.cost) + layer_bits(description, overlaps);
    });
    const auto cheapest = std::ranges::min_element(costs);
    if (cheapest == costs.end() || *cheapest >= first + layers) return descriptions;
    const auto found =
        descriptions.begin() + static_cast<std::ptrdiff_t>(tried[static_cast<std::size_t>(cheapest - costs.begin())]);
    std::rotate(descriptions.begin(), found, found + 1);
    return descriptions;
}

}  // namespace rinceau

#include "growth/measure/measure_arrangement.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/kd_tree.h"
#include "growth/measure/empty_circle.h"
#include "growth/measure/outline_overlaps.h"
#include "growth/measure/pair_correlation.h"
#include "growth/measure/point_pattern.h"
#include "growth/measure/ring_fit.h"

namespace rinceau {
namespace {

// In mean edges l of the exemplar.
constexpr double inside_depth = 1.5;
constexpr double repeat_reach = 2.6;
/// How far within what is covered an empty circle counts: nearer to the rim it may be a bay.
constexpr double circle_depth = 1;

constexpr double near_enough = 0.97;      ///< of the least distance
constexpr double visible_overlap = 1e-3;  ///< of the smaller outline's area
constexpr double large_share = 0.15;

struct ArrangementPatterns {
    PointPattern exemplar;
    PointPattern around;  ///< the exemplar, a tiled one with its copies on all sides
    PointPattern grown;
};

const ExemplarElement& reference_of(const Exemplar& exemplar, const ArrangedElement& element) {
    return exemplar.elements[static_cast<std::size_t>(element.reference)];
}

PointPattern exemplar_pattern(const Exemplar& exemplar, std::size_t count) {
    std::vector<Point> positions;
    std::vector<int> symbols;
    for (std::size_t i = 0; i < count; ++i) {
        positions.push_back(exemplar.elements[i].position);
        symbols.push_back(exemplar.elements[i].symbol);
    }
    if (exemplar.tile && count == exemplar.originals)
        return tiled_pattern(std::move(positions), std::move(symbols), *exemplar.tile);
    return pattern_of(std::move(positions), std::move(symbols), exemplar.mean_edge);
}

PointPattern grown_pattern(const Exemplar& exemplar, const std::vector<ArrangedElement>& elements,
                           const Boundary* boundary) {
    std::vector<Point> positions;
    std::vector<int> symbols;
    for (const ArrangedElement& element : elements) {
        positions.push_back(element.position);
        symbols.push_back(reference_of(exemplar, element).symbol);
    }
    PointPattern pattern = pattern_of(std::move(positions), std::move(symbols), exemplar.mean_edge);
    if (boundary == nullptr || !boundary->region()) return pattern;
    // Holes of the region are no holes of the arrangement.
    const Mask region = with_region({pattern.window.low, pattern.window.cell, pattern.window.columns, pattern.window.rows,
                                     std::vector<std::uint8_t>(pattern.window.inside.size())},
                                    *boundary->region());
    for (std::size_t cell = 0; cell < region.inside.size(); ++cell)
        if (region.inside[cell] == 0) pattern.window.inside[cell] = 0;
    return pattern;
}

/// Which points lie deeper than `depth` within the window.
std::vector<bool> deeper_than(const PointPattern& pattern, double depth) {
    const std::vector<double> of_cell = depths(pattern.window);
    std::vector<bool> deep;
    deep.reserve(pattern.positions.size());
    for (const Point p : pattern.positions) {
        const std::ptrdiff_t cell = cell_at(pattern.window, p);
        deep.push_back(cell >= 0 && of_cell[static_cast<std::size_t>(cell)] > depth);
    }
    return deep;
}

void measure_outlines(ArrangementMeasures& measures, const Exemplar& exemplar, const std::vector<ArrangedElement>& elements,
                      const Boundary* boundary) {
    std::vector<PlacedOutline> outlines;
    for (const ArrangedElement& element : elements)
        outlines.push_back({&reference_of(exemplar, element).outline, translate(element.position) * rotate(element.angle)});
    measures.overlaps = overlapping_pairs(outlines, visible_overlap).size();
    if (boundary == nullptr || boundary->is_empty()) return;
    measures.over_boundary =
        static_cast<std::size_t>(std::count_if(outlines.begin(), outlines.end(), [&](const PlacedOutline& placed) {
            return boundary->cuts(*placed.outline, placed.pose);
        }));
}

/// Distances between centres against the exemplar's least ones.
void measure_distances(ArrangementMeasures& measures, const Exemplar& exemplar, const PointPattern& grown,
                       const KdTree& tree) {
    double reach = 0;
    for (const auto& row : exemplar.min_distance)
        for (const double least : row)
            if (std::isfinite(least)) reach = std::max(reach, least);
    measures.least_distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < grown.positions.size(); ++i)
        for (const Neighbor& near : tree.within(grown.positions[i], 1.5 * reach)) {
            if (near.index <= i) continue;
            const auto a = static_cast<std::size_t>(grown.symbols[i]),
                       b = static_cast<std::size_t>(grown.symbols[near.index]);
            const double ratio = near.distance / exemplar.min_distance[a][b];
            if (ratio < near_enough) ++measures.too_near;
            if (ratio > 0 || near.distance == 0) measures.least_distance = std::min(measures.least_distance, ratio);
        }
    if (!std::isfinite(measures.least_distance)) measures.least_distance = 1;
}

void measure_shares(ArrangementMeasures& measures, const Exemplar& exemplar, const PointPattern& grown) {
    measures.shares.assign(exemplar.symbols.size(), 0);
    for (const int symbol : grown.symbols)
        measures.shares[static_cast<std::size_t>(symbol)] += 1 / static_cast<double>(grown.symbols.size());
    std::vector<bool> can_grow(exemplar.symbols.size());
    for (const ExemplarElement& element : exemplar.elements)
        if (element.usable) can_grow[static_cast<std::size_t>(element.symbol)] = true;
    double all = 0;
    for (std::size_t symbol = 0; symbol < can_grow.size(); ++symbol)
        all += can_grow[symbol] ? exemplar.symbols[symbol].share : 0;
    for (std::size_t symbol = 0; symbol < can_grow.size(); ++symbol) {
        if (!can_grow[symbol]) {
            ++measures.lost_symbols;
            continue;
        }
        const double wanted = exemplar.symbols[symbol].share / all;
        double& error = wanted < large_share ? measures.small_share_error : measures.share_error;
        error = std::max(error, std::abs(measures.shares[symbol] / wanted - 1));
    }
}

/// Copies of the same element near each other, and neighbours as they stand in the exemplar.
void measure_repeats(ArrangementMeasures& measures, const Exemplar& exemplar, const std::vector<ArrangedElement>& elements,
                     std::span<const std::pair<int, int>> edges, const KdTree& tree) {
    std::set<int> usable;
    for (const ExemplarElement& element : exemplar.elements)
        if (element.usable) usable.insert(element.sub_id);
    if (!usable.empty()) measures.chance = 1 / static_cast<double>(usable.size());
    double pairs = 0, same = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
        for (const Neighbor& near : tree.within(elements[i].position, repeat_reach * exemplar.mean_edge)) {
            if (near.index <= i) continue;
            pairs += 1;
            same +=
                reference_of(exemplar, elements[i]).sub_id == reference_of(exemplar, elements[near.index]).sub_id ? 1 : 0;
        }
    measures.repeats = pairs > 0 ? same / pairs : measures.chance;

    std::set<std::pair<int, int>> neighbors;
    for (const auto& [a, b] : exemplar.edges) {
        const int first = exemplar.elements[static_cast<std::size_t>(a)].sub_id,
                  second = exemplar.elements[static_cast<std::size_t>(b)].sub_id;
        neighbors.insert({std::min(first, second), std::max(first, second)});
    }
    double verbatim = 0;
    for (const auto& [a, b] : edges) {
        const int first = reference_of(exemplar, elements[static_cast<std::size_t>(a)]).sub_id;
        const int second = reference_of(exemplar, elements[static_cast<std::size_t>(b)]).sub_id;
        verbatim += static_cast<double>(neighbors.count({std::min(first, second), std::max(first, second)}));
    }
    if (!edges.empty()) measures.verbatim = verbatim / static_cast<double>(edges.size());
}

void measure_rings(ArrangementMeasures& measures, const Exemplar& exemplar, const std::vector<ArrangedElement>& elements,
                   std::span<const std::pair<int, int>> edges, const std::vector<bool>& inside) {
    if (measures.inside == 0) return;
    const RingFit fit = ring_fit(exemplar, elements, edges, inside);
    measures.degree_distance = degree_distance(fit.degrees, degree_histogram(exemplar));
    measures.right_degrees = fit.right_degrees;
    measures.spacing_error = fit.spacing_error;
    measures.largest_spacing_error = fit.largest_spacing_error;
    measures.ring_error = fit.ring_error;
    measures.defects = fit.defects;
}

}  // namespace

ArrangementMeasures measure_arrangement(const Exemplar& exemplar, const std::vector<ArrangedElement>& elements,
                                        std::span<const std::pair<int, int>> edges, const ArrangeSurroundings& around) {
    ArrangementMeasures measures;
    measures.elements = elements.size();
    if (elements.empty()) return measures;
    const ArrangementPatterns patterns{exemplar_pattern(exemplar, exemplar.originals),
                                       exemplar_pattern(exemplar, exemplar.elements.size()),
                                       grown_pattern(exemplar, elements, around.boundary.get())};
    const std::vector<bool> inside = deeper_than(patterns.grown, inside_depth * exemplar.mean_edge);
    measures.inside = static_cast<std::size_t>(std::count(inside.begin(), inside.end(), true));

    measure_rings(measures, exemplar, elements, edges, inside);
    measure_outlines(measures, exemplar, elements, around.boundary.get());
    const KdTree tree(patterns.grown.positions);
    measure_distances(measures, exemplar, patterns.grown, tree);
    measure_shares(measures, exemplar, patterns.grown);
    measure_repeats(measures, exemplar, elements, edges, tree);
    measures.density = density(patterns.grown) / density(patterns.exemplar);

    const int symbols = static_cast<int>(exemplar.symbols.size());
    measures.pair_distance = pair_distance(patterns.grown, patterns.exemplar, symbols, exemplar.mean_edge);
    measures.pair_spread = pair_spread(patterns.exemplar, symbols, exemplar.mean_edge);
    const double exemplar_empty = largest_empty_circle(patterns.around, 0).radius;
    const double grown_empty = largest_empty_circle(patterns.grown, circle_depth * exemplar.mean_edge).radius;
    if (exemplar_empty > 0 && grown_empty > 0) measures.empty_circle = grown_empty / exemplar_empty;
    return measures;
}

ArrangementMeasures measure_arrangement(const Exemplar& exemplar, const ElementArrangement& arrangement,
                                        const ArrangeSurroundings& around) {
    return measure_arrangement(exemplar, arranged_elements(arrangement), arranged_edges(arrangement), around);
}

}  // namespace rinceau

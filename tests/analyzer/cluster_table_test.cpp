#include "analyzer/cluster_table.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr int count = 12;

/// Hooks in a row, a leaf at each third of them.
Scene row_with_leaves() {
    Scene scene{{{-10, -20}, {130, 20}}, true, {}};
    for (int k = 0; k < count; ++k)
        scene.elements.push_back(placed(element(hook(), filled({})), translate({10.0 * k, 0}) * scale_by(3)));
    for (int k = 0; k < count; k += 3)
        scene.elements.push_back(placed(element(leaf(), filled({})), translate({10.0 * k, 8}) * scale_by(2)));
    return scene;
}

ClusterTable table_of(const Scene& scene, const ClusterTableOptions& options = {}) {
    const Instancing instancing = group_similar_elements(scene);
    return cluster_table(instancing, std::vector<std::string>(instancing.looks.size(), "look"), drawing_diagonal(scene),
                         options);
}

}  // namespace

TEST_CASE("the step of a row is a cluster of all its elements, the most important one") {
    const ClusterTable table = table_of(row_with_leaves());
    CHECK(table.complete);
    const RankedClusters ranked = ranked_clusters(table, {});
    REQUIRE(!table.rows.empty());
    const ClusterRow& first = table.rows[ranked.order.front()];
    CHECK(first.elements.size() == count);
    CHECK(first.terms.elements == count);
    CHECK(first.terms.length == count);
    CHECK(first.terms.similarity == Approx(1));
    CHECK(first.terms.nearness > 0.9);
    CHECK(ranked.importance[ranked.order.front()] == Approx(3 + first.terms.nearness));
}

TEST_CASE("a step over two elements makes two chains of half the length") {
    const ClusterTable table = table_of(row_with_leaves());
    const auto twice = std::ranges::find_if(table.rows, [&](const ClusterRow& row) {
        const auto& space = table.spaces[static_cast<std::size_t>(row.space)];
        return space.space.from == space.space.to &&
               space.clusters.clusters[static_cast<std::size_t>(row.cluster)].count == count - 2;
    });
    REQUIRE(twice != table.rows.end());
    CHECK(twice->terms.elements == count);
    CHECK(twice->terms.length == count / 2);
}

TEST_CASE("pairs of two looks are not similar, and no chain") {
    const ClusterTable table = table_of(row_with_leaves());
    const auto mixed = std::ranges::find_if(table.rows, [&](const ClusterRow& row) {
        const auto& space = table.spaces[static_cast<std::size_t>(row.space)].space;
        return space.from != space.to;
    });
    REQUIRE(mixed != table.rows.end());
    CHECK(mixed->terms.similarity == 0);
    CHECK(mixed->terms.length == 2);
}

TEST_CASE("weights decide on the order of the rows") {
    const ClusterTable table = table_of(row_with_leaves());
    const RankedClusters by_count = ranked_clusters(table, {4, 0, 0, 0});
    CHECK(std::ranges::is_sorted(by_count.order, std::greater{},
                                 [&](std::size_t row) { return table.rows[row].terms.elements; }));
    const RankedClusters by_nearness = ranked_clusters(table, {0, 4, 0, 0});
    CHECK(std::ranges::is_sorted(by_nearness.order, std::greater{},
                                 [&](std::size_t row) { return table.rows[row].terms.nearness; }));
}

TEST_CASE("a limit leaves the rarer looks out and says so") {
    const ClusterTable table = table_of(row_with_leaves(), {.most_points = 140});
    CHECK_FALSE(table.complete);
    REQUIRE(table.spaces.size() == 1);
    CHECK(table.spaces.front().space.points.size() == count * (count - 1));
}

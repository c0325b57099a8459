#pragma once
// Clusters of all transformation spaces with what the paper's importance function says of them (Stava et al. 2010, sections
// 4.3 and 5.4). For display: the search for rules works on poses.

#include <string>
#include <vector>

#include "analyzer/importance.h"
#include "analyzer/instancing.h"
#include "analyzer/spaces_report.h"
#include "geometry/progress.h"

namespace rinceau {

struct ClusterRow {
    int space = 0;    ///< index into ClusterTable::spaces
    int cluster = 0;  ///< of that space
    ImportanceTerms terms;
    std::vector<int> elements;  ///< that are in its pairs, rising
};

struct ClusterTable {
    std::vector<std::string> names;  ///< of the looks
    std::vector<ClusteredSpace> spaces;
    std::vector<ClusterRow> rows;  ///< clusters of two pairs or more; at most ClusterTableOptions::most_rows, the largest
    ImportanceTerms largest;       ///< of all rows
    bool complete = true;          ///< false: spaces or rows were left out for their number
};

struct ClusterTableOptions {
    std::size_t most_points = 60'000;  ///< in all spaces together: spaces of the most frequent looks come first
    std::size_t most_rows = 1'000;
};

/// `diagonal` of the drawing. Elements and chains are counted as in Stava et al. 2010: n are the elements of a cluster that
/// stand in sequences, which lead from pair to pair; those of two looks have two elements each and are not similar.
ClusterTable cluster_table(const Instancing& instancing, const std::vector<std::string>& names, double diagonal,
                           const ClusterTableOptions& options = {}, const Progress& progress = {});

/// Indices of rows by falling importance under these weights, equal ones in their order; and that importance of each row.
struct RankedClusters {
    std::vector<std::size_t> order;
    std::vector<double> importance;  ///< by row
};
RankedClusters ranked_clusters(const ClusterTable& table, const ImportanceWeights& weights);

}  // namespace rinceau

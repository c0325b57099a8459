#pragma once
// What the analysis of a drawing begins with, whatever is preferred afterwards: kept, it makes another analysis with other
// weights quick (docs/analysis.md, 9).

#include <memory>
#include <vector>

#include "analyzer/grouping.h"
#include "analyzer/importance.h"
#include "analyzer/instancing.h"
#include "analyzer/overlaps.h"
#include "analyzer/search_state.h"
#include "geometry/progress.h"
#include "scene/element.h"

namespace rinceau {

struct AnalyzeOptions {
    SimilarityOptions similarity;
    /// Largest deviation of a repetition, in element sizes. 0 = several are tried and the shortest grammar is kept.
    double tolerance = 0;
    ImportanceWeights weights;
    Objective objective = Objective::bits;
    /// Draw the regular layout behind the drawing: what elements miss their places by is dropped.
    bool symmetrize = false;
    /// Draw a relative of the drawing: the rules get noise of the size that elements miss their places by. Not beside
    /// symmetrize.
    bool stochastic = false;
    std::vector<GroupingWish> grouping;  ///< elements that shall be, or shall not be, copies of each other
    std::vector<int> alone;  ///< elements, by index, that are nobody's copies and drawn exactly as they are; no repeats
    int threads = 0;                     ///< 0 = one per processor; the result is the same for any number
};

/// The drawing with these looks.
struct PreparedReading {
    Instancing instancing;            ///< which elements are copies of which
    std::vector<SearchState> starts;  ///< where the search begins, at each tolerance that is tried
};

struct PreparedDrawing {
    const Scene* scene = nullptr;        ///< `meant`, or the drawing, which is not owned and must live as long
    std::shared_ptr<const Scene> meant;  ///< the drawing with merged elements drawn alike; null if no wish changes it
    int redrawn = 0;                     ///< elements that `meant` draws as another one
    double diagonal = 1;
    Overlaps overlaps;                      ///< whose paint order can be seen
    std::vector<PreparedReading> readings;  ///< equal shapes in other styles are other looks; or one look, if there are any
    double seconds = 0;                     ///< that all this took
};

/// Of the options, weights and objective play no part. Throws LimitError for drawings over 5,000,000 elements.
PreparedDrawing prepare_drawing(const Scene& scene, const AnalyzeOptions& options = {}, const Progress& progress = {});

}  // namespace rinceau

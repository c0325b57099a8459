#pragma once
// Exact mode: elements that the rules miss by more than can be tolerated get an exception with what is left over
// (docs/analysis.md, 7).

#include <vector>

#include "analyzer/instancing.h"
#include "analyzer/to_grammar.h"

namespace rinceau {

struct Residuals {
    Grammar grammar;                ///< with the exceptions
    std::vector<double> deviation;  ///< by leaf, before the exceptions: outline deviation, scene length
    int exceptions = 0;
};

/// Elements that deviate by more than `tolerance` (scene length) are moved to where the drawing has them.
Residuals with_residuals(const WrittenGrammar& written, const Instancing& instancing, double tolerance);

}  // namespace rinceau

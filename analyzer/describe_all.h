#pragma once
// Several ways to read a drawing, and which of them a person would choose (docs/analysis.md, 9).

#include <span>
#include <vector>

#include "analyzer/description.h"

namespace rinceau {

/// Descriptions best first. starts[d]: for drawings[d] a starting state for each tolerance, as many for all. From below at all
/// tolerances, and with all openings at the first tolerance and at the one that was best from below; a single description if
/// one leaves nothing to wish for. The same for any number of threads.
std::vector<Description> describe_all(const std::vector<Drawing>& drawings,
                                      const std::vector<std::span<const SearchState>>& starts, const SearchOptions& search,
                                      int threads, const Progress& progress);

/// The same with an irregular drawing read once more as the regular one that it was meant to be, if exact rules leave much.
std::vector<Description> describe_irregular(const std::vector<Drawing>& drawings, std::vector<Description> exact,
                                            const SearchOptions& search, int threads, const Progress& progress);

}  // namespace rinceau

#pragma once
// The map that carries one level of a self-similar drawing to the next (docs/analysis.md, 4.8).

#include <optional>
#include <vector>

#include "analyzer/block_copies.h"

namespace rinceau {

/// By level n, from 1, and by block i, from 1: the maps of block 0 of that level onto block i.
using LevelCopies = std::vector<std::vector<std::vector<BlockCopy>>>;

struct LevelGrowth {
    Similarity growth;                           ///< H: M(n+1, i) = H M(n, i) H^-1
    std::vector<std::vector<BlockCopy>> chosen;  ///< [level][block]: the copies that agree with it
};

/// All ways to choose from the copies such that one growth fits, roughly; `centre` stays where it is as far as the maps leave
/// that open, and `extent` is the size of a block of the first level.
std::vector<LevelGrowth> level_growths(const LevelCopies& copies, Point centre, double extent);

}  // namespace rinceau

#pragma once
// What a module with numbers for arguments does, found by deriving it. Internal to the folder.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "geometry/similarity.h"
#include "lsystem/derive.h"
#include "lsystem/grammar.h"

namespace rinceau {

class MeasuredModules {
  public:
    /// Where a module leaves the turtle.
    struct Move {
        Similarity pose;
        int layer = 0;
        std::optional<int> style;  ///< nothing = as it was
    };

    /// With options.depth = -1 modules are derived to their end. Members throw as derive().
    MeasuredModules(const Grammar& grammar, const DeriveOptions& options);

    /// Things that the module draws in all.
    std::uint64_t placements_of(const ModuleTemplate& module) { return measured(module).placements; }
    /// Nothing if that is no similarity and layer on top of where it stood.
    std::optional<Move> move_of(const ModuleTemplate& module) { return measured(module).move; }

  private:
    struct Measures {
        std::uint64_t placements = 0;
        std::optional<Move> move;
    };

    DeriveOptions options_;
    Grammar scratch_;  ///< without outlines, with a terminal that is no symbol of the grammar
    std::string probe_;
    std::map<std::string, Measures> known_;

    const Measures& measured(const ModuleTemplate& module);
};

}  // namespace rinceau

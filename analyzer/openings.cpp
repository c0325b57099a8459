#include "analyzer/openings.h"

#include <utility>

#include "analyzer/branch_opening.h"
#include "analyzer/open_with_progressions.h"
#include "analyzer/open_with_spirals.h"
#include "analyzer/symmetry_rules.h"

namespace rinceau {

namespace {

/// A lattice has turns and mirrors too: rows and columns are what a person sees unless the symmetry says clearly less.
constexpr ConvincingCost clearly_less{0.9, 1};
/// In equally many rules the symmetry of the whole is what a person sees.
constexpr ConvincingCost about_the_same{1.15, 1.1};

using Finder = std::optional<SearchState> (*)(const SearchState&);

/// An opening that needs no options.
Opening opening(std::string name, Finder find) {
    return {std::move(name), {}, {}, [find](const SearchState& start, const SearchOptions&, const Progress&) { return find(start); }};
}

}  // namespace

Opening opening_from_below() {
    return {"from below", {}, {}, [](const SearchState& start, const SearchOptions&, const Progress&) { return start; }};
}

std::vector<Opening> openings_of(const SearchState& start) {
    std::vector<Opening> all;
    for (SceneSymmetry& symmetry : find_scene_symmetries(start)) {
        all.push_back({"symmetry of the whole", clearly_less, about_the_same,
                       [found = std::move(symmetry)](const SearchState& state, const SearchOptions& options,
                                                     const Progress& progress) -> std::optional<SearchState> {
                           return open_with_symmetry(state, found, options, progress);
                       }});
    }
    all.push_back(opening("branching", [](const SearchState& state) { return open_with_branching(state); }));
    all.push_back(opening("self-similarity", [](const SearchState& state) { return open_with_self_similarity(state); }));
    all.push_back(opening("spirals", [](const SearchState& state) { return open_with_spirals(state); }));
    all.push_back(opening("progressions", [](const SearchState& state) { return open_with_progressions(state); }));
    return all;
}

}  // namespace rinceau

#include "analyzer/openings.h"

#include "analyzer/branch_opening.h"
#include "analyzer/open_with_spirals.h"
#include "analyzer/scene_rotation.h"
#include "analyzer/sector_rules.h"

namespace rinceau {

namespace {

std::optional<SearchState> open_with_nothing(const SearchState& start, const SearchOptions&, const Progress&) { return start; }

std::optional<SearchState> open_with_rotation(const SearchState& start, const SearchOptions& options, const Progress& progress) {
    const auto rotation = find_scene_rotation(start);
    if (!rotation) return std::nullopt;
    return open_with_sectors(start, *rotation, options, progress);
}

std::optional<SearchState> open_with_spiral(const SearchState& start, const SearchOptions&, const Progress&) {
    return open_with_spirals(start);
}

}  // namespace

const std::vector<Opening>& openings() {
    // A lattice turns about its middle too: rows and columns are what a person sees unless the rotation says clearly less.
    constexpr double clearly = 0.9;
    static const std::vector<Opening> all{
        {"from below", 1, open_with_nothing},
        {"rotation of the whole", clearly, open_with_rotation},
        {"branching", 1, [](const SearchState& start, const SearchOptions&, const Progress&) { return open_with_branching(start); }},
        {"self-similarity", 1,
         [](const SearchState& start, const SearchOptions&, const Progress&) { return open_with_self_similarity(start); }},
        {"spirals", 1, open_with_spiral},
    };
    return all;
}

}  // namespace rinceau

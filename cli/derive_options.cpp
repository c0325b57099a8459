#include "cli/derive_options.h"

#include <limits>

namespace rinceau {

void add_derive_options(CLI::App& verb, DeriveOptions& options) {
    options.max_modules = default_max_modules;
    verb.add_option("--depth", options.depth, "Steps of rewriting; without it, until nothing is left to rewrite")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()))
        ->type_name("N");
    verb.add_option("--seed", options.seed, "For what is random, instead of the grammar's own; the same seed gives the same bytes")
        ->type_name("N");
    verb.add_option("--max-modules", options.max_modules, "Most modules that the grammar may grow to")
        ->check(CLI::PositiveNumber)
        ->capture_default_str()
        ->type_name("N");
}

}  // namespace rinceau

#pragma once
// Derivation: from the axiom to a string of modules, streamed depth first (equal to parallel rewriting for context-free
// productions), with the address of every module.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/progress.h"
#include "lsystem/grammar.h"
#include "lsystem/text_pieces.h"

namespace rinceau {

/// Index into Derivation::symbols.
using Symbol = std::int32_t;

struct Module {
    Symbol symbol = 0;
    std::vector<double> arguments;
};

struct DeriveOptions {
    int depth = -1;                     ///< steps of rewriting; -1 = until nothing is left to rewrite
    std::optional<std::uint64_t> seed;  ///< for random numbers and stochastic productions; else the grammar's, else 1
    /// In the derived string and rewritten on the way, together; more -> LimitError naming the production that grew.
    std::uint64_t max_modules = 20'000'000;
    int max_recursion = 100'000;  ///< steps when depth = -1; more -> LimitError naming the production
    double max_seconds = 0;       ///< 0 = no limit; more -> LimitError naming the production
};

/// The derived string: what axiom, rewriting and decomposition give; homomorphisms only draw (interpret.h).
///
/// Randomness: what is drawn depends on the seed and on its place alone, never on what was drawn before it. The place is the
/// way from the axiom: at each production the place of the symbol among the symbols of the string (whatever the production,
/// its condition and the parameters); then, in the successor, behind how many symbols and in which command the draw stands,
/// counted among those commands of its kind since the last symbol that draw anything, or in which argument of a symbol; and
/// its place among the draws of the expression. So all other draws stay when
///   - a count changes (P(5) of P(m) : m > 0 -> [A(uniform(0, 1))] f(13) P(m-1) has the first five A of P(9)),
///   - commands that draw nothing are added, changed or taken away, or parameters and deviations are changed,
///   - an exception replaces a module; its single symbol draws as the one that it replaces,
///   - a draw is added or removed in another command's kind, in another expression or behind another symbol,
///   - the depth changes.
/// Weighted productions of one symbol and kind have such a place, too, each by its order among them; a weight that changes
/// moves only choices to or from its own production. A constant draws once, by its name.
///
/// Addresses: the symbols that are not turtle commands are counted 1, 2, .. in the axiom. A production's
/// modules are counted below its own address, except modules of the production's own symbol: these continue its level
/// (their modules are counted on, in order of derivation), so that in P(m) : m > 0 -> [A] f(13) P(m-1) the axiom P(3)
/// gives A at 1.1, 1.2, 1.3, and these stay when the count is changed.
struct ModuleString {
    std::vector<std::string> symbols;
    std::vector<Module> modules;
};

/// Throws InputError (unknown name in an expression, wrong number of arguments, value that is not finite, a deviation or a
/// weight below 0, weights that are all 0) at the place in the grammar's text, or LimitError.
ModuleString derive(const Grammar& grammar, const DeriveOptions& options = {}, const Progress& progress = {});

/// "+(30) f(12.5) [ A ] ..." with numbers in shortest round-trip form.
std::string to_text(const ModuleString& string);

/// The same text without the string, as it is derived: memory is proportional to the depth. Throws as derive() and as the
/// sink; what was passed on before is a beginning of the text.
void derive_text(const Grammar& grammar, const DeriveOptions& options, const TextSink& sink, const Progress& progress = {});

}  // namespace rinceau

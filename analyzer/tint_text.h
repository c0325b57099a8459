#pragma once
// Style choices written into a grammar: `;(n)` before terminals, arguments for productions.

#include <map>
#include <string>
#include <vector>

#include "analyzer/derivation_tree.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// What stands at a site chooses its style by these: a terminal by one, a production by as many as it has new parameters.
using TintArguments = std::vector<Expression>;

struct TintException {
    std::vector<int> address;   ///< no exception stands there yet
    ModuleSite site;            ///< of the module in the text; its own arguments use constants only
    TintArguments arguments;
};

struct TintEdits {
    std::map<std::pair<int, int>, TintArguments> sites;             ///< (string, position) as in ModuleSite
    std::map<std::string, std::vector<std::string>> parameters;     ///< new ones, by symbol; handed on in calls of itself
    std::vector<TintException> exceptions;
};

/// `;(n)` stands directly before a terminal; in brackets with it unless its bracket ends there anyway. Every module keeps
/// its address.
Grammar with_tints(const Grammar& grammar, const TintEdits& edits);

}  // namespace rinceau

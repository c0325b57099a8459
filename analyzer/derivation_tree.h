#pragma once
// Who was derived from what: the tree of modules above the drawn terminals, from their addresses and trails.

#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/interpret.h"

namespace rinceau {

/// A place in the grammar's text where a module stands: position in the axiom (string -1), in a production's successor, or,
/// from `exception_string` down, in the successor of exception (exception_string - string).
struct ModuleSite {
    int string = -1;
    int position = 0;
    friend constexpr bool operator==(const ModuleSite&, const ModuleSite&) = default;
};
constexpr int exception_string = -2;

const std::vector<ModuleTemplate>& string_at(const Grammar& grammar, const ModuleSite& site);

struct DerivedModule {
    int parent = -1;
    int depth = 0;
    int site = -1;           ///< index into DerivationTree::sites; -1 for the root
    int path = 0;            ///< node of the tree of sites, see DerivationTree::site_parent
    int leaf = 0;            ///< the first leaf below
    int address_length = 0;  ///< of the leaf's address, that is this module's
};

/// Nodes come after their parents; node 0 is the root, above the axiom. Self-recursion of productions is left out.
struct DerivationTree {
    std::vector<DerivedModule> nodes{DerivedModule{}};
    std::vector<int> node_of_leaf;
    std::vector<ModuleSite> sites;
    std::vector<int> nodes_of_site;    ///< how many nodes stand at the site
    std::vector<int> site_parent{-1};  ///< the tree merged where sites agree: parent of a path,
    std::vector<int> path_site{-1};    ///< and its last site
};

/// `leaves` in order of derivation, with addresses and trails.
DerivationTree derivation_tree(const Grammar& grammar, const std::vector<Placement>& leaves);

}  // namespace rinceau

#include "analyzer/derivation_tree.h"

#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "lsystem/turtle_commands.h"

namespace rinceau {
namespace {

/// A step down the tree: from a node to the module at a site, which has a number below the address so far (0 = it stands at
/// the address of the module that it replaces).
using Step = std::tuple<int, int, int>;

class TreeBuilder {
  public:
    explicit TreeBuilder(const Grammar& grammar) : grammar_(grammar) {
        for (std::size_t e = 0; e < grammar.exceptions.size(); ++e) {
            exception_at_[grammar.exceptions[e].address] = static_cast<int>(e);
        }
    }

    void add_leaf(const Placement& placement) {
        int node = 0;
        std::size_t length = 0;  // of the address that is used up
        int string = -1;
        for (std::size_t k = 0; k < placement.trail.size(); ++k) {
            const Occurrence& occurrence = placement.trail[k];
            int number = 0;
            if (occurrence.production >= -1) {
                string = occurrence.production;
                number = placement.address[length++];
            } else {
                const std::vector<int> replaced(placement.address.begin(),
                                                placement.address.begin() + static_cast<std::ptrdiff_t>(length));
                const int exception = exception_at_.at(replaced);
                string = exception_string - exception;
                if (symbols_in(exception) != 1) number = placement.address[length++];
            }
            node = child(node, site_index({string, occurrence.position}), number, length);
        }
        tree_.node_of_leaf.push_back(node);
    }

    DerivationTree take() { return std::move(tree_); }

  private:
    const Grammar& grammar_;
    std::map<std::vector<int>, int> exception_at_;
    std::map<std::pair<int, int>, int> site_indices_;
    std::map<Step, int> children_;
    std::map<std::pair<int, int>, int> paths_;
    DerivationTree tree_;

    int symbols_in(int exception) const {
        int symbols = 0;
        for (const ModuleTemplate& module : grammar_.exceptions[static_cast<std::size_t>(exception)].successor) {
            symbols += find_turtle_command(module.symbol) == nullptr;
        }
        return symbols;
    }

    int site_index(const ModuleSite& site) {
        const auto [at, added] =
            site_indices_.try_emplace({site.string, site.position}, static_cast<int>(tree_.sites.size()));
        if (added) {
            tree_.sites.push_back(site);
            tree_.nodes_of_site.push_back(0);
        }
        return at->second;
    }

    int child(int parent, int site, int number, std::size_t address_length) {
        const auto [at, added] = children_.try_emplace({parent, site, number}, static_cast<int>(tree_.nodes.size()));
        if (added) {
            const DerivedModule& above = tree_.nodes[static_cast<std::size_t>(parent)];
            const DerivedModule module{.parent = parent,
                                       .depth = above.depth + 1,
                                       .site = site,
                                       .path = path(above.path, site),
                                       .leaf = static_cast<int>(tree_.node_of_leaf.size()),
                                       .address_length = static_cast<int>(address_length)};
            tree_.nodes.push_back(module);
            ++tree_.nodes_of_site[static_cast<std::size_t>(site)];
        }
        return at->second;
    }

    int path(int parent, int site) {
        const auto [at, added] = paths_.try_emplace({parent, site}, static_cast<int>(tree_.site_parent.size()));
        if (added) {
            tree_.site_parent.push_back(parent);
            tree_.path_site.push_back(site);
        }
        return at->second;
    }
};

}  // namespace

const std::vector<ModuleTemplate>& string_at(const Grammar& grammar, const ModuleSite& site) {
    if (site.string >= 0) return grammar.productions[static_cast<std::size_t>(site.string)].successor;
    if (site.string == -1) return grammar.axiom;
    return grammar.exceptions[static_cast<std::size_t>(exception_string - site.string)].successor;
}

DerivationTree derivation_tree(const Grammar& grammar, const std::vector<Placement>& leaves) {
    TreeBuilder builder(grammar);
    for (const Placement& leaf : leaves) builder.add_leaf(leaf);
    return builder.take();
}

}  // namespace rinceau

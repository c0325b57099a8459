#include "analyzer/repetition.h"

#include "lsystem/turtle_commands.h"

namespace rinceau {

std::optional<Repetition> repetition_of(const Grammar& grammar, const std::string& symbol) {
    const Production* only = nullptr;
    Repetition repetition;
    for (std::size_t p = 0; p < grammar.productions.size(); ++p) {
        if (grammar.productions[p].symbol != symbol) continue;
        if (only != nullptr) return std::nullopt;
        only = &grammar.productions[p];
        repetition.production = static_cast<int>(p);
    }
    if (only == nullptr || only->parameters.empty() || only->successor.empty()) return std::nullopt;
    const ModuleTemplate& last = only->successor.back();
    repetition.counter = only->parameters.front();
    if (last.symbol != symbol || last.arguments.empty()) return std::nullopt;
    if (to_text(last.arguments.front()) != repetition.counter + "-1") return std::nullopt;
    repetition.modules = 0;
    for (const ModuleTemplate& module : only->successor) {
        if (find_turtle_command(module.symbol) != nullptr) continue;
        if (module.symbol == symbol && &module != &last) return std::nullopt;
        repetition.modules += module.symbol == symbol ? 0 : 1;
    }
    if (repetition.modules == 0) return std::nullopt;
    return repetition;
}

int turn_of(const DerivationTree& tree, const std::vector<Placement>& leaves, int node, const Repetition& repetition) {
    const DerivedModule& at = tree.nodes[static_cast<std::size_t>(node)];
    const std::vector<int>& address = leaves[static_cast<std::size_t>(at.leaf)].address;
    return (address[static_cast<std::size_t>(at.address_length - 1)] - 1) / repetition.modules;
}

}  // namespace rinceau

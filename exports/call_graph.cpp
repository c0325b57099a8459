#include "exports/call_graph.h"

#include <algorithm>

#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

bool is_balanced(const std::vector<ModuleTemplate>& string) {
    int open = 0;
    for (const ModuleTemplate& module : string) {
        open += module.symbol == "[" ? 1 : module.symbol == "]" ? -1 : 0;
        if (open < 0) return false;
    }
    return open == 0;
}

/// Applies `grow`, which may add to a set and says whether it did, until it adds no more.
template <class Grow>
void until_stable(const std::map<Signature, std::vector<const Production*>>& productions, Grow grow) {
    for (bool grown = true; grown;) {
        grown = false;
        for (const auto& [signature, list] : productions) {
            for (const Production* production : list) grown = grow(signature, *production) || grown;
        }
    }
}

}  // namespace

CallGraph::CallGraph(const Grammar& grammar) {
    for (const Production& production : grammar.productions) {
        productions_[{production.symbol, production.parameters.size()}].push_back(&production);
        balanced_ = balanced_ && is_balanced(production.successor);
    }
    balanced_ = balanced_ && is_balanced(grammar.axiom);
    for (const Terminal& terminal : grammar.terminals)
        terminals_[terminal.symbol] = static_cast<int>(&terminal - grammar.terminals.data());
    find_drawing();
    find_moving();
    find_reach();
}

const std::vector<const Production*>& CallGraph::productions_of(const Signature& signature) const {
    static const std::vector<const Production*> none;
    const auto found = productions_.find(signature);
    return found == productions_.end() ? none : found->second;
}

int CallGraph::terminal_of(const std::string& symbol) const {
    const auto found = terminals_.find(symbol);
    return found == terminals_.end() ? -1 : found->second;
}

bool CallGraph::draws(const Signature& signature) const {
    return terminals_.contains(signature.first) || drawing_.contains(signature);
}

void CallGraph::find_drawing() {
    until_stable(productions_, [&](const Signature& signature, const Production& production) {
        const auto draw = [&](const ModuleTemplate& module) { return draws(module); };
        return std::ranges::any_of(production.successor, draw) && drawing_.insert(signature).second;
    });
}

bool CallGraph::moves(const std::vector<ModuleTemplate>& string) const {
    int open = 0;
    for (const ModuleTemplate& module : string) {
        if (module.symbol == "[") ++open;
        if (module.symbol == "]") --open;
        if (open > 0 || module.symbol == "]") continue;
        if (find_turtle_command(module.symbol) != nullptr || moving_.contains(signature_of(module))) return true;
    }
    return false;
}

void CallGraph::find_moving() {
    until_stable(productions_, [&](const Signature& signature, const Production& production) {
        return moves(production.successor) && moving_.insert(signature).second;
    });
}

void CallGraph::find_reach() {
    for (const auto& entry : productions_) reach_[entry.first];
    until_stable(productions_, [&](const Signature& signature, const Production& production) {
        std::set<Signature>& reach = reach_[signature];
        const std::size_t before = reach.size();
        for (const ModuleTemplate& module : production.successor) {
            const Signature next = signature_of(module);
            if (!productions_.contains(next)) continue;
            reach.insert(next);
            const std::set<Signature> beyond = reach_[next];
            reach.insert(beyond.begin(), beyond.end());
        }
        return reach.size() != before;
    });
}

bool CallGraph::matters(const std::vector<ModuleTemplate>& string, std::size_t position) const {
    int open = 0;
    for (std::size_t i = position + 1; i < string.size(); ++i) {
        if (string[i].symbol == "[") ++open;
        if (string[i].symbol == "]" && --open < 0) return false;
        if (draws(string[i])) return true;
    }
    return false;
}

}  // namespace rinceau

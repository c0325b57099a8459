#pragma once
// What the symbols of a grammar do to the turtle and to the picture. Internal to the folder.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

/// Symbols with different numbers of arguments have different productions.
using Signature = std::pair<std::string, std::size_t>;

inline Signature signature_of(const ModuleTemplate& module) { return {module.symbol, module.arguments.size()}; }

/// Of a grammar with plain rules (lsystem/plain_rules.h).
class CallGraph {
  public:
    explicit CallGraph(const Grammar& grammar);

    const std::vector<const Production*>& productions_of(const Signature& signature) const;
    /// Index into Grammar::terminals, -1 = the symbol is not drawn.
    int terminal_of(const std::string& symbol) const;
    /// May anything be drawn where it stands?
    bool draws(const Signature& signature) const;
    bool draws(const ModuleTemplate& module) const { return draws(signature_of(module)); }
    /// Does it surely leave the turtle as it was?
    bool stays(const ModuleTemplate& module) const { return !moving_.contains(signature_of(module)); }
    /// Can the symbol be met again inside it?
    bool recurs(const Signature& signature) const { return reach_.at(signature).contains(signature); }
    /// Is anything drawn behind this module before its bracket closes, so that where it leaves the turtle matters?
    bool matters(const std::vector<ModuleTemplate>& string, std::size_t position) const;
    /// All brackets are closed where they are opened.
    bool balanced() const { return balanced_; }

  private:
    std::map<Signature, std::vector<const Production*>> productions_;
    std::map<std::string, int> terminals_;
    std::map<Signature, std::set<Signature>> reach_;
    std::set<Signature> drawing_;
    std::set<Signature> moving_;
    bool balanced_ = true;

    void find_drawing();
    void find_moving();
    void find_reach();
    bool moves(const std::vector<ModuleTemplate>& string) const;
};

}  // namespace rinceau

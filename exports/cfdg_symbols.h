#pragma once
// Names and types of a grammar's symbols in Context Free's language. Internal to the folder.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "exports/call_graph.h"
#include "exports/cfdg_drawing.h"
#include "exports/cfdg_expression.h"
#include "lsystem/derive.h"

namespace rinceau {

/// What can be said inside one shape.
struct CfdgScope {
    std::string shape;
    std::vector<std::string> parameters;  ///< as in the grammar
    std::vector<bool> natural;            ///< whole numbers from 0, that Context Free can calculate with
    NameMap names;                        ///< of parameters and constants
    std::string style = "0";              ///< that is in force where the shape begins
};

class CfdgSymbols {
  public:
    /// With live_random what the derivation shows is not taken for everything that can happen.
    CfdgSymbols(const Grammar& grammar, const DeriveOptions& options, bool live_random);

    UniqueNames names;  ///< but for parameters
    NameMap constants;
    std::map<Signature, CfdgScope> scopes;
    bool styled = false;  ///< shapes have the style in force as their last parameter
    std::string style_name;
    std::map<int, std::set<int>> looks;  ///< terminal -> styles in force where it is drawn
    std::uint64_t placements = 0;
    int depth = 0;
    double most_natural = 0;  ///< the largest number that a natural parameter has

    CfdgScope axiom_scope() { return {.shape = names.take("Picture"), .parameters = {}, .natural = {}, .names = constants}; }
    /// The scope of a production, whose parameters may have other names than those that its shape has them by.
    CfdgScope scope_of(const Production& production, const CfdgScope& shape) const;
    /// The expression, if Context Free knows that it is natural: a whole number or a natural parameter, or two of these
    /// added or subtracted.
    std::optional<std::string> natural_text(const Expression& expression, const CfdgScope& scope) const;

  private:
    const Grammar& grammar_;
    DeriveOptions options_;

    void find_looks(bool live_random);
    void name_shapes(bool live_random);
    void find_naturals();
    bool restrict_naturals(const std::vector<ModuleTemplate>& string, const CfdgScope& scope);
    std::optional<std::string> natural_atom(const Expression::Node& node, const CfdgScope& scope) const;
};

}  // namespace rinceau

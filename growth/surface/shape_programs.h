#pragma once
// Expressions of shape grammars made ready for many evaluations: names are slots or numbers, what they ask of fields and of
// the scope is asked for only when they are evaluated (Li et al. 2010, sections 4.3.2 and 4.3.3).

#include <cstdint>
#include <span>
#include <vector>

#include "growth/mesh/triangle_mesh.h"
#include "growth/surface/shape_queries.h"
#include "lsystem/program.h"

namespace rinceau {

/// What a grammar's numbers depend on besides its text.
struct ShapeGrammarSetting {
    std::uint64_t seed = 1;
    double diagonal = 1;               ///< of the surface's box: the name `diagonal` in expressions
    double area = 1;                   ///< of the surface: `area`
    double mean_edge = 1;              ///< of the surface: `edge`
    SpacePoint low{-0.5, -0.5, -0.5};  ///< corners of the surface's box: `left` `bottom` `back`
    SpacePoint high{0.5, 0.5, 0.5};    ///< and `right` `top` `front`
};

/// An expression made ready. Refers to the grammar that it is of.
struct ShapeProgram {
    bool constant = true;
    double value = 0;  ///< if constant
    Program program;
    std::vector<ShapeQuery> queries;  ///< their slots come behind the rule's parameters
    int parameters = 0;               ///< of the rule
    Expression expression;            ///< for messages
    const SourcePlace* place = nullptr;
};

/// The names that the expressions of a grammar share: params and what is known of the surface.
class ShapeNames {
  public:
    /// Evaluates the params, in order, with the draws of the seed. What cannot be evaluated is kept in `mistakes`, and has
    /// the value 1.
    ShapeNames(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting, std::vector<Warning>& mistakes);

    /// Throws InputError at `place` for unknown names and queries. Draws get salts below `salt`.
    ShapeProgram compile(const Expression& expression, const std::vector<std::string>& parameters, std::uint64_t salt,
                         const SourcePlace& place) const;
    /// Of an expression without parameters and queries. Throws InputError at `place` for those, and if it is not finite.
    double value(const Expression& expression, const SourcePlace& place, DrawKey key = 0) const;
    /// By the params' order.
    const std::vector<double>& params() const { return params_; }

  private:
    const ShapeGrammar* grammar_;
    Scope scope_;
    std::vector<double> params_;

    [[noreturn]] void fail_unknown(const std::string& name, const std::vector<std::string>& parameters,
                                   const SourcePlace& place) const;
    void expect_known(const Expression& expression, const std::vector<std::string>& parameters, bool with_queries,
                      const SourcePlace& place) const;
};

/// The values of a grammar's params by their order. Throws InputError at the first mistake in them.
std::vector<double> param_values(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting = {});
/// Of an expression of params: a setting, an option. Throws InputError at `place`.
double value_of(const Expression& expression, const ShapeGrammar& grammar, const ShapeGrammarSetting& setting,
                const SourcePlace& place);

}  // namespace rinceau

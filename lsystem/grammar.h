#pragma once
// A parametric L-system with turtle commands and drawn terminals (Stava et al. 2010, section 3); stochastic productions,
// contexts, decompositions and homomorphisms as in L-Py and cpfg.
// After analysis the grammar is the only truth: every edit is a function Grammar -> Grammar.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/box.h"
#include "lsystem/expression.h"
#include "scene/element.h"

namespace rinceau {

/// A module with arguments still to be evaluated: P(m-1), f(13), +(360/n), [ , ].
struct ModuleTemplate {
    std::string symbol;
    std::vector<Expression> arguments;
    SourcePlace place;  ///< where it stands in the text, if it was read from one
};

/// When a production applies: in every step of rewriting; at once to what a step has made, again and again, without taking a
/// step (decomposition); or only for drawing, to what is left at the end, without changing the derived string (homomorphism).
enum class ProductionKind : unsigned char { rewriting, decomposition, homomorphism };

/// A module that must stand beside the one that is rewritten: symbol(parameters), the parameters being names that the
/// condition, the weight and the successor may use.
struct ContextModule {
    std::string symbol;
    std::vector<std::string> parameters;
    SourcePlace place;
};

/// left < symbol(parameters) > right : condition -> successor : weight.  No condition = always. The first production of a
/// symbol that fits and whose condition holds is applied; if it has a weight, one of all those with weight that fit and
/// hold is drawn, in proportion to the weights. Without any, the module stays as it is (the implicit rule r0, eq. 2).
struct Production {
    std::string symbol;
    std::vector<std::string> parameters;
    std::optional<Expression> condition;
    std::vector<ModuleTemplate> successor;
    std::string comment;  ///< line(s) before the production, without '#'
    SourcePlace place;
    ProductionKind kind = ProductionKind::rewriting;
    std::vector<ContextModule> left_context;   ///< as written, the nearest last; only of rewriting productions
    std::vector<ContextModule> right_context;  ///< as written, the nearest first; only of rewriting productions
    std::optional<Expression> weight;          ///< not below 0
};

/// A symbol that is drawn. `paths` and the numbers of its style are in the terminal's own frame: heading = +y (up), origin at
/// the turtle. `verbatim` fragments are in SVG's y-down space about the same origin.
struct Terminal {
    std::string symbol;
    int style = 0;  ///< number of a NumberedStyle, 0 = a default Style; ignored for verbatim
    std::vector<Path> paths;
    std::string verbatim;
    Box verbatim_box;
    std::string id;
    std::string comment;
    SourcePlace place;
};

/// A style by number, so that expressions can choose one: `;(2)` in a string makes the next terminals use style 2.
struct NumberedStyle {
    int number = 0;  ///< from 1; 0 means "the terminal's own" in `;(n)`, and black fill in a terminal
    Style style;
    std::string comment;
    SourcePlace place;
};

/// define name = value; visible in every expression. Constants may use constants defined before them.
struct Constant {
    std::string name;
    Expression value;
    std::string comment;
    SourcePlace place;
};

/// "except 1.3.2 -> ...": at one address of the derivation (derive.h) the module that stands there is replaced, before
/// it is expanded, by `successor`. Nothing = erased. Inside the successor the exception does not apply again.
struct Exception {
    std::vector<int> address;  ///< counted from 1
    std::vector<ModuleTemplate> successor;
    std::string comment;
    SourcePlace place;
};

/// use "vine.lsys" as vine: the constants, productions, styles and terminals of another file, with `prefix` and '_' before
/// their names if a prefix is given. Resolved when the grammar is read for drawing, kept as it is when it is edited.
struct Use {
    std::string file;    ///< relative to the folder of the grammar that says so
    std::string prefix;  ///< empty = names as they are
    std::string comment;
    SourcePlace place;
};

struct Grammar {
    std::string title;
    Box canvas;         ///< scene space (y up) of the picture
    bool sized = true;  ///< Scene::sized
    std::vector<std::string> comments;  ///< lines at the top of the text
    std::vector<Constant> constants;
    std::vector<ModuleTemplate> axiom;
    std::vector<Production> productions;
    std::vector<Exception> exceptions;
    std::vector<NumberedStyle> styles;
    std::vector<Terminal> terminals;
    std::vector<Use> uses;
    std::optional<std::uint64_t> seed;  ///< for random numbers and stochastic productions, unless DeriveOptions has one
    std::vector<std::string> ignored;   ///< symbols that contexts look past; commands are always looked past
};

}  // namespace rinceau

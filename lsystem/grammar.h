#pragma once
// A parametric context-free L-system with turtle commands and drawn terminals (Stava et al. 2010, section 3).
// After analysis the grammar is the only truth: every edit is a function Grammar -> Grammar.

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

/// symbol(parameters) : condition -> successor.  No condition = always. The first production of a symbol whose condition
/// holds is applied; without any, the module stays as it is (the implicit rule r0, eq. 2).
struct Production {
    std::string symbol;
    std::vector<std::string> parameters;
    std::optional<Expression> condition;
    std::vector<ModuleTemplate> successor;
    std::string comment;  ///< line(s) before the production, without '#'
    SourcePlace place;
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
};

}  // namespace rinceau

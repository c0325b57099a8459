#pragma once
// A field-guided shape grammar as it is written (Li et al. 2010, sections 3.3, 3.4, 4.3 and 4.4; text form .fgsg, described
// in docs/shape_grammars.md).

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lsystem/expression.h"
#include "scene/input_error.h"

namespace rinceau {

enum class ShapeVerb : unsigned char {
    move,          ///< T(x, y, z): along the field at a constant angle, z along the normal; y and z may be left out
    go_straight,   ///< G(x, y, z): the same along a straight geodesic
    size,          ///< S(x, y, z), or S(all)
    turn_x,        ///< Rx(degrees)
    turn_y,        ///< Ry(degrees)
    turn_z,        ///< Rz(degrees)
    push,          ///< [
    pop,           ///< ]
    place,         ///< I("shape")
    place_clear,   ///< IC("shape"): unless it collides
    place_merged,  ///< IM("shape", distance, degrees): unless one of its kind is that near, which the scope snaps to
    lock,          ///< Lock{a | b}: all or none
    chart,         ///< Chart{...}: moves inside go through one chart about the scope
    line,          ///< Line(merge)
    line_segment,  ///< LineSeg(length, width)
    colour,        ///< Colour(n), Colour(r, g, b) or Colour("#rrggbb")
    attribute,     ///< Set("name", value)
    symbol         ///< any other name: a non-terminal
};

struct ShapeCommand {
    ShapeVerb verb = ShapeVerb::symbol;
    std::string name;                               ///< of a symbol
    std::string text;                               ///< the string argument: shape, attribute or colour
    bool has_text = false;                          ///< the string argument is there
    std::vector<Expression> arguments;              ///< the numbers
    std::vector<std::vector<ShapeCommand>> groups;  ///< Lock: one for each part; Chart: one
    SourcePlace place;
};

/// id: symbol(parameters) : condition ~ successor : probability @ priority
struct ShapeRule {
    std::string id;  ///< may be empty
    std::string symbol;
    std::vector<std::string> parameters;
    std::optional<Expression> condition;
    std::vector<ShapeCommand> successor;
    std::optional<Expression> probability;  ///< a weight among those of its symbol whose condition holds
    double priority = 0;
    std::string comment;
    SourcePlace place;
};

struct ShapeParam {
    std::string name;
    Expression value;
    std::string comment;  ///< the lines before it and what stands behind it, without #; so everywhere
    SourcePlace place;
};

/// shape leaf = outline "leaf.svg" height = 0.3; field F1 = elements "vine.json" smooth = 0.03
struct ShapeSource {
    std::string name;
    std::string kind;  ///< outline, mesh, box, torus ... ; elements, file, curvature, image, constant, radial ...
    std::string text;  ///< the string behind the kind
    std::map<std::string, Expression> numbers;
    std::map<std::string, std::string> words;  ///< collide = hull, colour = "#aa3311"
    std::string comment;
    SourcePlace place;
};

/// axiom vertex 0 Tile: a place and what begins there.
struct ShapeAxiom {
    enum class Where : unsigned char { vertex, nearest, scatter, each };
    Where where = Where::vertex;
    std::vector<Expression> numbers;  ///< the vertex; x, y, z; how many
    std::string field;                ///< each: the field at whose singular points it begins
    std::vector<ShapeCommand> commands;
    std::string comment;
    SourcePlace place;
};

struct ShapeGrammar {
    std::string file_name;  ///< names in it are relative to its folder
    std::vector<ShapeParam> params;
    std::vector<ShapeSource> shapes;
    std::vector<ShapeSource> fields;
    std::map<std::string, ShapeSource> options;  ///< by name: text (a string or a word) or numbers["value"]
    std::vector<ShapeAxiom> axioms;
    std::vector<ShapeRule> rules;
    std::vector<std::string> comments;  ///< lines that belong to no statement
};

}  // namespace rinceau

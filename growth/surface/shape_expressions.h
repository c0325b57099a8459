#pragma once
// A shape grammar made ready for deriving: symbols, shapes and fields are numbers, conditions and arguments are programs.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "growth/surface/shape_programs.h"
#include "scene/style.h"

namespace rinceau {

struct CompiledShapeCommand {
    ShapeVerb verb = ShapeVerb::symbol;
    int symbol = -1;  ///< verb symbol: its number; by name and number of arguments
    int shape = -1;   ///< place..: index into the grammar's shapes
    int ordinal = 0;  ///< position in its rule or axiom, counted through all groups: key_of_child()
    bool has_colour = false;
    Color colour;  ///< Colour("#rrggbb")
    /// As written, but filled up where they may be left out: three for T, G and S; of IM the degrees (180); of Line 1.
    std::vector<ShapeProgram> numbers;
    std::vector<std::vector<CompiledShapeCommand>> groups;
    const ShapeCommand* source = nullptr;  ///< text of attributes; place
};

struct CompiledShapeRule {
    int symbol = 0;
    int parameters = 0;
    std::vector<ShapeProgram> condition;    ///< its parts between &&: all must hold; asked in order until one does not
    std::vector<ShapeProgram> probability;  ///< one or none
    double priority = 0;
    std::vector<CompiledShapeCommand> successor;
    const ShapeRule* source = nullptr;
};

constexpr double most_scattered = 1e7;  ///< places of one axiom

/// Its numbers are finite; a vertex and how many to scatter are whole numbers from 0, the latter up to most_scattered.
struct CompiledShapeAxiom {
    ShapeAxiom::Where where = ShapeAxiom::Where::vertex;
    std::vector<double> numbers;
    int field = -1;  ///< each: index into the grammar's fields
    std::vector<CompiledShapeCommand> commands;
    const ShapeAxiom* source = nullptr;
};

/// A symbol of so many arguments.
struct ShapeSymbol {
    std::string name;
    int arguments = 0;
    std::vector<int> rules;  ///< by their order in the grammar; at least one
};

/// Refers to the grammar, which must outlive it.
struct CompiledShapeGrammar {
    std::vector<ShapeSymbol> symbols;
    std::vector<CompiledShapeRule> rules;  ///< as in the grammar
    std::vector<CompiledShapeAxiom> axioms;
    DrawKey root = 0;               ///< of the seed; an axiom's key is key_of_child(root, its index)
    int slots = 0, stack_size = 0;  ///< that an evaluation needs at most
};

/// Throws InputError at the first mistake that check_shape_grammar() would name: unknown symbols, shapes, fields, queries
/// and names, wrong numbers of arguments, params that are not finite.
CompiledShapeGrammar compile_shape_grammar(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting = {});

/// All mistakes are kept instead; what has one is left out.
CompiledShapeGrammar compile_shape_grammar(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting,
                                           std::vector<Warning>& mistakes);

/// The key of what the command with that ordinal begins, in a rule of the shape with `key`. Draws depend on the seed and on
/// this way to a shape alone, not on the order of the derivation.
constexpr DrawKey key_of_child(DrawKey key, int ordinal) { return key_below(key, static_cast<std::uint64_t>(ordinal)); }
/// In [0, 1): which rule the shape with `key` takes.
double rule_draw(DrawKey key);

/// Evaluates programs with room of its own; one for each thread.
class ShapeEvaluator {
  public:
    explicit ShapeEvaluator(const CompiledShapeGrammar& grammar);

    /// `parameters` are the arguments of the rule's symbol, `key` is that symbol's. Throws InputError, with the expression
    /// and its place, if the result is not finite.
    double number(const ShapeProgram& program, std::span<const double> parameters, DrawKey key, QuerySource& queries) {
        return program.constant ? program.value : finite(program, parameters, key, queries);
    }
    /// Throws InputError if a part of the condition is not a number.
    bool holds(const CompiledShapeRule& rule, std::span<const double> parameters, DrawKey key, QuerySource& queries);

  private:
    std::vector<double> slots_, stack_;

    double finite(const ShapeProgram& program, std::span<const double> parameters, DrawKey key, QuerySource& queries);
    double evaluated(const ShapeProgram& program, std::span<const double> parameters, DrawKey key, QuerySource& queries);
};

}  // namespace rinceau

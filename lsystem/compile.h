#pragma once
// A grammar made ready for derivation: symbols and names as numbers. Internal to the folder.

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

#include "lsystem/derive.h"
#include "lsystem/exception_tree.h"
#include "lsystem/grammar.h"
#include "lsystem/program.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

/// Symbols below this are the turtle's commands, in the order of TurtleCommand.
constexpr Symbol command_count = 9;

struct CompiledModule {
    Symbol symbol = 0;
    int position = 0;  ///< in its successor or in the axiom
    std::vector<Program> arguments;
    bool constant = true;        ///< all arguments are constants:
    std::vector<double> values;  ///< then these are they
    Complex turn{1, 0};          ///< of a constant + or -
    const ModuleTemplate* source = nullptr;
};

using CompiledString = std::vector<CompiledModule>;

struct CompiledProduction {
    Symbol symbol = 0;
    int parameters = 0;
    bool conditional = false;
    Program condition;
    CompiledString successor;
};

/// Refers to the grammar that it was made from, which must outlive it.
struct CompiledGrammar {
    const Grammar* grammar = nullptr;
    std::vector<std::string> symbols;
    std::vector<std::vector<int>> productions_of;  ///< symbol -> productions, in the grammar's order
    std::vector<int> terminal_of;                  ///< symbol -> terminal, -1 = none
    std::vector<CompiledProduction> productions;
    CompiledString axiom;
    std::vector<CompiledString> exceptions;
    ExceptionTree exception_tree;
    int stack_size = 1;         ///< of the largest expression
    std::size_t max_arity = 1;  ///< of any module
};

/// Throws InputError for unknown names, wrong numbers of arguments of commands and of symbols that have productions or are
/// terminals, constants that are not finite, unknown numbers of styles.
CompiledGrammar compile(const Grammar& grammar);

/// The values of the constants in order. Throws InputError for unknown names and values that are not finite.
std::vector<std::pair<std::string, double>> evaluate_constants(const Grammar& grammar);

/// true if the grammar has a style of that number, or the number is 0 ("its own").
bool has_style(const Grammar& grammar, int number);

}  // namespace rinceau

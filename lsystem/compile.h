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
#include "lsystem/style_table.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

/// Symbols below this are the turtle's commands, in the order of TurtleCommand.
constexpr Symbol command_count = 11;

struct CompiledModule {
    Symbol symbol = 0;
    int position = 0;  ///< in its successor or in the axiom
    int argument_count = 0;
    bool constant = true;            ///< all arguments are constants, which begin at first_value of CompiledGrammar::values;
    std::vector<Program> arguments;  ///< else these are they
    std::size_t first_value = 0;
    Complex turn{1, 0};  ///< of a constant + or -
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
    StyleTable styles;
    std::vector<double> values;  ///< of constant arguments
    std::vector<std::string> symbols;
    std::vector<std::vector<int>> productions_of;  ///< symbol -> productions, in the grammar's order
    std::vector<int> terminal_of;                  ///< symbol -> terminal, -1 = none
    std::vector<CompiledProduction> productions;
    CompiledString axiom;
    std::vector<CompiledString> exceptions;
    ExceptionTree exception_tree;
    int stack_size = 1;  ///< of the largest expression
};

/// Throws InputError for unknown names, wrong numbers of arguments of commands and of symbols that have productions or are
/// terminals, constants that are not finite, unknown numbers of styles.
CompiledGrammar compile(const Grammar& grammar);

}  // namespace rinceau

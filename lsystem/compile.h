#pragma once
// A grammar made ready for derivation: symbols and names as numbers. Internal to the folder.

#include <array>
#include <cstdint>
#include <optional>
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
    int number = 0;    ///< among the symbols of that string, from 1; 0 = a command
    int argument_count = 0;
    bool constant = true;            ///< all arguments are constants, which begin at first_value of CompiledGrammar::values;
    std::vector<Program> arguments;  ///< else these are they
    std::size_t first_value = 0;
    Complex turn{1, 0};  ///< of a constant + or -
    const ModuleTemplate* source = nullptr;
};

using CompiledString = std::vector<CompiledModule>;

/// A symbol with so many parameters that must stand beside the one that is rewritten.
struct CompiledContext {
    Symbol symbol = 0;
    int parameters = 0;
};

struct CompiledProduction {
    Symbol symbol = 0;
    ProductionKind kind = ProductionKind::rewriting;
    int parameters = 0;  ///< of the symbol; behind them programs have the slots of the left context, then of the right
    std::vector<CompiledContext> left_context;   ///< the nearest last
    std::vector<CompiledContext> right_context;  ///< the nearest first
    int context_parameters = 0;                  ///< of both
    bool conditional = false;
    bool weighted = false;
    Program condition;
    Program weight;
    std::uint64_t salt = 0;  ///< of the choice among weighted productions
    CompiledString successor;
};

/// Indices of a symbol's productions, in the grammar's order.
struct ProductionsOfSymbol {
    std::vector<int> rewriting;
    std::vector<int> decomposition;
    std::vector<int> homomorphism;
    std::vector<int>& of(ProductionKind kind) {
        if (kind == ProductionKind::rewriting) return rewriting;
        return kind == ProductionKind::decomposition ? decomposition : homomorphism;
    }
};

/// Refers to the grammar that it was made from, which must outlive it.
struct CompiledGrammar {
    const Grammar* grammar = nullptr;
    StyleTable styles;
    std::vector<double> values;  ///< of constant arguments
    std::vector<std::string> symbols;
    std::vector<ProductionsOfSymbol> productions_of;  ///< by symbol
    std::vector<int> terminal_of;                     ///< symbol -> terminal, -1 = none
    std::vector<CompiledProduction> productions;
    CompiledString axiom;
    std::vector<CompiledString> exceptions;
    ExceptionTree exception_tree;
    int stack_size = 1;         ///< of the largest expression
    DrawKey root = 0;           ///< key of the axiom
    bool random = false;        ///< something is drawn, so that keys are needed
    bool contextual = false;    ///< productions have contexts
    std::vector<bool> ignored;  ///< by symbol: contexts look past it

    /// A terminal, or what a homomorphism may draw: such a module has an address even where it continues its level.
    bool is_drawn(Symbol symbol) const {
        const auto index = static_cast<std::size_t>(symbol);
        return terminal_of[index] >= 0 || !productions_of[index].homomorphism.empty();
    }
};

/// Throws InputError at the module: its arguments are not finite.
[[noreturn]] void throw_not_finite(const CompiledModule& module);

/// `seed` is for random numbers; without one it is the grammar's, without that 1. Throws InputError for unknown names, wrong
/// numbers of arguments of commands and of symbols that have productions or are terminals, constants that are not finite,
/// unknown numbers of styles, exceptions beside contexts.
CompiledGrammar compile(const Grammar& grammar, std::optional<std::uint64_t> seed = {});

}  // namespace rinceau

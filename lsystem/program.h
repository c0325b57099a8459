#pragma once
// Expressions made ready for many evaluations: names are slots, what is constant is folded. Internal to the folder.

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "lsystem/expression.h"

namespace rinceau {

/// Names that an expression may use. Parameters come before constants, constants before pi and e.
struct Scope {
    std::vector<std::string> parameters;  ///< slot numbers are positions
    std::unordered_map<std::string, double> constants;
};

struct Instruction {
    enum class Op : unsigned char { number, slot, unary, binary, call };
    Op op = Op::number;
    Expression::Op operation = Expression::Op::number;  ///< of unary and binary
    int slot = 0;                                       ///< Op::slot; number of arguments of Op::call
    double number = 0;
    double (*function)(std::span<const double>) = nullptr;
};

/// Postfix. A program of one Op::number is a constant.
struct Program {
    std::vector<Instruction> code;
    int stack_size = 0;  ///< numbers that an evaluation holds at most at a time
};

/// Throws InputError at `place` for a name that is not in the scope.
Program compile_expression(const Expression& expression, const Scope& scope, const SourcePlace& place);

constexpr bool is_constant(const Program& program) {
    return program.code.size() == 1 && program.code.front().op == Instruction::Op::number;
}

/// `stack` has room for stack_size numbers. The result may be infinite or not a number.
double evaluate(const Program& program, const double* slots, double* stack);

}  // namespace rinceau

#pragma once
// Expressions made ready for many evaluations: names are slots, what is constant is folded. Internal to lsystem and growth.

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "lsystem/draw_key.h"
#include "lsystem/expression.h"

namespace rinceau {

/// Names that an expression may use. Parameters come before constants, constants before pi and e.
struct Scope {
    std::vector<std::string> parameters;  ///< slot numbers are positions
    std::unordered_map<std::string, double> constants;
};

struct Instruction {
    enum class Op : unsigned char { number, slot, unary, binary, call, draw };
    Op op = Op::number;
    Expression::Op operation = Expression::Op::number;  ///< of unary and binary
    int slot = 0;                                       ///< Op::slot; number of arguments of Op::call; index of Op::draw
    double number = 0;
    double (*function)(std::span<const double>) = nullptr;
};

/// A random number that an expression draws, from two arguments.
struct Draw {
    enum class Distribution : unsigned char { uniform, normal };
    Distribution distribution = Distribution::uniform;
    std::uint64_t salt = 0;  ///< the step below the key of the place where it is drawn
    SourcePlace place;
};

/// Postfix. A program of one Op::number is a constant.
struct Program {
    /// What most programs are: a slot alone, or a slot and a number behind it, in one operation.
    enum class Shape : unsigned char {
        any,
        slot,
        add,
        subtract,
        multiply,
        divide,
        less,
        less_equal,
        greater,
        greater_equal,
        equal
    };
    Shape shape = Shape::any;
    int slot = 0;
    double number = 0;
    std::vector<Instruction> code;
    int stack_size = 0;  ///< numbers that an evaluation holds at most at a time
    std::vector<Draw> draws;
};

/// Throws InputError at `place` for a name that is not in the scope.
Program compile_expression(const Expression& expression, const Scope& scope, const SourcePlace& place);

constexpr bool is_constant(const Program& program) {
    return program.code.size() == 1 && program.code.front().op == Instruction::Op::number;
}

/// Gives the draws of a program salts of their own below `salt`, by their order in the expression.
void salt_draws(Program& program, std::uint64_t salt);

/// `stack` has room for stack_size numbers; draws are made below `key`. The result may be infinite or not a number.
/// Throws InputError for a normal distribution with a negative deviation.
double evaluate_code(const Program& program, const double* slots, double* stack, DrawKey key);

/// The same, for finite slots.
inline double evaluate(const Program& program, const double* slots, double* stack, DrawKey key = 0) {
    using Shape = Program::Shape;
    const double number = program.number;
    switch (program.shape) {
        case Shape::slot:
            return slots[program.slot];
        case Shape::add:
            return slots[program.slot] + number;
        case Shape::subtract:
            return slots[program.slot] - number;
        case Shape::multiply:
            return slots[program.slot] * number;
        case Shape::divide:
            return slots[program.slot] / number;
        case Shape::less:
            return slots[program.slot] < number ? 1 : 0;
        case Shape::less_equal:
            return slots[program.slot] <= number ? 1 : 0;
        case Shape::greater:
            return slots[program.slot] > number ? 1 : 0;
        case Shape::greater_equal:
            return slots[program.slot] >= number ? 1 : 0;
        case Shape::equal:
            return slots[program.slot] == number ? 1 : 0;
        case Shape::any:
            break;
    }
    return evaluate_code(program, slots, stack, key);
}

}  // namespace rinceau

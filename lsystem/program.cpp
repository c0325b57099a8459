#include "lsystem/program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lsystem/expression_functions.h"

namespace rinceau {

namespace {

using Op = Expression::Op;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// A comparison with what is not a number has no value either: it must not pass for "no".
double truth_of(bool holds, double a, double b) {
    return std::isnan(a) || std::isnan(b) ? undefined : static_cast<double>(holds);
}

/// 0 if one of both is 0, whatever the other is.
double conjunction(double a, double b) { return a == 0 || b == 0 ? 0 : truth_of(true, a, b); }

bool holds(double a) { return a != 0 && !std::isnan(a); }

double disjunction(double a, double b) { return holds(a) || holds(b) ? 1 : truth_of(false, a, b); }

double apply_unary(Op operation, double a) { return operation == Op::negate ? -a : truth_of(a == 0, a, a); }

double apply_binary(Op operation, double a, double b) {
    switch (operation) {
        case Op::add:
            return a + b;
        case Op::subtract:
            return a - b;
        case Op::multiply:
            return a * b;
        case Op::divide:
            return a / b;
        case Op::modulo:
            return a - b * std::floor(a / b);
        case Op::power:
            return std::pow(a, b);
        case Op::less:
            return truth_of(a < b, a, b);
        case Op::less_equal:
            return truth_of(a <= b, a, b);
        case Op::greater:
            return truth_of(a > b, a, b);
        case Op::greater_equal:
            return truth_of(a >= b, a, b);
        case Op::equal:
            return truth_of(a == b, a, b);
        case Op::not_equal:
            return truth_of(a != b, a, b);
        case Op::logical_and:
            return conjunction(a, b);
        default:
            return disjunction(a, b);
    }
}

Instruction name_instruction(const std::string& name, const Scope& scope, const SourcePlace& place) {
    const auto parameter = std::ranges::find(scope.parameters, name);
    if (parameter != scope.parameters.end()) {
        return {Instruction::Op::slot, Op::number, static_cast<int>(parameter - scope.parameters.begin())};
    }
    const auto constant = scope.constants.find(name);
    if (constant != scope.constants.end()) return {Instruction::Op::number, Op::number, 0, constant->second};
    const std::optional<double> known = named_constant(name);
    if (known) return {Instruction::Op::number, Op::number, 0, *known};
    throw InputError(place,
                     "expected a parameter or a constant (define " + name + " = ..), found the unknown name '" + name + "'");
}

Instruction compile_node(const Expression::Node& node, const Scope& scope, const SourcePlace& place) {
    switch (node.op) {
        case Op::number:
            return {Instruction::Op::number, Op::number, 0, node.number};
        case Op::name:
            return name_instruction(node.name, scope, place);
        case Op::negate:
        case Op::logical_not:
            return {Instruction::Op::unary, node.op};
        case Op::call: {
            const ExpressionFunction* function = find_expression_function(node.name);
            if (function == nullptr || node.arguments < function->at_least || node.arguments > function->at_most) {
                throw InputError(place, "expected a known function with its number of arguments, found '" + node.name + "'");
            }
            if (function->evaluate == nullptr) {
                throw InputError(place,
                                 "expected a function without chance, found '" + node.name + "', which cannot be drawn");
            }
            return {Instruction::Op::call, Op::call, node.arguments, 0, function->evaluate};
        }
        default:
            return {Instruction::Op::binary, node.op};
    }
}

int operand_count(const Instruction& instruction) {
    switch (instruction.op) {
        case Instruction::Op::unary:
            return 1;
        case Instruction::Op::binary:
            return 2;
        case Instruction::Op::call:
            return instruction.slot;
        default:
            return 0;
    }
}

/// If all operands of the last instruction are constants, its value takes their place.
void fold(Program& program) {
    const auto operands = static_cast<std::size_t>(operand_count(program.code.back()));
    if (operands == 0) return;
    const auto first = program.code.end() - static_cast<std::ptrdiff_t>(operands) - 1;
    const bool constant = std::all_of(first, program.code.end() - 1, [](const Instruction& instruction) {
        return instruction.op == Instruction::Op::number;
    });
    if (!constant) return;
    Program part{{first, program.code.end()}};
    std::vector<double> stack(operands + 1);
    const double value = evaluate(part, nullptr, stack.data());
    program.code.erase(first, program.code.end());
    program.code.push_back({Instruction::Op::number, Op::number, 0, value});
}

}  // namespace

Program compile_expression(const Expression& expression, const Scope& scope, const SourcePlace& place) {
    Program program;
    int height = 0;
    for (const Expression::Node& node : expression.postfix) {
        const Instruction instruction = compile_node(node, scope, place);
        height += 1 - operand_count(instruction);
        if (height < 1) break;
        program.stack_size = std::max(program.stack_size, height);
        program.code.push_back(instruction);
        fold(program);
    }
    if (height != 1) throw InputError(place, "expected an expression, found one that is not whole");
    return program;
}

double evaluate(const Program& program, const double* slots, double* stack) {
    double* top = stack;  // one past the uppermost number
    for (const Instruction& instruction : program.code) {
        switch (instruction.op) {
            case Instruction::Op::number:
                *top++ = instruction.number;
                break;
            case Instruction::Op::slot:
                *top++ = slots[instruction.slot];
                break;
            case Instruction::Op::unary:
                top[-1] = apply_unary(instruction.operation, top[-1]);
                break;
            case Instruction::Op::binary:
                --top;
                top[-1] = apply_binary(instruction.operation, top[-1], *top);
                break;
            case Instruction::Op::call:
                top -= instruction.slot;
                *top = instruction.function({top, static_cast<std::size_t>(instruction.slot)});
                ++top;
                break;
        }
    }
    return stack[0];
}

}  // namespace rinceau

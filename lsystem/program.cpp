#include "lsystem/program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lsystem/expression_functions.h"
#include "lsystem/number_text.h"

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
            if (function == nullptr || !takes(*function, node.arguments)) {
                throw InputError(place, "expected a known function with its number of arguments, found '" + node.name + "'");
            }
            const bool random = function->evaluate == nullptr;
            return {random ? Instruction::Op::draw : Instruction::Op::call, Op::call, node.arguments, 0, function->evaluate};
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
        case Instruction::Op::draw:
            return 2;
        default:
            return 0;
    }
}

/// If all operands of the last instruction are constants, its value takes their place.
void fold(Program& program) {
    if (program.code.back().op == Instruction::Op::draw) return;
    const auto operands = static_cast<std::size_t>(operand_count(program.code.back()));
    if (operands == 0) return;
    const auto first = program.code.end() - static_cast<std::ptrdiff_t>(operands) - 1;
    const bool constant = std::all_of(first, program.code.end() - 1, [](const Instruction& instruction) {
        return instruction.op == Instruction::Op::number;
    });
    if (!constant) return;
    const Program part{.code = {first, program.code.end()}};
    std::vector<double> stack(operands + 1);
    const double value = evaluate(part, nullptr, stack.data());
    program.code.erase(first, program.code.end());
    program.code.push_back({Instruction::Op::number, Op::number, 0, value});
}

void add_draw(Program& program, Instruction& instruction, const Expression::Node& node, const SourcePlace& place) {
    instruction.slot = static_cast<int>(program.draws.size());
    const bool normal = node.name == "normal";
    program.draws.push_back({normal ? Draw::Distribution::normal : Draw::Distribution::uniform, 0, place});
}

Program::Shape shape_of(Op operation) {
    using Shape = Program::Shape;
    switch (operation) {
        case Op::add:
            return Shape::add;
        case Op::subtract:
            return Shape::subtract;
        case Op::multiply:
            return Shape::multiply;
        case Op::divide:
            return Shape::divide;
        case Op::less:
            return Shape::less;
        case Op::less_equal:
            return Shape::less_equal;
        case Op::greater:
            return Shape::greater;
        case Op::greater_equal:
            return Shape::greater_equal;
        case Op::equal:
            return Shape::equal;
        default:
            return Shape::any;
    }
}

/// Comparisons with what is not a number are left to the code.
void find_shape(Program& program) {
    const std::vector<Instruction>& code = program.code;
    if (code.front().op != Instruction::Op::slot) return;
    program.slot = code.front().slot;
    constexpr std::size_t operation_on_two = 3;
    if (code.size() == 1) program.shape = Program::Shape::slot;
    if (code.size() != operation_on_two || code[1].op != Instruction::Op::number || std::isnan(code[1].number)) return;
    if (code[2].op != Instruction::Op::binary) return;
    program.number = code[1].number;
    program.shape = shape_of(code[2].operation);
}

double drawn(const Draw& draw, double a, double b, DrawKey place) {
    const DrawKey key = key_below(place, draw.salt);
    if (draw.distribution == Draw::Distribution::uniform) return a + (b - a) * uniform_draw(key);
    if (b < 0) {
        throw InputError(draw.place,
                         "expected a deviation that is not below 0 in normal(mean, deviation), found " + number_text(b));
    }
    return a + b * normal_draw(key);
}

}  // namespace

Program compile_expression(const Expression& expression, const Scope& scope, const SourcePlace& place) {
    Program program;
    int height = 0;
    for (const Expression::Node& node : expression.postfix) {
        const bool draws_from_unit_interval = node.op == Op::call && node.name == "rand" && node.arguments == 0;
        if (draws_from_unit_interval) {
            for (const double limit : {0.0, 1.0}) program.code.push_back({Instruction::Op::number, Op::number, 0, limit});
            height += 2;
            program.stack_size = std::max(program.stack_size, height);
        }
        Instruction instruction = compile_node(node, scope, place);
        height += 1 - operand_count(instruction);
        if (height < 1) break;
        program.stack_size = std::max(program.stack_size, height);
        if (instruction.op == Instruction::Op::draw) add_draw(program, instruction, node, place);
        program.code.push_back(instruction);
        fold(program);
    }
    if (height != 1) throw InputError(place, "expected an expression, found one that is not whole");
    find_shape(program);
    return program;
}

void salt_draws(Program& program, std::uint64_t salt) {
    for (std::size_t i = 0; i < program.draws.size(); ++i) program.draws[i].salt = key_below(salt, i);
}

double evaluate_code(const Program& program, const double* slots, double* stack, DrawKey key) {
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
            case Instruction::Op::draw:
                --top;
                top[-1] = drawn(program.draws[static_cast<std::size_t>(instruction.slot)], top[-1], *top, key);
                break;
        }
    }
    return stack[0];
}

}  // namespace rinceau

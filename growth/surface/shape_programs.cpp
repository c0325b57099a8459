#include "growth/surface/shape_programs.h"

#include <algorithm>
#include <cmath>

#include "lsystem/expression_functions.h"
#include "lsystem/mistakes.h"
#include "lsystem/similar_name.h"

namespace rinceau {

namespace {

using Op = Expression::Op;

/// By name, so that a param's draws do not depend on the others.
std::uint64_t salt_of_name(const std::string& name) {
    std::uint64_t salt = 0;
    for (const char letter : name) salt = key_below(salt, static_cast<unsigned char>(letter));
    return salt;
}

}  // namespace

ShapeNames::ShapeNames(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting, std::vector<Warning>& mistakes)
    : grammar_(&grammar) {
    scope_.constants = {{"diagonal", setting.diagonal}, {"area", setting.area},    {"edge", setting.mean_edge},
                        {"left", setting.low.x},        {"right", setting.high.x}, {"bottom", setting.low.y},
                        {"top", setting.high.y},        {"back", setting.low.z},   {"front", setting.high.z}};
    for (const ShapeParam& param : grammar.params) {
        double value = 1;
        try {
            value = this->value(param.value, param.place, key_below(root_key(setting.seed), salt_of_name(param.name)));
        } catch (const InputError& error) {
            add_mistake(mistakes, error);
        }
        params_.push_back(value);
        scope_.constants[param.name] = value;
    }
}

void ShapeNames::fail_unknown(const std::string& name, const std::vector<std::string>& parameters,
                              const SourcePlace& place) const {
    std::vector<std::string> known = parameters;
    for (const ShapeParam& param : grammar_->params) known.push_back(param.name);
    const bool later = std::ranges::find(grammar_->params, name, &ShapeParam::name) != grammar_->params.end();
    known.insert(known.end(), {"depth", "diagonal", "area", "edge", "left", "right", "bottom", "top", "back", "front"});
    throw InputError(place, later ? "expected a param that is set before this one, found '" + name + "'"
                                  : "expected a parameter of the rule or a param, found the unknown name '" + name + "'" +
                                        instead_of(name, known));
}

void ShapeNames::expect_known(const Expression& expression, const std::vector<std::string>& parameters, bool with_queries,
                              const SourcePlace& place) const {
    for (const Expression::Node& node : expression.postfix) {
        if (node.op != Op::name || std::ranges::count(parameters, node.name) > 0) continue;
        if (scope_.constants.contains(node.name) || named_constant(node.name)) continue;
        if (!looks_like_query(node.name)) fail_unknown(node.name, parameters, place);
        if (!with_queries)
            throw InputError(place,
                             "expected numbers and params, found '" + node.name + "', which is known at a scope only");
    }
}

ShapeProgram ShapeNames::compile(const Expression& expression, const std::vector<std::string>& parameters,
                                 std::uint64_t salt, const SourcePlace& place) const {
    expect_known(expression, parameters, true, place);
    ShapeProgram result{.parameters = static_cast<int>(parameters.size()), .expression = expression, .place = &place};
    Scope scope = scope_;
    scope.parameters = parameters;
    for (const Expression::Node& node : expression.postfix) {
        const bool known = std::ranges::count(scope.parameters, node.name) > 0 || scope.constants.contains(node.name);
        if (node.op != Op::name || known || !looks_like_query(node.name)) continue;
        result.queries.push_back(parse_shape_query(node.name, *grammar_, place));
        scope.parameters.push_back(node.name);
    }
    result.program = compile_expression(expression, scope, place);
    salt_draws(result.program, salt);
    result.constant = is_constant(result.program);
    if (!result.constant) return result;
    result.value = result.program.code.front().number;
    if (!std::isfinite(result.value))
        throw InputError(place, "expected a finite number, found '" + to_text(expression) + "'");
    return result;
}

double ShapeNames::value(const Expression& expression, const SourcePlace& place, DrawKey key) const {
    expect_known(expression, {}, false, place);
    const Program program = compile_expression(expression, scope_, place);
    std::vector<double> stack(static_cast<std::size_t>(program.stack_size));
    const double value = evaluate(program, nullptr, stack.data(), key);
    if (!std::isfinite(value)) throw InputError(place, "expected a finite number, found '" + to_text(expression) + "'");
    return value;
}

std::vector<double> param_values(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting) {
    std::vector<Warning> mistakes;
    const ShapeNames names(grammar, setting, mistakes);
    if (!mistakes.empty()) throw InputError(mistakes.front().place, mistakes.front().message);
    return names.params();
}

double value_of(const Expression& expression, const ShapeGrammar& grammar, const ShapeGrammarSetting& setting,
                const SourcePlace& place) {
    std::vector<Warning> mistakes;
    return ShapeNames(grammar, setting, mistakes).value(expression, place);
}

}  // namespace rinceau

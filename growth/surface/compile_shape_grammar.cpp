#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "growth/surface/shape_commands.h"
#include "growth/surface/shape_expressions.h"
#include "lsystem/expression_functions.h"
#include "lsystem/mistakes.h"
#include "lsystem/number_text.h"
#include "lsystem/similar_name.h"
#include "scene/svg_color.h"

namespace rinceau {

namespace {

/// What the draws of an expression are for, so that those of different places in a rule differ. Commands follow.
enum class DrawnIn : unsigned char { condition, probability, commands };

std::uint64_t salt_of(std::uint64_t rule, DrawnIn what, std::uint64_t number = 0) {
    return key_below(key_below(rule, static_cast<std::uint64_t>(what)), number);
}

int operands(const Expression::Node& node) {
    switch (node.op) {
        case Expression::Op::number:
        case Expression::Op::name:
            return 0;
        case Expression::Op::negate:
        case Expression::Op::logical_not:
            return 1;
        case Expression::Op::call:
            return node.arguments;
        default:
            return 2;
    }
}

/// a && b && c as its parts. Operands behind a && are searched by recursion, which parentheses alone deepen.
void add_conjuncts(std::span<const Expression::Node> postfix, std::vector<Expression>& parts) {
    std::vector<std::span<const Expression::Node>> behind;  // last ones first
    while (!postfix.empty() && postfix.back().op == Expression::Op::logical_and) {
        std::size_t start = postfix.size() - 1;  // where the second operand begins
        for (int missing = 1; missing > 0 && start > 0;) missing += operands(postfix[--start]) - 1;
        behind.push_back(postfix.subspan(start, postfix.size() - 1 - start));
        postfix = postfix.first(start);
    }
    parts.push_back({{postfix.begin(), postfix.end()}});
    for (auto operand = behind.rbegin(); operand != behind.rend(); ++operand) add_conjuncts(*operand, parts);
}

int index_of(const std::vector<ShapeSource>& sources, const std::string& name) {
    const auto found = std::ranges::find(sources, name, &ShapeSource::name);
    return found == sources.end() ? -1 : static_cast<int>(found - sources.begin());
}

std::vector<std::string> names_of(const std::vector<ShapeSource>& sources) {
    std::vector<std::string> names;
    for (const ShapeSource& source : sources) names.push_back(source.name);
    return names;
}

class ShapeCompiler {
  public:
    ShapeCompiler(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting, std::vector<Warning>& mistakes)
        : grammar_(grammar), mistakes_(mistakes), names_(grammar, setting, mistakes) {
        result_.root = root_key(setting.seed);
    }

    CompiledShapeGrammar compile() {
        add_symbols();
        for (const ShapeRule& rule : grammar_.rules) add_rule(rule);
        parameters_.clear();
        for (const ShapeAxiom& axiom : grammar_.axioms) keeping([&] { add_axiom(axiom); });
        return std::move(result_);
    }

  private:
    const ShapeGrammar& grammar_;
    std::vector<Warning>& mistakes_;
    ShapeNames names_;
    CompiledShapeGrammar result_;
    std::map<std::pair<std::string, std::size_t>, int> symbols_;
    std::vector<std::string> parameters_;  // of the rule at hand
    std::uint64_t salt_ = 0;               // of the rule at hand

    template <class Work>
    void keeping(Work work) {
        try {
            work();
        } catch (const InputError& error) {
            add_mistake(mistakes_, error);
        }
    }

    void add_symbols() {
        for (const ShapeRule& rule : grammar_.rules) {
            const std::pair key(rule.symbol, rule.parameters.size());
            const auto [at, added] = symbols_.try_emplace(key, static_cast<int>(result_.symbols.size()));
            if (added) result_.symbols.push_back({rule.symbol, static_cast<int>(rule.parameters.size()), {}});
            const auto index = static_cast<int>(&rule - grammar_.rules.data());
            result_.symbols[static_cast<std::size_t>(at->second)].rules.push_back(index);
        }
    }

    ShapeProgram program(const Expression& expression, std::uint64_t salt, const SourcePlace& place) {
        ShapeProgram program = names_.compile(expression, parameters_, salt, place);
        const std::size_t slots = parameters_.size() + program.queries.size();
        result_.slots = std::max(result_.slots, static_cast<int>(slots));
        result_.stack_size = std::max(result_.stack_size, program.program.stack_size);
        return program;
    }

    void add_rule(const ShapeRule& rule) {
        CompiledShapeRule compiled{.symbol = symbols_.at({rule.symbol, rule.parameters.size()}),
                                   .parameters = static_cast<int>(rule.parameters.size()),
                                   .condition = {},
                                   .probability = {},
                                   .priority = rule.priority,
                                   .successor = {},
                                   .source = &rule};
        parameters_ = rule.parameters;
        const std::vector<int>& alike = result_.symbols[static_cast<std::size_t>(compiled.symbol)].rules;
        const auto index = static_cast<int>(&rule - grammar_.rules.data());
        salt_ = static_cast<std::uint64_t>(std::ranges::find(alike, index) - alike.begin());
        if (rule.condition) keeping([&] { add_condition(*rule.condition, compiled); });
        if (rule.probability)
            keeping([&] {
                compiled.probability.push_back(program(*rule.probability, salt_of(salt_, DrawnIn::probability), rule.place));
                const ShapeProgram& probability = compiled.probability.back();
                if (probability.constant && probability.value < 0)
                    throw InputError(rule.place, "expected a probability that is not below 0, found '" +
                                                     to_text(*rule.probability) + "'");
            });
        int ordinal = 0;
        compiled.successor = commands(rule.successor, ordinal);
        result_.rules.push_back(std::move(compiled));
    }

    void add_condition(const Expression& condition, CompiledShapeRule& rule) {
        std::vector<Expression> parts;
        add_conjuncts(condition.postfix, parts);
        for (const Expression& part : parts) {
            const std::uint64_t salt = salt_of(salt_, DrawnIn::condition, rule.condition.size());
            rule.condition.push_back(program(part, salt, rule.source->place));
        }
    }

    void add_axiom(const ShapeAxiom& axiom) {
        CompiledShapeAxiom compiled{.where = axiom.where, .numbers = {}, .commands = {}, .source = &axiom};
        for (const Expression& number : axiom.numbers) compiled.numbers.push_back(names_.value(number, axiom.place));
        if (axiom.where == ShapeAxiom::Where::each) {
            compiled.field = index_of(grammar_.fields, axiom.field);
            if (compiled.field < 0)
                throw InputError(axiom.place, "expected a field of this grammar behind 'each', found '" + axiom.field + "'" +
                                                  instead_of(axiom.field, names_of(grammar_.fields)));
        }
        expect_counts(compiled);
        salt_ = 0;
        int ordinal = 0;
        compiled.commands = commands(axiom.commands, ordinal);
        result_.axioms.push_back(std::move(compiled));
    }

    static void expect_counts(const CompiledShapeAxiom& axiom) {
        if (axiom.where != ShapeAxiom::Where::vertex && axiom.where != ShapeAxiom::Where::scatter) return;
        const double number = axiom.numbers.front();
        const bool vertex = axiom.where == ShapeAxiom::Where::vertex;
        constexpr double most_vertices = 1e9;  // as many as could be held; the surface's own are known later
        const double most = vertex ? most_vertices : most_scattered;
        if (number >= 0 && number <= most && number == static_cast<double>(static_cast<long>(number))) return;
        throw InputError(axiom.source->place,
                         std::string("expected ") + (vertex ? "the number of a vertex" : "a number of places") +
                             " from 0 to " + number_text(most) + ", found '" + to_text(axiom.source->numbers.front()) + "'");
    }

    std::vector<CompiledShapeCommand> commands(const std::vector<ShapeCommand>& commands, int& ordinal) {
        std::vector<CompiledShapeCommand> result;
        for (const ShapeCommand& command : commands) keeping([&] { result.push_back(compiled(command, ordinal)); });
        return result;
    }

    CompiledShapeCommand compiled(const ShapeCommand& command, int& ordinal) {
        CompiledShapeCommand result{
            .verb = command.verb, .ordinal = ordinal++, .numbers = {}, .groups = {}, .source = &command};
        for (const auto& group : command.groups) result.groups.push_back(commands(group, ordinal));
        if (command.verb == ShapeVerb::symbol) result.symbol = symbol_of(command);
        if (command.verb == ShapeVerb::place || command.verb == ShapeVerb::place_clear ||
            command.verb == ShapeVerb::place_merged)
            result.shape = shape_of(command);
        expect_arguments(command);
        for (const Expression& argument : command.arguments) {
            const std::uint64_t place = static_cast<std::uint64_t>(result.ordinal) * max_function_arguments;
            const std::uint64_t salt = salt_of(salt_, DrawnIn::commands, place + result.numbers.size());
            result.numbers.push_back(program(argument, salt, command.place));
        }
        if (command.verb == ShapeVerb::colour && command.has_text) read_colour(command, result);
        fill_up(result);
        return result;
    }

    static void expect_arguments(const ShapeCommand& command) {
        if (command.verb == ShapeVerb::symbol || command.verb == ShapeVerb::push || command.verb == ShapeVerb::pop) return;
        if (const auto wrong = wrong_arguments(shape_command(command.verb), command))
            throw InputError(command.place, *wrong);
    }

    int symbol_of(const ShapeCommand& command) const {
        const auto found = symbols_.find({command.name, command.arguments.size()});
        if (found != symbols_.end()) return found->second;
        std::vector<std::string> known;
        for (const ShapeSymbol& symbol : result_.symbols) {
            if (symbol.name == command.name)
                throw InputError(command.place, "expected " + std::to_string(symbol.arguments) + " argument(s) of " +
                                                    symbol.name + ", as in its rule" + line_of(symbol) + ", found " +
                                                    std::to_string(command.arguments.size()));
            known.push_back(symbol.name);
        }
        throw InputError(command.place, "expected a symbol that has a rule, found '" + command.name + "'" +
                                            instead_of(command.name, known));
    }

    std::string line_of(const ShapeSymbol& symbol) const {
        const int line = grammar_.rules[static_cast<std::size_t>(symbol.rules.front())].place.line;
        return line > 0 ? " in line " + std::to_string(line) : std::string();
    }

    int shape_of(const ShapeCommand& command) const {
        const int shape = index_of(grammar_.shapes, command.text);
        if (shape < 0)
            throw InputError(command.place, "expected a shape of this grammar, found '" + command.text + "'" +
                                                instead_of(command.text, names_of(grammar_.shapes)));
        return shape;
    }

    static void read_colour(const ShapeCommand& command, CompiledShapeCommand& result) {
        const std::optional<ParsedColor> colour = parse_color(command.text);
        if (!colour || colour->current)
            throw InputError(command.place, "expected a colour such as \"#c8a060\", found '" + command.text + "'");
        result.has_colour = true;
        result.colour = colour->color;
    }

    /// What may be left out.
    static void fill_up(CompiledShapeCommand& command) {
        const auto constant = [&](double value) {
            command.numbers.push_back({.value = value,
                                       .program = {},
                                       .queries = {},
                                       .expression = number_expression(value),
                                       .place = &command.source->place});
        };
        constexpr double any_angle = 180;
        const ShapeVerb verb = command.verb;
        if (verb == ShapeVerb::move || verb == ShapeVerb::go_straight)
            while (command.numbers.size() < 3) constant(0);
        if (verb == ShapeVerb::size)
            while (command.numbers.size() < 3) command.numbers.push_back(command.numbers.front());
        if (verb == ShapeVerb::place_merged && command.numbers.size() < 2) constant(any_angle);
        if (verb == ShapeVerb::line && command.numbers.empty()) constant(1);
    }
};

}  // namespace

CompiledShapeGrammar compile_shape_grammar(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting,
                                           std::vector<Warning>& mistakes) {
    return ShapeCompiler(grammar, setting, mistakes).compile();
}

CompiledShapeGrammar compile_shape_grammar(const ShapeGrammar& grammar, const ShapeGrammarSetting& setting) {
    std::vector<Warning> mistakes;
    CompiledShapeGrammar compiled = compile_shape_grammar(grammar, setting, mistakes);
    if (!mistakes.empty()) throw InputError(mistakes.front().place, mistakes.front().message);
    return compiled;
}

}  // namespace rinceau

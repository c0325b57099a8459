#include "lsystem/string_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/index.h"
#include "lsystem/approach_roles.h"
#include "lsystem/expression_numbers.h"
#include "lsystem/noise_form.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
constexpr double full_turn = 360;
const std::string normal_help = "standard deviation of the noise";
const std::string uniform_help = "greatest deviation of the noise to either side";

void set_kind(GrammarNumber& number, NumberKind kind) {
    number.kind = kind;
    number.low = -no_limit;
    number.high = no_limit;
    if (kind == NumberKind::angle) {
        number.unit = "degrees";
        number.low = -full_turn;
        number.high = full_turn;
    } else if (kind == NumberKind::scale || kind == NumberKind::count || kind == NumberKind::style_choice) {
        number.low = 0;
    }
    number.whole = kind == NumberKind::count || kind == NumberKind::style_choice || kind == NumberKind::layer;
}

NumberKind kind_of_command(const std::string& symbol) {
    if (symbol == "f") return NumberKind::length;
    if (symbol == "*") return NumberKind::scale;
    if (symbol == ";") return NumberKind::style_choice;
    return symbol == "z" ? NumberKind::layer : NumberKind::angle;
}

std::string stem_of(const std::string& role) { return role.substr(0, role.find('.')); }

/// In words, for the way to `target`; empty = from one to the next.
std::string help_of(const std::string& role, const std::string& target, double sideways_sign) {
    const std::string stem = stem_of(role);
    const bool next = target.empty();
    std::string to = next ? "from one to the next" : "to " + target;
    if (stem == "turn") return next ? to : "before going " + to;
    if (stem == "spin") return "after going " + to;
    if (stem == "forward") return "ahead " + to;
    if (stem == "sideways") return (sideways_sign > 0 ? "leftwards " : "rightwards ") + to;
    if (stem == "scale") return next ? "times as large, each as the one before" : "times as large, " + target;
    if (stem == "style") return "style of " + (next ? "what follows" : target);
    if (stem == "layer") return "layers up, " + (next ? to : target);
    if (stem == "direction") return "of the way " + to + ", with all angles kept";
    if (stem == "rotation") return next ? "in all, " + to : "in all, of " + target;
    return to;
}

class StringNumbers {
  public:
    StringNumbers(const Grammar& grammar, const Scope& constants, const std::vector<RuleLoop>& loops)
        : grammar_(grammar), constants_(constants) {
        for (const RuleLoop& loop : loops)
            for (const LoopUse& use : uses_of(grammar, loop)) counted_.push_back({use, loop.parameter});
    }

    std::vector<GrammarNumber> list() {
        for (const StringPlace& place : strings_of(grammar_)) add_string(place);
        return std::move(result_);
    }

  private:
    struct CountedUse {
        LoopUse use;
        int parameter;
    };
    struct Where {
        StringPlace string;
        Scope scope;
        std::string path;    ///< "Row", "axiom.Row.2"
        std::string target;  ///< symbol that is led to, empty = the rule's own
        NumberRank rank;
        double sideways_sign = -1;
    };
    const Grammar& grammar_;
    const Scope& constants_;
    std::vector<CountedUse> counted_;
    std::vector<GrammarNumber> result_;

    static NumberRank rank_of(const StringPlace& place, bool own) {
        if (place.in == StringPlace::In::axiom) return NumberRank::axiom;
        if (place.in == StringPlace::In::exception) return NumberRank::exception;
        return own ? NumberRank::rule : NumberRank::part;
    }

    void add_string(const StringPlace& place) {
        const auto& string = string_at(grammar_, place);
        const bool is_production = place.in == StringPlace::In::production;
        const std::string own = is_production ? grammar_.productions[at(place.index)].symbol : "";
        const std::string prefix = name_of_string(grammar_, place);
        const Scope scope = constants_in(grammar_, constants_, place);
        for (const Approach& approach : approaches_of(string, own)) {
            Where where{place, scope, prefix, "", rank_of(place, approach.own)};
            if (!approach.own) where.target = string[at(approach.symbol)].symbol;
            if (!approach.own) where.path += '.' + where.target;
            if (approach.of > 1) where.path += '.' + std::to_string(approach.ordinal);
            add_commands(string, approach, where);
            if (approach.symbol >= 0) add_arguments(string[at(approach.symbol)], approach.symbol, where);
        }
    }

    void add_commands(const std::vector<ModuleTemplate>& string, const Approach& approach, Where where) {
        const ApproachRoles roles = roles_of(string, approach, where.scope);
        if (roles.form == StepForm::offset) {
            const auto turn = std::ranges::find(roles.commands, "turn", &CommandRole::role);
            where.sideways_sign = *turn->value;
        }
        for (std::size_t i = 0; i < roles.commands.size(); ++i) {
            const CommandRole& command = roles.commands[i];
            const ModuleTemplate& module = string[at(command.position)];
            const std::size_t before = result_.size();
            const Written written{command.position, 0, static_cast<double>(command.sign)};
            add_expression(module.arguments.front(), written, where, command.role, kind_of_command(module.symbol));
            const bool said_otherwise = roles.form != StepForm::turtle && turn_sign(module) != 0;
            for (std::size_t k = before; k < result_.size() && said_otherwise; ++k)
                if (result_[k].name == where.path + '.' + command.role) result_[k].rank = NumberRank::hidden;
        }
        for (const int position : approach.commands)
            if (const auto noise = find_noise_command(string[at(position)])) add_noise(*noise, position, where);
        add_whole_turns(string, roles, where);
    }

    void add_noise(const FoundNoiseCommand& found, int position, const Where& where) {
        GrammarNumber number;
        const bool angle = found.command.kind == NoiseKind::angle;
        set_kind(number, angle ? NumberKind::angle : NumberKind::scale);
        number.name = where.path + (angle ? ".angle_noise" : ".scale_noise");
        number.help = (found.negative_at >= 0 ? uniform_help : normal_help) + " of each " + where.target;
        number.rank = NumberRank::rule;
        number.value = found.command.noise.spread;
        number.low = 0;
        const auto slot = [&](int at, double slope) {
            return NumberSlot{NumberSlot::In::expression, place_of(where, {position, 0, 1}, at, at + 1), 0, slope, 0};
        };
        // the later one first: writing it moves nothing that stands before it
        number.slots = {slot(found.spread_at, 1)};
        if (found.negative_at >= 0) number.slots.push_back(slot(found.negative_at, -1));
        result_.push_back(std::move(number));
    }

    struct Written {
        int position;
        int argument;
        double sign;
    };

    static ExpressionPlace place_of(const Where& where, const Written& written, int first, int last) {
        return {ExpressionPlace::In::module, 0, where.string, written.position, written.argument, first, last};
    }

    void add_expression(const Expression& expression, const Written& written, const Where& where, const std::string& role,
                        NumberKind kind) {
        for (const NumberInExpression& found : numbers_in(expression, where.scope)) {
            GrammarNumber number;
            number.name = where.path + '.' + role;
            set_kind(number, kind);
            number.help = help_of(role, where.target, where.sideways_sign);
            number.rank = where.rank;
            number.value = written.sign * found.value;
            const ExpressionPlace place = place_of(where, written, found.first, found.last);
            number.slots = {{NumberSlot::In::expression, place, 0, written.sign * found.slope, 0}};
            if (found.part != NumberInExpression::Part::value) describe_part(number, found, written.sign);
            if (found.negative_at >= 0) {
                const ExpressionPlace negative = place_of(where, written, found.negative_at, found.negative_at + 1);
                number.slots.push_back({NumberSlot::In::expression, negative, 0, -1, 0});
            }
            describe_written(grammar_, part_at(grammar_, place), number);
            result_.push_back(std::move(number));
        }
    }

    static void describe_part(GrammarNumber& number, const NumberInExpression& found, double sign) {
        number.whole = false;
        number.low = -no_limit;
        if (found.part == NumberInExpression::Part::change) {
            number.name += "_change";
            number.help = "more for each 1 of " + found.parameter + ": " + number.help;
        } else if (found.part == NumberInExpression::Part::noise) {
            number.name += "_noise";
            number.help = (found.negative_at >= 0 ? uniform_help : normal_help) + ": " + number.help;
            number.rank = NumberRank::rule;
            number.low = 0;
            number.value = sign * number.value;
            number.slots.front().slope = 1;
        } else {
            number.name += ".number" + (found.ordinal > 1 ? std::to_string(found.ordinal) : "");
            number.help = "in an expression: " + number.help;
            number.value = sign * number.value;
            number.slots.front().slope = 1;
            number.rank = NumberRank::detail;
        }
    }

    /// "direction" turns the way and nothing else; "rotation" turns what is at its end.
    void add_whole_turns(const std::vector<ModuleTemplate>& string, const ApproachRoles& roles, const Where& where) {
        if (!roles.rotation || roles.last_turn < 0) return;
        const CommandRole& last = roles.commands[at(roles.last_turn)];
        const bool last_is_expression = find_noise_or_name(string[at(last.position)].arguments.front());
        if (last_is_expression) return;
        const double rotation = *roles.rotation;
        GrammarNumber number;
        set_kind(number, NumberKind::angle);
        const auto slot = [&](const CommandRole& command, double slope, double offset) {
            const Expression& written = string[at(command.position)].arguments.front();
            const ExpressionPlace place =
                place_of(where, {command.position, 0, 1}, 0, static_cast<int>(written.postfix.size()));
            return NumberSlot{NumberSlot::In::expression, place, 0, command.sign * slope, command.sign * offset};
        };
        if (roles.first_turn >= 0) {
            const CommandRole& first = roles.commands[at(roles.first_turn)];
            if (find_noise_or_name(string[at(first.position)].arguments.front())) return;
            number.name = where.path + ".direction";
            number.help = help_of("direction", where.target, 0);
            number.value = *first.value;
            number.rank = roles.form == StepForm::framed ? where.rank : NumberRank::hidden;
            number.slots = {slot(first, 1, 0), slot(last, -1, rotation)};
            result_.push_back(number);
        }
        if (roles.first_turn < 0 && roles.form == StepForm::turtle) return;
        number.name = where.path + ".rotation";
        number.help = help_of("rotation", where.target, 0);
        number.value = rotation;
        const bool listed = roles.form == StepForm::offset && (rotation != 0 || where.rank == NumberRank::rule);
        number.rank = listed ? where.rank : NumberRank::hidden;
        number.slots = {slot(last, 1, *last.value - rotation)};
        result_.push_back(number);
    }
    static bool find_noise_or_name(const Expression& expression) { return !is_plain_number(expression); }

    void add_arguments(const ModuleTemplate& module, int position, const Where& where) {
        const auto production = std::ranges::find_if(grammar_.productions, [&](const Production& candidate) {
            return candidate.symbol == module.symbol && candidate.parameters.size() == module.arguments.size();
        });
        const bool known = production != grammar_.productions.end();
        for (std::size_t i = 0; i < module.arguments.size(); ++i) {
            const int argument = static_cast<int>(i);
            if (is_count(where.string, position, argument)) continue;
            if (where.target.empty() && is_step(module.arguments[i])) continue;
            std::string role = known ? production->parameters[i] : "argument";
            if (!known && i > 0) role += std::to_string(i + 1);
            Where here = where;
            here.rank = where.rank == NumberRank::rule ? NumberRank::part : where.rank;
            const std::size_t before = result_.size();
            add_expression(module.arguments[i], {position, argument, 1}, here, role, NumberKind::other);
            for (std::size_t k = before; k < result_.size(); ++k) result_[k].help = "of " + module.symbol;
        }
    }
    bool is_count(const StringPlace& string, int position, int argument) const {
        return std::ranges::any_of(counted_, [&](const CountedUse& counted) {
            return counted.use.string == string && counted.use.position == position && counted.parameter == argument &&
                   counted.use.count && counted.use.written.in == ExpressionPlace::In::module;
        });
    }
    /// m - 1: how a rule counts, nothing to set.
    static bool is_step(const Expression& argument) {
        return argument.postfix.size() == 3 && argument.postfix[0].op == Expression::Op::name &&
               (argument.postfix[2].op == Expression::Op::subtract || argument.postfix[2].op == Expression::Op::add) &&
               argument.postfix[1].op == Expression::Op::number && argument.postfix[1].number == 1;
    }
};

}  // namespace

void describe_written(const Grammar& grammar, const Expression& expression, GrammarNumber& number) {
    if (is_plain_number(expression)) return;
    number.written = to_text(expression);
    number.constant = constant_behind(grammar, expression);
    if (number.constant < 0 || number.slots.size() != 1) return;
    NumberSlot& slot = number.slots.front();
    number.alias = slot.place;
    const Expression& value = grammar.constants[at(number.constant)].value;
    slot.place = {ExpressionPlace::In::constant, number.constant, {}, 0, 0, 0, static_cast<int>(value.postfix.size())};
    number.rank = NumberRank::hidden;
}

std::string name_of_string(const Grammar& grammar, const StringPlace& place) {
    if (place.in == StringPlace::In::axiom) return "axiom";
    if (place.in == StringPlace::In::exception) {
        std::string name = "except";
        for (const int number : grammar.exceptions[at(place.index)].address) name += '.' + std::to_string(number);
        return name;
    }
    const std::string& symbol = grammar.productions[at(place.index)].symbol;
    int before = 0;
    for (int i = 0; i < place.index; ++i) before += grammar.productions[at(i)].symbol == symbol;
    return before == 0 ? symbol : symbol + ".case" + std::to_string(before + 1);
}

std::vector<GrammarNumber> string_numbers(const Grammar& grammar, const Scope& constants,
                                          const std::vector<RuleLoop>& loops) {
    return StringNumbers(grammar, constants, loops).list();
}

}  // namespace rinceau

#include "lsystem/randomize.h"

#include <algorithm>
#include <map>
#include <set>

#include "lsystem/noise_plan.h"
#include "lsystem/number_slots.h"
#include "lsystem/numbers.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

using String = std::vector<ModuleTemplate>;
using How = NoisePlace::How;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// By kind: the standard deviation, if one is given.
using Deviations = std::map<NoiseKind, double>;

Deviations deviations_of(const RandomizeOptions& options) {
    Deviations result;
    const auto take = [&](NoiseKind kind, const std::optional<double>& deviation, const char* name) {
        if (!deviation) return;
        if (!(*deviation >= 0))
            throw InputError(
                {}, std::string("expected a standard deviation of ") + name + " from 0 up, found " + short_text(*deviation));
        result[kind] = *deviation;
    };
    take(NoiseKind::angle, options.angle, "angles");
    take(NoiseKind::distance, options.distance, "distances");
    take(NoiseKind::scale, options.scale, "scales");
    return result;
}

/// Every kind of noise that stands behind the expression and is to be taken away; other noise behind it stays.
Expression stripped(const Expression& expression, const Deviations& kinds) {
    const auto noise = find_noise(expression);
    if (!noise) return expression;
    Expression base = expression;
    base.postfix.resize(at(noise->base_size));
    base = stripped(base, kinds);
    return kinds.contains(noise->kind) ? base : with_noise(base, noise->kind, noise->deviation);
}

/// [A] becomes A where the brackets came with noise that is gone: `open` is the place of the bracket.
bool holds_one_symbol(const String& string, std::size_t open) {
    return open + 2 < string.size() && string[open].symbol == "[" &&
           find_turtle_command(string[open + 1].symbol) == nullptr && string[open + 2].symbol == "]";
}

String stripped(const String& string, const Deviations& kinds) {
    String result;
    std::set<std::size_t> brackets;  // that came with noise
    for (const ModuleTemplate& module : string) {
        const auto noise = find_noise_command(module);
        if (noise && kinds.contains(noise->kind)) {
            if (noise->bracketed && !result.empty() && result.back().symbol == "[") brackets.insert(result.size() - 1);
            continue;
        }
        result.push_back(module);
        for (Expression& argument : result.back().arguments) argument = stripped(argument, kinds);
    }
    for (auto open = brackets.rbegin(); open != brackets.rend(); ++open) {
        if (!holds_one_symbol(result, *open)) continue;
        const auto first = result.begin() + static_cast<std::ptrdiff_t>(*open);
        result.erase(first + 2);
        result.erase(first);
    }
    return result;
}

Grammar stripped(Grammar grammar, const Deviations& kinds) {
    for (const StringPlace& place : strings_of(grammar))
        string_at(grammar, place) = stripped(string_at(grammar, place), kinds);
    return grammar;
}

void put_on(Expression& expression, NoiseKind kind, double deviation) {
    if (deviation > 0) expression = with_noise(expression, kind, deviation);
}

/// All noise at one position of a string; `string` is changed from there on only.
void add_at(String& string, int position, const std::vector<const NoisePlace*>& places, const Deviations& deviations) {
    String commands;
    bool bracketed = false;
    for (const NoisePlace* place : places) {
        const double deviation = deviations.at(place->kind);
        if (place->how == How::in_expression) {
            put_on(string[at(position)].arguments[at(place->argument)], place->kind, deviation);
        } else if (deviation > 0) {
            bracketed = bracketed || place->how == How::bracketed;
            commands.push_back(noise_command({place->kind, deviation, place->how == How::bracketed}));
        }
    }
    if (commands.empty()) return;
    if (bracketed) {
        commands.insert(commands.begin(), {"[", {}, {}});
        string.insert(string.begin() + position + 1, {"]", {}, {}});
    }
    string.insert(string.begin() + position, commands.begin(), commands.end());
}

Grammar with_noise_at(Grammar grammar, const std::vector<NoisePlace>& places, const Deviations& deviations) {
    for (const StringPlace& string : strings_of(grammar)) {
        std::map<int, std::vector<const NoisePlace*>, std::greater<>> by_position;
        for (const NoisePlace& place : places)
            if (place.string == string && deviations.contains(place.kind)) by_position[place.position].push_back(&place);
        for (const auto& [position, here] : by_position) add_at(string_at(grammar, string), position, here, deviations);
    }
    return grammar;
}

std::optional<NoiseKind> noise_kind(NumberKind kind) {
    if (kind == NumberKind::angle) return NoiseKind::angle;
    if (kind == NumberKind::length || kind == NumberKind::other) return NoiseKind::distance;
    if (kind == NumberKind::scale) return NoiseKind::scale;
    return {};
}

/// Arguments of modules by the names of their numbers.
std::vector<ExpressionPlace> named_places(const Grammar& grammar, const std::string& name, const Deviations& deviations) {
    const std::vector<GrammarNumber> numbers = grammar_numbers(grammar);
    const bool pattern = name.find('*') != std::string::npos;
    std::vector<ExpressionPlace> places;
    for (const GrammarNumber& number : numbers) {
        if (pattern ? !fits_name(name, number.name) : number.name != name) continue;
        const auto kind = noise_kind(number.kind);
        if (!kind || !deviations.contains(*kind) || number.slots.size() != 1 || number.name.ends_with("_noise")) continue;
        ExpressionPlace place = number.alias ? *number.alias : number.slots.front().place;
        if (number.slots.front().in != NumberSlot::In::expression || place.in != ExpressionPlace::In::module) continue;
        const bool again =
            std::ranges::any_of(places, [&](const ExpressionPlace& other) { return same_expression(other, place); });
        if (!again) places.push_back(place);
    }
    if (places.empty())
        throw InputError({}, "expected the name of an angle, a distance or a scale that noise is given for, found '" + name +
                                 "': 'rinceau set' lists the names");
    return places;
}

NoiseKind kind_at(const Grammar& grammar, const ExpressionPlace& place) {
    const std::string& symbol = string_at(grammar, place.string)[at(place.position)].symbol;
    if (symbol == "+" || symbol == "-") return NoiseKind::angle;
    return symbol == "*" ? NoiseKind::scale : NoiseKind::distance;
}

Grammar randomize_only(Grammar grammar, const std::vector<std::string>& names, const Deviations& deviations) {
    for (const std::string& name : names) {
        for (const ExpressionPlace& place : named_places(grammar, name, deviations)) {
            const NoiseKind kind = kind_at(grammar, place);
            const auto deviation = deviations.find(kind);
            if (deviation == deviations.end()) continue;
            Expression& expression = expression_at(grammar, place);
            expression = stripped(expression, {*deviation});
            put_on(expression, kind, deviation->second);
        }
    }
    return grammar;
}

/// "noise: Ring.Motif.angle_noise 5, Tree.1.spin_noise 5".
std::vector<std::string> changes_between(const Grammar& before, const Grammar& after) {
    constexpr std::size_t most_named = 8;
    const auto noise_of = [](const Grammar& grammar) {
        std::map<std::string, double> result;
        for (const GrammarNumber& number : grammar_numbers(grammar))
            if (number.name.find("_noise") != std::string::npos) result[number.name] = number.value;
        return result;
    };
    const auto listed = [&](const std::vector<std::string>& names) {
        std::string text;
        for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i) text += (i > 0 ? ", " : "") + names[i];
        if (names.size() > most_named) text += " and " + std::to_string(names.size() - most_named) + " more";
        return text;
    };
    const auto old = noise_of(before);
    const auto now = noise_of(after);
    std::vector<std::string> put;
    std::vector<std::string> taken;
    for (const auto& [name, deviation] : now) {
        const auto was = old.find(name);
        if (was == old.end())
            put.push_back(name + ' ' + short_text(deviation));
        else if (was->second != deviation)
            put.push_back(name + ' ' + short_text(was->second) + " -> " + short_text(deviation));
    }
    for (const auto& [name, deviation] : old)
        if (!now.contains(name)) taken.push_back(name);
    std::vector<std::string> changes;
    if (!put.empty()) changes.push_back("noise: " + listed(put));
    if (!taken.empty()) changes.push_back("noise taken away: " + listed(taken));
    return changes;
}

}  // namespace

Grammar without_noise(const Grammar& grammar) {
    return stripped(grammar, {{NoiseKind::angle, 0}, {NoiseKind::distance, 0}, {NoiseKind::scale, 0}});
}

EditResult randomize(const Grammar& grammar, const RandomizeOptions& options) {
    const Deviations deviations = deviations_of(options);
    EditResult result{grammar, {}};
    if (!options.only.empty()) {
        result.grammar = randomize_only(grammar, options.only, deviations);
    } else {
        const std::vector<NoisePlace> places = noise_places(without_noise(grammar));
        const bool all = deviations.size() == 3;
        // Noise of other kinds shifts positions: it is put back with the rest.
        Deviations kept = deviations;
        result.grammar = all ? with_noise_at(without_noise(grammar), places, kept) : grammar;
        if (!all) {
            result.grammar = stripped(grammar, deviations);
            result.grammar = with_noise_at(result.grammar, noise_places(result.grammar), deviations);
        }
    }
    result.changes = changes_between(grammar, result.grammar);
    if (options.seed && options.seed != grammar.seed) {
        result.grammar.seed = options.seed;
        result.changes.push_back("seed " + (grammar.seed ? std::to_string(*grammar.seed) + " -> " : std::string()) +
                                 std::to_string(*options.seed));
    }
    return result;
}

}  // namespace rinceau

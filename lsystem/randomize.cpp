#include "lsystem/randomize.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "geometry/index.h"
#include "lsystem/noise_plan.h"
#include "lsystem/number_slots.h"
#include "lsystem/numbers.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

using String = std::vector<ModuleTemplate>;
using How = NoisePlace::How;

/// By kind: the noise, if one is given.
using Noises = std::map<NoiseKind, Noise>;

void expect_spread(double spread, const std::string& name) {
    if (spread >= 0) return;
    throw InputError({}, "expected a spread of " + name + " from 0 up, found " + short_text(spread));
}

Noises noises_of(const RandomizeOptions& options) {
    Noises result;
    const auto take = [&](NoiseKind kind, const std::optional<double>& spread, NoiseDistribution distribution,
                          const char* name) {
        if (!spread) return;
        expect_spread(*spread, name);
        result[kind] = {distribution, *spread};
    };
    take(NoiseKind::angle, options.angle, options.angle_distribution, "angles");
    take(NoiseKind::distance, options.distance, options.distance_distribution, "distances");
    take(NoiseKind::scale, options.scale, options.scale_distribution, "scales");
    return result;
}

/// The expression without noise of this kind; other noise behind it stays.
Expression stripped(const Expression& expression, NoiseKind kind) {
    const auto noise = find_noise(expression);
    if (!noise) return expression;
    Expression base = expression;
    base.postfix.resize(at(noise->base_size));
    base = stripped(base, kind);
    return noise->kind == kind ? base : with_noise(base, noise->kind, noise->noise);
}

/// Noise with the place where it stood, in the grammar without noise.
struct PlacedNoise {
    NoisePlace place;
    Noise noise;
};

/// One string without noise, and the noise that it had.
class Stripper {
  public:
    explicit Stripper(const StringPlace& place) : place_(place) {}

    String strip(const String& string) {
        String result;
        for (const ModuleTemplate& module : string) {
            const int position = static_cast<int>(result.size());
            if (const auto found = find_noise_command(module)) {
                const NoiseCommand& noise = found->command;
                if (noise.bracketed && !result.empty() && result.back().symbol == "[") brackets_.insert(position - 1);
                const auto how = noise.bracketed ? How::bracketed : How::before;
                found_noise.push_back({{noise.kind, how, place_, position, 0}, noise.noise});
                continue;
            }
            result.push_back(module);
            for (std::size_t i = 0; i < module.arguments.size(); ++i) strip_argument(result.back(), position, i);
        }
        unwrap(result);
        return result;
    }
    std::vector<PlacedNoise> found_noise;

  private:
    StringPlace place_;
    std::set<int> brackets_;  ///< that came with noise

    void strip_argument(ModuleTemplate& module, int position, std::size_t index) {
        Expression& argument = module.arguments[index];
        while (const auto found = find_noise(argument)) {
            found_noise.push_back({{found->kind, How::in_expression, place_, position, static_cast<int>(index)}, found->noise});
            argument.postfix.resize(at(found->base_size));
        }
    }

    /// [A] becomes A where the brackets came with noise.
    void unwrap(String& string) {
        for (auto open = brackets_.rbegin(); open != brackets_.rend(); ++open) {
            if (at(*open) + 2 >= string.size() || find_turtle_command(string[at(*open) + 1].symbol) != nullptr) continue;
            if (string[at(*open) + 2].symbol != "]") continue;
            string.erase(string.begin() + *open + 2);
            string.erase(string.begin() + *open);
            for (PlacedNoise& noise : found_noise) {
                int& position = noise.place.position;
                if (position > *open + 2) --position;
                if (position > *open) --position;
            }
        }
    }
};

struct StrippedGrammar {
    Grammar grammar;
    std::vector<PlacedNoise> noise;
};

StrippedGrammar stripped(const Grammar& grammar) {
    StrippedGrammar result{grammar, {}};
    for (const StringPlace& place : strings_of(grammar)) {
        Stripper stripper(place);
        string_at(result.grammar, place) = stripper.strip(string_at(grammar, place));
        result.noise.insert(result.noise.end(), stripper.found_noise.begin(), stripper.found_noise.end());
    }
    return result;
}

void put_on(Expression& expression, NoiseKind kind, const Noise& noise) {
    if (noise.spread > 0) expression = with_noise(expression, kind, noise);
}

/// All noise at one position of a string; `string` is changed from there on only.
void add_at(String& string, int position, std::vector<const PlacedNoise*> noise) {
    std::ranges::stable_sort(noise, {}, [](const PlacedNoise* one) { return one->place.kind; });
    String commands;
    bool bracketed = false;
    for (const PlacedNoise* one : noise) {
        if (one->place.how == How::in_expression) {
            put_on(string[at(position)].arguments[at(one->place.argument)], one->place.kind, one->noise);
        } else {
            bracketed = bracketed || one->place.how == How::bracketed;
            commands.push_back(noise_command({one->place.kind, one->noise, one->place.how == How::bracketed}));
        }
    }
    if (commands.empty()) return;
    if (bracketed) {
        commands.insert(commands.begin(), {"[", {}, {}});
        string.insert(string.begin() + position + 1, {"]", {}, {}});
    }
    string.insert(string.begin() + position, commands.begin(), commands.end());
}

Grammar with_noise_at(Grammar grammar, const std::vector<PlacedNoise>& noise) {
    std::map<std::pair<StringPlace::In, int>, std::map<int, std::vector<const PlacedNoise*>, std::greater<>>> by_string;
    for (const PlacedNoise& one : noise) {
        const StringPlace& string = one.place.string;
        if (one.noise.spread > 0) by_string[{string.in, string.index}][one.place.position].push_back(&one);
    }
    for (const auto& [string, by_position] : by_string)
        for (const auto& [position, here] : by_position)
            add_at(string_at(grammar, {string.first, string.second}), position, here);
    return grammar;
}

/// Noise of the given kinds where the plan has it; of others where it was.
Grammar randomize_planned(const Grammar& grammar, const Noises& noises) {
    if (noises.empty()) return grammar;
    StrippedGrammar plain = stripped(grammar);
    std::erase_if(plain.noise, [&](const PlacedNoise& one) { return noises.contains(one.place.kind); });
    for (const NoisePlace& place : noise_places(plain.grammar)) {
        const auto noise = noises.find(place.kind);
        if (noise != noises.end()) plain.noise.push_back({place, noise->second});
    }
    return with_noise_at(std::move(plain.grammar), plain.noise);
}

std::optional<NoiseKind> noise_kind(NumberKind kind) {
    if (kind == NumberKind::angle) return NoiseKind::angle;
    if (kind == NumberKind::length || kind == NumberKind::other) return NoiseKind::distance;
    if (kind == NumberKind::scale) return NoiseKind::scale;
    return {};
}

/// The argument of a module that is the number, or holds it.
std::optional<ExpressionPlace> argument_of(const GrammarNumber& number) {
    if (number.slots.size() != 1 || number.slots.front().in != NumberSlot::In::expression) return {};
    ExpressionPlace place = number.alias ? *number.alias : number.slots.front().place;
    if (place.in != ExpressionPlace::In::module) return {};
    return place;
}

/// Arguments of modules by the names of their numbers, of the kinds that `wanted` has.
std::vector<ExpressionPlace> named_places(const Grammar& grammar, const std::string& name,
                                          const std::function<bool(NoiseKind)>& wanted) {
    const bool pattern = name.find('*') != std::string::npos;
    std::vector<ExpressionPlace> places;
    for (const GrammarNumber& number : grammar_numbers(grammar)) {
        if (pattern ? !fits_name(name, number.name) : number.name != name) continue;
        if (!takes_noise(number) || !wanted(*noise_kind(number.kind))) continue;
        const ExpressionPlace place = *argument_of(number);
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

void put_at(Grammar& grammar, const ExpressionPlace& place, NoiseKind kind, const Noise& noise) {
    Expression& expression = expression_at(grammar, place);
    expression = stripped(expression, kind);
    put_on(expression, kind, noise);
}

Grammar randomize_only(Grammar grammar, const RandomizeOptions& options, const Noises& noises) {
    for (const std::string& name : options.only) {
        for (const ExpressionPlace& place :
             named_places(grammar, name, [&](NoiseKind kind) { return noises.contains(kind); })) {
            const NoiseKind kind = kind_at(grammar, place);
            const auto noise = noises.find(kind);
            if (noise == noises.end()) continue;
            put_at(grammar, place, kind, noise->second);
        }
    }
    return grammar;
}

Grammar randomize_named(Grammar grammar, const RandomizeOptions& options) {
    if (options.named.empty()) return grammar;
    for (const auto& [name, noise] : options.named) {
        expect_spread(noise.spread, name);
        for (const ExpressionPlace& place : named_places(grammar, name, [](NoiseKind) { return true; }))
            put_at(grammar, place, kind_at(grammar, place), noise);
    }
    return grammar;
}

/// "noise: Ring.Motif.angle_noise 5, Tree.1.spin_noise 5".
std::vector<std::string> changes_between(const Grammar& before, const Grammar& after) {
    constexpr std::size_t most_named = 8;
    const auto noise_of = [](const Grammar& grammar) {
        std::map<std::string, std::string> result;
        for (const GrammarNumber& number : grammar_numbers(grammar)) {
            if (number.name.find("_noise") == std::string::npos) continue;
            const bool uniform = number.slots.size() > 1;  // uniform(-s, s)
            result[number.name] = (uniform ? "uniform " : "") + short_text(number.value);
        }
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
    for (const auto& [name, spread] : now) {
        const auto was = old.find(name);
        if (was == old.end())
            put.push_back(name + ' ' + spread);
        else if (was->second != spread)
            put.push_back(name + ' ' + was->second + " -> " + spread);
    }
    for (const auto& [name, spread] : old)
        if (!now.contains(name)) taken.push_back(name);
    std::vector<std::string> changes;
    if (!put.empty()) changes.push_back("noise: " + listed(put));
    if (!taken.empty()) changes.push_back("noise taken away: " + listed(taken));
    return changes;
}

}  // namespace

Grammar without_noise(const Grammar& grammar) { return stripped(grammar).grammar; }

bool takes_noise(const GrammarNumber& number) {
    return noise_kind(number.kind) && !number.name.ends_with("_noise") && argument_of(number);
}

std::optional<Noise> noise_on(const Grammar& grammar, const GrammarNumber& number) {
    const auto place = argument_of(number);
    if (!place) return {};
    const auto found = find_noise(expression_at(grammar, *place));
    return found ? std::optional(found->noise) : std::nullopt;
}

NoiseInGrammar noise_in(const Grammar& grammar) {
    NoiseInGrammar result;
    const auto take = [&](NoiseKind kind, const Noise& noise) {
        std::optional<Noise>& known = kind == NoiseKind::angle      ? result.angle
                                      : kind == NoiseKind::distance ? result.distance
                                                                    : result.scale;
        if (!known || known->spread < noise.spread) known = noise;
    };
    for (const StringPlace& string : strings_of(grammar)) {
        for (const ModuleTemplate& module : string_at(grammar, string)) {
            if (const auto command = find_noise_command(module)) take(command->command.kind, command->command.noise);
            for (const Expression& argument : module.arguments)
                if (const auto found = find_noise(argument)) take(found->kind, found->noise);
        }
    }
    return result;
}

EditResult randomize(const Grammar& grammar, const RandomizeOptions& options) {
    const Noises noises = noises_of(options);
    EditResult result{options.only.empty() ? randomize_planned(grammar, noises) : randomize_only(grammar, options, noises),
                      {}};
    result.grammar = randomize_named(std::move(result.grammar), options);
    result.changes = changes_between(grammar, result.grammar);
    if (options.seed && options.seed != grammar.seed) {
        result.grammar.seed = options.seed;
        result.changes.push_back("seed " + (grammar.seed ? std::to_string(*grammar.seed) + " -> " : std::string()) +
                                 std::to_string(*options.seed));
    }
    return result;
}

}  // namespace rinceau

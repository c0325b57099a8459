#include "lsystem/edit_ring.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "geometry/angle.h"
#include "geometry/index.h"
#include "lsystem/constant_values.h"
#include "lsystem/fit_box.h"
#include "lsystem/measure_symbol.h"
#include "lsystem/number_slots.h"
#include "lsystem/number_text.h"
#include "lsystem/ring.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {
namespace {

constexpr double full_circle = 360;
constexpr double quarter = 90;

bool is_command(const ModuleTemplate& module) { return find_turtle_command(module.symbol) != nullptr; }

bool is_motion(const ModuleTemplate& module) {
    return module.symbol == "+" || module.symbol == "-" || module.symbol == "f" || module.symbol == "*";
}

ModuleTemplate command(const char* symbol, double value) { return {symbol, {number_expression(value)}, {}}; }

void append(ModuleTemplates& string, const ModuleTemplates& more) { string.insert(string.end(), more.begin(), more.end()); }

/// The rule of one row or ring, with all of its uses.
struct RowRule {
    RuleLoop loop;
    std::vector<LoopUse> uses;
    double elements = 0;
    std::optional<Similarity> step;  ///< from one to the next, if it is made of numbers
};

[[noreturn]] void refuse(const Production& production, const std::string& expected) {
    throw InputError(production.place, "expected " + expected + " of " + production.symbol);
}

std::optional<Similarity> step_of(const Grammar& grammar, const RuleLoop& loop) {
    const ModuleTemplates& string = grammar.productions[at(loop.production)].successor;
    ModuleTemplates way;
    for (const int position : way_to(string, loop.continuations.front().symbol)) way.push_back(string[at(position)]);
    try {
        return measure(grammar, way).move;
    } catch (const InputError&) {  // it depends on parameters
        return {};
    }
}

RowRule row_rule(const Grammar& grammar, const std::string& symbol) {
    RowRule rule;
    for (RuleLoop& loop : rule_loops(grammar))
        if (grammar.productions[at(loop.production)].symbol == symbol) rule.loop = std::move(loop);
    if (rule.loop.continuations.empty())
        throw InputError(
            {}, "expected a symbol whose rule repeats itself, such as P(m) : m > 0 -> A f(10) P(m-1), found " + symbol);
    const Production& production = grammar.productions[at(rule.loop.production)];
    if (rule.loop.continuations.size() != 1) refuse(production, "one continuation, not several branches,");
    const ModuleTemplates& string = production.successor;
    int depth = 0;
    for (std::size_t i = 0; i < string.size(); ++i) {
        const bool behind = static_cast<int>(i) > rule.loop.continuations.front().symbol;
        depth += (string[i].symbol == "[") - (string[i].symbol == "]");
        const bool own = static_cast<int>(i) == rule.loop.continuations.front().symbol;
        if (own && depth > 0) refuse(production, "a continuation without brackets about it");
        if (behind && !is_command(string[i])) refuse(production, "nothing behind the continuation");
    }
    rule.uses = uses_of(grammar, rule.loop);
    if (rule.uses.empty()) refuse(production, "a use");
    for (const LoopUse& use : rule.uses) {
        if (!use.count) refuse(production, "a number for the count");
        if (*use.count != *rule.uses.front().count) refuse(production, "the same count in all uses");
    }
    rule.elements = elements_of(rule.loop, rule.uses.front());
    constexpr double fewest = 2;
    constexpr double most = 1e6;
    if (rule.elements < fewest || rule.elements > most) refuse(production, "2 to 1000000 elements");
    rule.step = step_of(grammar, rule.loop);
    return rule;
}

/// What a rule draws each time, without brackets about the whole, and the paints that are chosen before and behind it.
struct RowParts {
    ModuleTemplates before;
    ModuleTemplates element;
    ModuleTemplates behind;
    ModuleTemplates rest;  ///< the continuation, and what follows
};

RowParts parts_of(const Production& production, int own) {
    const ModuleTemplates& string = production.successor;
    int depth = 0;
    int first = -1;
    int last = -1;
    for (int i = 0; i < own; ++i) {
        const ModuleTemplate& module = string[at(i)];
        if (depth == 0 && module.symbol == "|") refuse(production, "no mirror on the way");
        if (depth == 0 && first < 0 && (module.symbol == "[" || !is_command(module))) first = i;
        depth += (module.symbol == "[") - (module.symbol == "]");
        if (depth == 0 && (module.symbol == "]" || !is_command(module))) last = i;
    }
    if (first < 0) refuse(production, "something that is drawn each time");
    RowParts parts;
    for (int i = 0; i < first; ++i)
        if (!is_motion(string[at(i)])) parts.before.push_back(string[at(i)]);
    for (int i = last + 1; i < own; ++i)
        if (!is_motion(string[at(i)])) parts.behind.push_back(string[at(i)]);
    parts.element.assign(string.begin() + first, string.begin() + last + 1);
    parts.rest.assign(string.begin() + own, string.end());
    return parts;
}

/// [A B] is A B; [A] [B] stays.
ModuleTemplates without_brackets(ModuleTemplates string) {
    if (string.size() < 2 || string.front().symbol != "[") return string;
    int depth = 0;
    for (std::size_t i = 0; i + 1 < string.size(); ++i) {
        depth += (string[i].symbol == "[") - (string[i].symbol == "]");
        if (depth == 0) return string;
    }
    return {string.begin() + 1, string.end() - 1};
}

ModuleTemplates bracketed(const ModuleTemplates& first, const ModuleTemplates& then) {
    ModuleTemplates result{{"[", {}, {}}};
    append(result, first);
    append(result, then);
    result.push_back({"]", {}, {}});
    return result;
}

/// The element on the rim: its place along the radius is the first way ahead.
ModuleTemplates on_rim(const ModuleTemplates& element, double radius) {
    return bracketed({command("f", radius)}, without_brackets(element));
}

/// The first way ahead, if nothing but turns, scales and noise stand before it.
std::optional<std::size_t> radius_in(const ModuleTemplates& element) {
    for (std::size_t i = 0; i < element.size(); ++i) {
        if (element[i].symbol == "f") return i;
        if (!is_motion(element[i])) return {};
    }
    return {};
}

/// Every use begins `way` off, and what follows it finds the turtle where it was before.
void move_uses(Grammar& grammar, const std::vector<LoopUse>& uses, const ModuleTemplates& way) {
    if (way.empty()) return;
    std::vector<LoopUse> last_first = uses;
    std::ranges::sort(last_first, std::greater<>{}, &LoopUse::position);
    for (const LoopUse& use : last_first) {
        ModuleTemplates& string = string_at(grammar, use.string);
        const ModuleTemplates moved = bracketed(way, {string[at(use.position)]});
        string.erase(string.begin() + use.position);
        string.insert(string.begin() + use.position, moved.begin(), moved.end());
    }
}

/// Other productions of the symbol, which draw its last element.
void change_ends(Grammar& grammar, const RowRule& rule,
                 const std::function<ModuleTemplates(const ModuleTemplates&)>& change) {
    const Production& production = grammar.productions[at(rule.loop.production)];
    if (rule.loop.has_drawn_end && std::ranges::count(grammar.terminals, production.symbol, &Terminal::symbol) > 0)
        refuse(production, "another symbol for the last element, not the terminal");
    for (std::size_t i = 0; i < grammar.productions.size(); ++i) {
        Production& end = grammar.productions[i];
        const bool draws = std::ranges::any_of(end.successor, [](const ModuleTemplate& part) { return !is_command(part); });
        if (end.symbol == production.symbol && static_cast<int>(i) != rule.loop.production && draws)
            end.successor = change(end.successor);
    }
}

/// The mean of the places of the elements, from the first one's frame.
Point middle_of(const Similarity& step, double elements) {
    Similarity pose;
    Point sum{};
    for (int i = 0; i < static_cast<int>(elements); ++i) {
        sum += pose.translation;
        pose = pose * step;
    }
    return sum / elements;
}

Expression share_of_circle(double elements) {
    constexpr std::size_t longest = 7;
    const double turn = rounded(full_circle / elements);
    if (number_text(turn).size() <= longest) return number_expression(turn);
    return parse_expression(number_text(full_circle) + "/" + number_text(elements));
}

}  // namespace

EditResult make_ring(const Grammar& grammar, const std::string& symbol, const RingOptions& options) {
    const RowRule rule = row_rule(grammar, symbol);
    EditResult result{grammar, {}};
    Production& production = result.grammar.productions[at(rule.loop.production)];
    const double distance = rule.step ? abs(rule.step->translation) : 0;
    double radius = options.radius;
    if (radius == 0) radius = distance / (2 * std::sin(pi / rule.elements));
    if (!(radius > 0) || !std::isfinite(radius)) refuse(production, "a radius above 0, or a step that is a number,");
    radius = rounded_in(radius, radius);
    const Point centre = rule.step ? middle_of(*rule.step, rule.elements) : Point{};

    const RowParts parts = parts_of(production, rule.loop.continuations.front().symbol);
    ModuleTemplates successor = parts.before;
    append(successor, on_rim(parts.element, radius));
    append(successor, parts.behind);
    successor.push_back({"+", {share_of_circle(rule.elements)}, {}});
    append(successor, parts.rest);
    production.successor = std::move(successor);
    change_ends(result.grammar, rule, [&](const ModuleTemplates& end) { return on_rim(end, radius); });
    Similarity to_centre;
    to_centre.translation = centre;
    move_uses(result.grammar, rule.uses, turtle_modules(to_centre, radius));
    result.changes.push_back(symbol + " is a ring of " + number_text(rule.elements) + " elements with the radius " +
                             short_text(radius));
    return result;
}

EditResult make_row(const Grammar& grammar, const std::string& symbol, const RowOptions& options) {
    const RowRule rule = row_rule(grammar, symbol);
    EditResult result{grammar, {}};
    Production& production = result.grammar.productions[at(rule.loop.production)];
    const std::optional<double> turn = turn_of(grammar, rule.loop, rule.uses.front());
    if (!turn || *turn == 0) refuse(production, "a turn from one element to the next");

    RowParts parts = parts_of(production, rule.loop.continuations.front().symbol);
    ModuleTemplates element = without_brackets(parts.element);
    const std::optional<std::size_t> rim = radius_in(element);
    double distance = options.distance;
    if (distance == 0 && rim) {
        const auto radius = value_of(element[*rim].arguments.front(), constants_of(grammar));
        constexpr double half_degrees = pi / 360;
        if (radius) distance = 2 * *radius * std::sin(std::abs(*turn) * half_degrees);
    } else if (distance == 0 && rule.step) {
        distance = abs(rule.step->translation);
    }
    if (!(distance > 0) || !std::isfinite(distance)) refuse(production, "a distance above 0, or a radius that is a number,");
    distance = rounded_in(distance, distance);

    if (rim) element.erase(element.begin() + static_cast<std::ptrdiff_t>(*rim));
    ModuleTemplates successor = parts.before;
    append(successor, bracketed({}, element));
    append(successor, parts.behind);
    append(successor, {command("-", quarter), command("f", distance), command("+", quarter)});
    append(successor, parts.rest);
    production.successor = std::move(successor);
    if (rim) {
        change_ends(result.grammar, rule, [](const ModuleTemplates& end) {
            ModuleTemplates last = without_brackets(end);
            if (const auto way = radius_in(last)) last.erase(last.begin() + static_cast<std::ptrdiff_t>(*way));
            return bracketed({}, last);
        });
        const double half = rounded_in(distance * (rule.elements - 1) / 2, distance);
        move_uses(result.grammar, rule.uses, {command("+", quarter), command("f", half), command("-", quarter)});
    }
    result.changes.push_back(symbol + " is a row of " + number_text(rule.elements) + " elements, " + short_text(distance) +
                             " from one to the next");
    return result;
}

std::vector<std::string> symbols_of_rows(const Grammar& grammar) {
    std::vector<std::string> symbols;
    for (const RuleLoop& loop : rule_loops(grammar)) {
        const std::string& symbol = grammar.productions[at(loop.production)].symbol;
        if (loop.continuations.size() == 1 && std::ranges::count(symbols, symbol) == 0) symbols.push_back(symbol);
    }
    return symbols;
}

}  // namespace rinceau

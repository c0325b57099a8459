#include "lsystem/numbers.h"

#include <algorithm>
#include <limits>
#include <map>

#include "lsystem/expression_numbers.h"
#include "lsystem/statement.h"
#include "lsystem/string_numbers.h"

namespace rinceau {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

GrammarNumber plain(std::string name, double value, NumberKind kind, NumberRank rank, std::string help) {
    GrammarNumber number;
    number.name = std::move(name);
    number.value = value;
    number.kind = kind;
    number.rank = rank;
    number.help = std::move(help);
    number.low = -no_limit;
    number.high = no_limit;
    return number;
}

/// "distance of Row, of Wall": what is written as this constant.
std::string uses_of_constant(int constant, const std::vector<GrammarNumber>& others) {
    constexpr std::size_t most_named = 3;
    std::vector<std::string> names;
    for (const GrammarNumber& other : others)
        if (other.constant == constant && other.parts.empty()) names.push_back(other.name);
    // "axiom.Row.count" says no more than "Row.count"
    std::erase_if(names, [&](const std::string& name) {
        return std::ranges::any_of(names, [&](const std::string& shorter) {
            return shorter.size() < name.size() && name.ends_with('.' + shorter);
        });
    });
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i) text += (i > 0 ? ", " : "") + names[i];
    return names.size() > most_named ? text + ", .." : text;
}

void add_constants(const Grammar& grammar, const Scope& constants, std::vector<GrammarNumber>& numbers) {
    std::vector<GrammarNumber> found;
    for (std::size_t i = 0; i < grammar.constants.size(); ++i) {
        const Constant& constant = grammar.constants[i];
        const auto value = value_of(constant.value, constants);
        if (!value) continue;
        const std::string uses = uses_of_constant(static_cast<int>(i), numbers);
        const auto lines = comment_lines(constant.comment);
        std::string help = lines.empty() ? "a constant" : lines.front();
        if (help.ends_with('.')) help.pop_back();
        if (!uses.empty()) help = lines.empty() ? uses : help + " (" + uses + ")";
        GrammarNumber number = plain(constant.name, *value, NumberKind::other, NumberRank::rule, help);
        for (const GrammarNumber& other : numbers) {
            if (other.constant != static_cast<int>(i)) continue;
            number.kind = other.kind;
            number.unit = other.unit;
            number.whole = other.whole;
        }
        const int size = static_cast<int>(constant.value.postfix.size());
        number.slots = {
            {NumberSlot::In::expression, {ExpressionPlace::In::constant, static_cast<int>(i), {}, 0, 0, 0, size}, 0, 1, 0}};
        describe_written(grammar, constant.value, number);
        found.push_back(std::move(number));
    }
    numbers.insert(numbers.begin(), found.begin(), found.end());
}

void add_conditions(const Grammar& grammar, const Scope& constants, const std::vector<RuleLoop>& loops,
                    std::vector<GrammarNumber>& numbers) {
    const auto add = [&](const Expression& expression, ExpressionPlace place, const std::string& name, NumberRank rank,
                         const std::string& help, const Scope& scope) {
        for (const NumberInExpression& found : numbers_in(expression, scope)) {
            place.first = found.first;
            place.last = found.last;
            const std::string ordinal = found.ordinal > 1 ? "." + std::to_string(found.ordinal) : "";
            GrammarNumber number = plain(name + ordinal, found.value, NumberKind::other, rank, help);
            number.slots = {{NumberSlot::In::expression, place, 0, found.slope, 0}};
            describe_written(grammar, part_at(grammar, place), number);
            numbers.push_back(std::move(number));
        }
    };
    for (std::size_t i = 0; i < grammar.productions.size(); ++i) {
        const int index = static_cast<int>(i);
        const Production& production = grammar.productions[i];
        const StringPlace string{StringPlace::In::production, index};
        const Scope scope = constants_in(grammar, constants, string);
        const std::string name = name_of_string(grammar, string);
        if (production.weight)
            add(*production.weight, {ExpressionPlace::In::weight, index, {}, 0, 0, 0, 0}, name + ".weight", NumberRank::rule,
                "how often, beside the other productions of " + production.symbol, scope);
        const bool counted =
            std::ranges::any_of(loops, [&](const RuleLoop& loop) { return loop.production == index && loop.up; });
        if (production.condition && !counted)
            add(*production.condition, {ExpressionPlace::In::condition, index, {}, 0, 0, 0, 0}, name + ".limit",
                NumberRank::detail, "in the condition", scope);
    }
}

void add_styles(const Grammar& grammar, std::vector<GrammarNumber>& numbers) {
    for (std::size_t i = 0; i < grammar.styles.size(); ++i) {
        const NumberedStyle& style = grammar.styles[i];
        const std::string name = "style" + std::to_string(style.number) + '.';
        const auto add = [&](const char* role, NumberSlot::In in, double value, bool shown, const char* help) {
            const bool width = in == NumberSlot::In::stroke_width;
            GrammarNumber number = plain(name + role, value, width ? NumberKind::length : NumberKind::share,
                                         shown ? NumberRank::style : NumberRank::detail, help);
            number.low = 0;
            if (!width) number.high = 1;
            number.slots = {{in, {}, static_cast<int>(i), 1, 0}};
            numbers.push_back(std::move(number));
        };
        const Style& s = style.style;
        add("stroke_width", NumberSlot::In::stroke_width, s.stroke.width, paints_stroke(s), "width of the stroke");
        add("fill_opacity", NumberSlot::In::fill_opacity, s.fill_opacity, s.fill_opacity != 1, "0 to 1");
        add("stroke_opacity", NumberSlot::In::stroke_opacity, s.stroke.opacity, s.stroke.opacity != 1, "0 to 1");
        add("opacity", NumberSlot::In::opacity, s.opacity, s.opacity != 1, "0 to 1, of fill and stroke together");
    }
}

void add_picture(const Grammar& grammar, std::vector<GrammarNumber>& numbers) {
    if (!is_empty(grammar.canvas)) {
        const Box& box = grammar.canvas;
        const double values[] = {box.low.x, -box.high.y, width(box), height(box)};
        const char* const names[] = {"canvas.x", "canvas.y", "canvas.width", "canvas.height"};
        const char* const helps[] = {"left edge of the picture", "upper edge of the picture, downwards",
                                     "width of the picture", "height of the picture"};
        for (int i = 0; i < 4; ++i) {
            numbers.push_back(plain(names[i], values[i], NumberKind::length, NumberRank::detail, helps[i]));
            numbers.back().slots = {{NumberSlot::In::canvas, {}, i, 1, 0}};
            if (i >= 2) numbers.back().low = 0;
        }
    }
    const double seed = grammar.seed ? static_cast<double>(*grammar.seed) : 1;
    const NumberRank rank = grammar.seed ? NumberRank::rule : NumberRank::detail;
    numbers.push_back(plain("seed", seed, NumberKind::seed, rank, "of what is random"));
    numbers.back().whole = true;
    numbers.back().low = 0;
    constexpr double largest_exact = 9007199254740992.0;  // 2^53
    numbers.back().high = largest_exact;
    numbers.back().slots = {{NumberSlot::In::seed, {}, 0, 1, 0}};
}

void make_unique(std::vector<GrammarNumber>& numbers) {
    std::map<std::string, int> counts;
    for (const GrammarNumber& number : numbers) ++counts[number.name];
    std::map<std::string, int> seen;
    for (GrammarNumber& number : numbers) {
        if (++seen[number.name] == 1) continue;
        std::string name;
        do {
            name = number.name + '.' + std::to_string(seen[number.name]++);
        } while (counts.contains(name));
        counts[name] = 1;
        --seen[number.name];
        number.name = std::move(name);
    }
}

}  // namespace

std::vector<GrammarNumber> grammar_numbers(const Grammar& grammar) {
    const Scope constants = constants_of(grammar);
    const std::vector<RuleLoop> loops = rule_loops(grammar);
    std::vector<GrammarNumber> numbers = count_numbers(grammar, loops);
    for (GrammarNumber& number : string_numbers(grammar, constants, loops)) numbers.push_back(std::move(number));
    add_conditions(grammar, constants, loops, numbers);
    add_constants(grammar, constants, numbers);
    add_styles(grammar, numbers);
    add_picture(grammar, numbers);
    make_unique(numbers);
    return numbers;
}

bool fits_name(const std::string& pattern, const std::string& name) {
    // where the last '*' stands, and how far it reaches
    std::size_t star = std::string::npos;
    std::size_t reached = 0;
    std::size_t p = 0;
    std::size_t n = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            reached = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string::npos) {
            p = star + 1;
            n = ++reached;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

}  // namespace rinceau

#include "closed_loop/random_grammar.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "geometry/random.h"
#include "lsystem/interpret.h"

namespace rinceau::test {
namespace {

/// Numbers with one decimal, as people choose them.
double tenths(double value) { return std::round(value * 10) / 10; }

std::string text(double value) {
    const long long tenth = std::llround(value * 10);
    const std::string digits = std::to_string(std::abs(tenth));
    return (tenth < 0 ? "-" : "") + (digits.size() > 1 ? digits.substr(0, digits.size() - 1) : "0") + "." + digits.back();
}

struct RandomTerminal {
    Element element;
    bool symmetric = true;
};

/// Of a kind that `number` chooses: different numbers give different shapes. At most 10 from the origin.
RandomTerminal random_terminal(std::uint32_t number, Random& random) {
    const Color color = random_color(random);
    const auto with = [&](std::vector<Path> paths, bool symmetric) {
        return RandomTerminal{element(transformed(paths, scale_by(10)), filled(color)), symmetric};
    };
    switch (number % 8) {
        case 0: return with(hook(), false);
        case 1: return with(blob(5 + static_cast<int>(random.below(4)), random), false);
        case 2: return with(regular_polygon(3 + static_cast<int>(random.below(6))), true);
        case 3: return with(circle(), true);
        case 4: return with(star(4 + static_cast<int>(random.below(4))), true);
        case 5: return with(leaf(random.uniform(0.3, 0.5)), true);
        case 6: return with(frame(3 + static_cast<int>(random.below(4))), true);
        default: return {element(transformed(bar(), scale_by(10)), stroked(color, 2)), true};
    }
}

/// A grammar under construction: `top` is the symbol (with its arguments) that stands for all so far.
struct Builder {
    Random random;
    std::string productions;
    std::vector<std::pair<std::string, Element>> terminals;
    std::vector<ExpectedRule> rules;
    std::string top;
    bool top_symmetric = false;
    int level = 0;

    Grammar grammar() const { return known_grammar("axiom: " + top + "\n" + productions, terminals); }

    int between(int low, int high) { return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1))); }

    /// The farthest that anything is drawn from the top symbol's origin.
    double radius() const {
        double farthest = 0;
        for (const Element& element : drawn_scene(grammar()).elements) {
            const Box box = painted_box(element);
            farthest = std::max({farthest, abs(box.low), abs(box.high), abs(Point{box.low.x, box.high.y}), abs(Point{box.high.x, box.low.y})});
        }
        return farthest;
    }

    std::string add_terminal(std::uint32_t number) {
        const RandomTerminal terminal = random_terminal(number, random);
        const std::string symbol(1, static_cast<char>('A' + terminals.size()));
        terminals.emplace_back(symbol, terminal.element);
        top_symmetric = terminal.symmetric;
        return symbol;
    }

    /// P<level>(m) : m > 0 -> body P<level>(m-1), whose place in `body` is marked by '@'.
    void repeat(std::string body, int count) {
        const std::string name = "P" + std::to_string(level++);
        body.replace(body.find('@'), 1, name + "(m-1)");
        productions += name + "(m) : m > 0 -> " + body + "\n";
        top = name + "(" + std::to_string(count) + ")";
    }
};

void add_sequence(Builder& b) {
    ExpectedRule rule{.kind = "sequence", .count = b.between(4, 9), .unique = !b.top_symmetric};
    const double radius = b.radius();
    // Less than half a turn in all, so that the sequence does not come back to itself.
    const double bend = b.random.uniform(-150, 150) / rule.count;
    rule.turn = std::round(b.random.uniform(0.3, 0.7) * bend);
    rule.spin = std::round(bend - rule.turn);
    if (b.level == 0 && b.random.below(3) == 0) rule.scale = b.random.below(2) == 0 ? 0.9 : 1.1;
    rule.advance = tenths(radius * b.random.uniform(2.5, 3.2) * std::max(1.0, rule.scale));
    const std::string scale = rule.scale == 1 ? "" : " *(" + text(rule.scale) + ")";
    b.repeat("[" + b.top + "] +(" + text(rule.turn) + ") f(" + text(rule.advance) + ")" + scale + " +(" + text(rule.spin) + ") @", rule.count);
    b.rules.push_back(rule);
    b.top_symmetric = false;
}

void add_ring(Builder& b) {
    ExpectedRule rule{.kind = "ring", .count = b.between(5, 14)};
    rule.spin = 360.0 / rule.count;
    const double advance = tenths(b.radius() * b.random.uniform(1.25, 1.5) / std::sin(pi / rule.count));
    b.repeat("[f(" + text(advance) + ") " + b.top + "] +(360/" + std::to_string(rule.count) + ") @", rule.count);
    b.rules.push_back(rule);
    b.top_symmetric = true;
}

void add_linear(Builder& b) {
    ExpectedRule rule{.kind = "linear", .count = b.between(6, 10), .unique = !b.top_symmetric};
    const auto change = [&] { return (b.random.below(2) == 0 ? -1 : 1) * b.between(1, 3); };
    rule.turn_change = change();
    rule.spin_change = change();
    rule.turn = b.between(-10, 10);
    rule.spin = b.between(-10, 10);
    rule.advance = tenths(b.radius() * b.random.uniform(3, 4));
    const std::string name = "P" + std::to_string(b.level++);
    b.productions += name + "(m, a, b) : m > 0 -> [" + b.top + "] +(a) f(" + text(rule.advance) + ") +(b) " + name + "(m-1, a+(" +
                     text(rule.turn_change) + "), b+(" + text(rule.spin_change) + "))\n";
    b.top = name + "(" + std::to_string(rule.count) + ", " + text(rule.turn) + ", " + text(rule.spin) + ")";
    b.rules.push_back(rule);
    b.top_symmetric = false;
}

void add_grid(Builder& b) {
    const double radius = b.radius();
    const ExpectedRule row{.kind = "sequence", .count = b.between(4, 9), .turn = -90, .advance = tenths(radius * b.random.uniform(2.3, 2.6)),
                           .spin = 90};
    const ExpectedRule rows{.kind = "sequence", .count = b.between(4, 9), .advance = tenths(radius * b.random.uniform(3.1, 3.6))};
    b.repeat("[" + b.top + "] -(90) f(" + text(row.advance) + ") +(90) @", row.count);
    b.repeat("[" + b.top + "] f(" + text(rows.advance) + ") @", rows.count);
    b.rules.push_back(row);
    b.rules.push_back(rows);
    b.top_symmetric = true;
}

/// Two to four different terminals: one in the middle, the others about it.
void add_group(Builder& b) {
    ExpectedRule rule{.kind = "group", .count = b.between(2, 4)};
    const std::uint32_t first = b.random.below(8);
    std::string body = "[" + b.add_terminal(first) + "]";
    for (int i = 1; i < rule.count; ++i) {
        const double direction = std::round(360.0 * i / (rule.count - 1) + b.random.uniform(0, 25));
        const double distance = tenths(b.random.uniform(22, 25));
        const double spin = std::round(b.random.uniform(-80, 80));
        body += " [+(" + text(direction) + ") f(" + text(distance) + ") +(" + text(spin) + ") " + b.add_terminal(first + static_cast<std::uint32_t>(i)) + "]";
    }
    const std::string name = "G" + std::to_string(b.level++);
    b.productions += name + " -> " + body + "\n";
    b.top = name;
    b.rules.push_back(rule);
    b.top_symmetric = false;
}

void add_sequence_or_ring(Builder& b) {
    if (b.random.below(2) == 0) add_sequence(b);
    else add_ring(b);
}

}  // namespace

KnownGrammar random_known_grammar(SampleKind kind, std::uint64_t seed) {
    Builder b{.random = Random(seed * 8 + static_cast<std::uint64_t>(kind))};
    if (kind == SampleKind::group) add_group(b);
    // A linear sequence of what turns into itself is another sequence: only shapes without symmetry.
    else b.top = b.add_terminal(kind == SampleKind::linear ? b.random.below(2) : b.random.below(8));
    switch (kind) {
        case SampleKind::sequence: add_sequence(b); break;
        case SampleKind::linear: add_linear(b); break;
        case SampleKind::ring: add_ring(b); break;
        case SampleKind::grid: add_grid(b); break;
        case SampleKind::group: add_sequence_or_ring(b); break;
        case SampleKind::hierarchy:
            for (int levels = b.between(2, 3); levels > 0; --levels) add_sequence_or_ring(b);
            break;
    }
    KnownGrammar known{.grammar = b.grammar(), .rules = b.rules, .terminals = static_cast<int>(b.terminals.size())};
    known.elements = static_cast<int>(interpret(known.grammar).size());
    return known;
}

}  // namespace rinceau::test

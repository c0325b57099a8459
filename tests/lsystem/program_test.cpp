// Expressions made ready, and grammars drawn with them, against the plainest way to do the same.

#include "lsystem/program.h"

#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>

#include "lsystem/expression_functions.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

double value_of(const Expression& expression, const std::vector<std::string>& names, const std::vector<double>& values) {
    const Program program = compile_expression(expression, {names, {}}, {});
    std::vector<double> stack(static_cast<std::size_t>(program.stack_size));
    return evaluate_code(program, values.data(), stack.data(), 0);
}

/// Rewrites and draws by recursion, with every expression read anew.
class PlainInterpreter {
  public:
    PlainInterpreter(const Grammar& grammar, int depth) : grammar_(grammar), depth_(depth) {
        pass(grammar.axiom, {}, {}, 0);
    }

    std::vector<Placement> placements;

  private:
    const Grammar& grammar_;
    int depth_;
    Similarity pose_;
    int style_ = 0;
    std::vector<std::pair<Similarity, int>> stack_;

    void pass(const std::vector<ModuleTemplate>& string, const std::vector<std::string>& names,
              const std::vector<double>& values, int generation) {
        for (const ModuleTemplate& module : string) {
            std::vector<double> arguments;
            for (const Expression& argument : module.arguments) arguments.push_back(value_of(argument, names, values));
            if (!command(module.symbol, arguments.empty() ? 0 : arguments.front())) symbol(module, arguments, generation);
        }
    }

    bool command(const std::string& symbol, double x) {
        if (symbol == "[") {
            stack_.push_back({pose_, style_});
        } else if (symbol == "]") {
            std::tie(pose_, style_) = stack_.back();
            stack_.pop_back();
        } else if (symbol == "+" || symbol == "-") {
            const double angle = symbol == "+" ? x : -x;
            pose_.linear = pose_.linear * flipped_if(pose_.mirrored, {cosine_of_degrees(angle), sine_of_degrees(angle)});
        } else if (symbol == "f") {
            pose_.translation += pose_.linear * flipped_if(pose_.mirrored, {0, x});
        } else if (symbol == "*") {
            pose_.linear = x * pose_.linear;
        } else if (symbol == "|") {
            pose_ = pose_ * mirror_about_heading();
        } else if (symbol == ";") {
            style_ = static_cast<int>(x);
        } else {
            return false;
        }
        return true;
    }

    void symbol(const ModuleTemplate& module, const std::vector<double>& arguments, int generation) {
        for (const Production& production : grammar_.productions) {
            const bool fits = production.symbol == module.symbol && production.parameters.size() == arguments.size();
            if (!fits || generation == depth_) continue;
            if (production.condition && value_of(*production.condition, production.parameters, arguments) == 0) continue;
            return pass(production.successor, production.parameters, arguments, generation + 1);
        }
        for (std::size_t i = 0; i < grammar_.terminals.size(); ++i) {
            if (grammar_.terminals[i].symbol != module.symbol) continue;
            Placement placement;
            placement.terminal = static_cast<int>(i);
            placement.style = style_;
            placement.pose = pose_;
            placements.push_back(placement);
        }
    }
};

}  // namespace

TEST_CASE("expressions of one operation have the value that their code has, to the bit") {
    const std::vector<std::string> operations{"+", "-", "*", "/", "%", "^", "<", "<=", ">", ">=", "==", "!=", "&&", "||"};
    const std::vector<double> numbers{0, -0.0, 1, -1, 0.1, 3, 1e300, -1e-300, 7.25};
    const Scope scope{{"a", "m"}, {}};
    std::vector<double> stack(4);
    const auto expect_same = [&](const Program& program) {
        for (const double value : numbers) {
            const std::vector<double> slots{5, value};
            const double quick = evaluate(program, slots.data(), stack.data());
            CHECK(same_bits(quick, evaluate_code(program, slots.data(), stack.data(), 0)));
        }
    };
    expect_same(compile_expression(parse_expression("m"), scope, {}));
    for (const std::string& operation : operations) {
        for (const std::string number : {"0", "1", "-1", "3", "0.1", "1e300", "(0/0)", "(1/0)", "m", "a"}) {
            expect_same(compile_expression(parse_expression("m " + operation + " " + number), scope, {}));
        }
    }
}

TEST_CASE("grammars are drawn as the plainest interpreter draws them, to the bit") {
    const std::string terminals =
        "style 1: fill red\nterminal A: path \"M0 0H1V1Z\"\nterminal B: style 1; path \"M0 0H2V1Z\"\n";
    const std::vector<std::string> bodies{
        "axiom: F(5) +(60) +(60) F(5)\nF(n) : n > 0 -> F(n-1) -(60) F(n-1) +(60) +(60) F(n-1) -(60) F(n-1)\n"
        "F(n) : n == 0 -> A f(1)\n",
        "axiom: T(4, 1)\n"
        "T(n, s) : n >= 1 && s < 9 -> f(s*3) [ +(25.7) *(0.7) T(n-1, s/2) ] f(s) [ | -(25.7/n) T(n-1, s+1) ] ;(1) B T(n-2, "
        "s)\n"
        "T(n, s) : n <= 0 -> A\n",
        "axiom: P(40) Q\nP(m) : m > 0 -> [ +(10*m) f(100/m) A ] *(0.99) P(m-1)\nQ -> Q B f(2)\n"};
    for (const std::string& body : bodies) {
        const Grammar grammar = parse_grammar("lsystem 1\n" + body + terminals);
        for (const int depth : {0, 1, 3, 41}) {
            InterpretOptions options;
            options.derive.depth = depth;
            const std::vector<Placement> placements = interpret(grammar, options);
            const std::vector<Placement> plain = PlainInterpreter(grammar, depth).placements;
            REQUIRE(placements.size() == plain.size());
            for (std::size_t i = 0; i < plain.size(); ++i) {
                const Placement& a = placements[i];
                const Placement& b = plain[i];
                const bool same = a.terminal == b.terminal && a.style == b.style && a.pose.mirrored == b.pose.mirrored &&
                                  same_bits(a.pose.linear.x, b.pose.linear.x) &&
                                  same_bits(a.pose.linear.y, b.pose.linear.y) &&
                                  same_bits(a.pose.translation.x, b.pose.translation.x) &&
                                  same_bits(a.pose.translation.y, b.pose.translation.y);
                REQUIRE(same);
            }
        }
    }
}

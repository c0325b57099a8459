#include <catch2/catch.hpp>

#include "growth/surface/parse_shape_grammar.h"
#include "growth/surface/shape_expressions.h"

using namespace rinceau;

namespace {

/// Answers with a number and remembers what was asked.
struct Answers : QuerySource {
    std::vector<ShapeQuery> asked;
    double value = 3;
    double answer(const ShapeQuery& query) override {
        asked.push_back(query);
        return value;
    }
};

/// The number in `R(n) ~ Rz(..)` for n = 2.
double turn(const std::string& expression, QuerySource& queries, DrawKey key = 1, const std::string& head = "") {
    const ShapeGrammar grammar = parse_shape_grammar(
        head + "param u = 0.5\nfield F1 = curvature\nshape leaf = box\naxiom vertex 0 R(2)\nR(n) ~ Rz(" + expression + ")");
    const CompiledShapeGrammar compiled = compile_shape_grammar(grammar, {.diagonal = 8});
    ShapeEvaluator evaluator(compiled);
    const std::vector<double> parameters{2};
    return evaluator.number(compiled.rules[0].successor[0].numbers[0], parameters, key, queries);
}
double turn(const std::string& expression) {
    Answers none;
    const double value = turn(expression, none);
    CHECK(none.asked.empty());
    return value;
}

std::string mistake_of(const std::string& text) {
    try {
        compile_shape_grammar(parse_shape_grammar(text));
    } catch (const InputError& error) {
        return std::to_string(error.place().line) + " " + error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("arguments are evaluated with parameters, params and what is known of the surface") {
    CHECK(turn("n*u") == 1);
    CHECK(turn("if(n%2==0, 60, -60)") == 60);
    CHECK(turn("diagonal/2") == 4);
    CHECK(turn("clamp(n, 3, 5)") == 3);
}

TEST_CASE("queries are asked for when an expression with them is evaluated, and only then") {
    Answers answers;
    CHECK(turn("F1.vector1.y + n", answers) == 5);
    REQUIRE(answers.asked.size() == 1);
    CHECK(answers.asked[0].about == ShapeQuery::About::field);
    CHECK(answers.asked[0].quantity == FieldQuantity::vector1);
    CHECK(answers.asked[0].component == 1);
    CHECK(answers.asked[0].field == 0);
    answers.asked.clear();
    CHECK(turn("near(\"leaf\")*count( \"leaf\" ) + S.z - P.x + N.y + depth", answers) == 15);
    REQUIRE(answers.asked.size() == 6);
    CHECK(answers.asked[1].about == ShapeQuery::About::count);
    CHECK(answers.asked[2].component == 2);
}

TEST_CASE("a condition asks no more than it needs") {
    const ShapeGrammar grammar = parse_shape_grammar(
        "field F1 = curvature\naxiom vertex 0 A(0)\nA(n) : n > 3 && F1.gauss > 1 && (n < 9 || F1.mean > 2) ~ Rz(1)");
    const CompiledShapeGrammar compiled = compile_shape_grammar(grammar);
    REQUIRE(compiled.rules[0].condition.size() == 3);
    ShapeEvaluator evaluator(compiled);
    Answers answers;
    const std::vector<double> low{2}, high{5};
    CHECK(!evaluator.holds(compiled.rules[0], low, 1, answers));
    CHECK(answers.asked.empty());
    CHECK(evaluator.holds(compiled.rules[0], high, 1, answers));
    CHECK(answers.asked.size() == 2);
}

TEST_CASE("draws depend on the key and on the place in the rule, not on what was drawn before") {
    Answers none;
    const double first = turn("rand()", none, 7), again = turn("rand()", none, 7), other = turn("rand()", none, 8);
    CHECK(first == again);
    CHECK(first != other);
    CHECK((first >= 0 && first < 1));
    const double range = turn("rand(3, 5)", none, 7);
    CHECK((range >= 3 && range < 5));
    CHECK(turn("rand() - rand()", none, 7) != 0);
    double sum = 0;
    constexpr int draws = 1000;
    const ShapeGrammar grammar = parse_shape_grammar("axiom vertex 0 A\nA ~ Rz(rand()) Rz(rand())");
    const CompiledShapeGrammar compiled = compile_shape_grammar(grammar);
    ShapeEvaluator evaluator(compiled);
    const auto& commands = compiled.rules[0].successor;
    for (int i = 0; i < draws; ++i) {
        const DrawKey key = key_of_child(compiled.root, i);
        const double a = evaluator.number(commands[0].numbers[0], {}, key, none);
        const double b = evaluator.number(commands[1].numbers[0], {}, key, none);
        CHECK(a != b);
        sum += a - 0.5 + (b - 0.5) + (rule_draw(key) - 0.5);
    }
    CHECK(std::abs(sum) < 60);  // four deviations of 3,000 uniform draws are 63
}

TEST_CASE("noise is smooth, stays within one and is the same at the same place") {
    CHECK(turn("noise(0.3) - noise(0.3)") == 0);
    CHECK(turn("abs(noise(0.3) - noise(0.3001)) < 0.001") == 1);
    CHECK(turn("noise(1.5, 2.5) == noise(1.5, 3.5)") == 0);
    double least = 1, most = -1;
    Answers none;
    for (int i = 0; i < 40; ++i) {
        const double value = turn("noise(" + std::to_string(i) + ".37, 5, -3.2)", none);
        least = std::min(least, value);
        most = std::max(most, value);
    }
    CHECK((least < -0.2 && most > 0.2 && least >= -1 && most <= 1));
}

TEST_CASE("what may be left out of a command is filled up") {
    const ShapeGrammar grammar = parse_shape_grammar(
        "shape leaf = box\naxiom vertex 0 A\nA ~ T(1) S(2) IM(\"leaf\", 3) Line Colour(\"sienna\") [A] Lock{A|A A}");
    const CompiledShapeGrammar compiled = compile_shape_grammar(grammar);
    const auto& commands = compiled.rules[0].successor;
    CHECK(commands[0].numbers.at(2).value == 0);
    CHECK(commands[1].numbers.at(2).value == 2);
    CHECK(commands[2].numbers.at(1).value == 180);
    CHECK(commands[3].numbers.at(0).value == 1);
    CHECK(commands[4].colour == Color{160, 82, 45});
    CHECK(commands[8].groups.at(1).at(1).ordinal == 11);
}

TEST_CASE("symbols of the same name and other numbers of arguments are others") {
    const ShapeGrammar grammar = parse_shape_grammar("axiom vertex 0 A\nA ~ A(1)\nA(n) ~ Rz(n)");
    const CompiledShapeGrammar compiled = compile_shape_grammar(grammar);
    CHECK(compiled.symbols.size() == 2);
    CHECK(compiled.rules[0].successor[0].symbol == 1);
}

TEST_CASE("what does not exist is named with what was perhaps meant") {
    CHECK(has(mistake_of("axiom vertex 0 Stm(1)\nStem(n) ~ Rz(n)"), "'Stm': did you mean 'Stem'?"));
    CHECK(has(mistake_of("axiom vertex 0 A\nA ~ B(1, 2)\nB(n) ~ Rz(n)"), "2 x") == false);
    CHECK(has(mistake_of("axiom vertex 0 A\nA ~ B(1, 2)\nB(n) ~ Rz(n)"),
              "expected 1 argument(s) of B, as in its rule in line 3, found 2"));
    CHECK(has(mistake_of("shape leaf = box\naxiom vertex 0 I(\"laef\")"), "did you mean 'leaf'?"));
    CHECK(has(mistake_of("field F1 = curvature\naxiom vertex 0 Rz(F2.gauss)"), "did you mean 'F1'?"));
    CHECK(has(mistake_of("field F1 = curvature\naxiom vertex 0 Rz(F1.lenght1)"), "did you mean 'length1'?"));
    CHECK(has(mistake_of("field F1 = curvature\naxiom vertex 0 Rz(F1.vector1)"), "F1.vector1.x, F1.vector1.y"));
    CHECK(has(mistake_of("field F1 = curvature\naxiom vertex 0 Rz(F1.gauss.x)"), "which has no parts"));
    CHECK(has(mistake_of("axiom vertex 0 Rz(near(\"x\"))"), "expected a shape of this grammar"));
    CHECK(has(mistake_of("axiom vertex 0 Rz(P.w)"), "expected x, y or z"));
    CHECK(has(mistake_of("param u = 1\naxiom vertex 0 A(1)\nA(size) ~ Rz(siez)"), "did you mean 'size'?"));
    CHECK(has(mistake_of("param a = b\nparam b = 1\naxiom vertex 0 Rz(a)"), "set before this one"));
    CHECK(has(mistake_of("param a = P.x\naxiom vertex 0 Rz(a)"), "known at a scope only"));
    CHECK(has(mistake_of("param a = 1/0\naxiom vertex 0 Rz(a)"), "expected a finite number"));
    CHECK(has(mistake_of("axiom each F1 Rz(1)"), "expected a field of this grammar behind 'each'"));
    CHECK(has(mistake_of("axiom scatter -2 Rz(1)"), "expected a number of places"));
    CHECK(has(mistake_of("axiom vertex 0 Colour(\"oragne\")"), "expected a colour"));
}

TEST_CASE("a number that is not finite is an error at its place, when it is needed") {
    Answers none;
    CHECK_THROWS_AS(turn("1/(n - 2)", none), InputError);
    CHECK_THROWS_WITH(turn("sqrt(-n)", none), Catch::Matchers::Contains("has no value here"));
}

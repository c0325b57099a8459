#include <catch2/catch.hpp>

#include "growth/surface/parse_shape_grammar.h"
#include "growth/surface/shape_commands.h"
#include "growth/surface/shape_grammar_text.h"

using namespace rinceau;

namespace {

ShapeRule only_rule(const std::string& text) { return parse_shape_grammar(text, "x.fgsg").rules.at(0); }

/// "line:column message" of the first mistake.
std::string mistake_in(const std::string& text) {
    const ParsedShapeGrammar parsed = read_shape_grammar(text, "x.fgsg");
    if (parsed.mistakes.empty()) return "";
    const Warning& first = parsed.mistakes.front();
    return std::to_string(first.place.line) + ":" + std::to_string(first.place.column) + " " + first.message;
}

constexpr auto vine = R"(# waving stems
param u = 0.005 * diagonal   # a step
field F1 = elements "vine.json" smooth = 0.03
shape leaf = outline "leaf.svg" height = 0.3 collide = hull colour = "#80a050"
option cull = bracket
option touch = 0.02
axiom scatter 5 [Stem(0, 1)] [Rz(180) Stem(0, 1)]
axiom nearest -1 0.5 (2*u) Stem(0, 1)
axiom each F1 Stem(0, 1)
Stem(n, w) : n < 260 ~ Seg(w) T(u, 0, 0) Rz(13*sin(n*16)) Grow(n, w) @ 2
a: Grow(n, w) : n%9 == 4 ~ Stem(n + 1, w) [Rz(58) T(u*1.3, 0, 0) Leaf(1)] : 0.25 @ -1
2: Grow(n, w) → Lock{I("leaf") | Chart{IC("leaf") Leaf(1)}} IM("leaf", u, 10) Colour("#aa0000") Set("age", n)
Leaf(s) : near("leaf") > u && F1.vector1.x >= 0 ~ S(s) Line LineSeg(u, 0.1*u)
)";

}  // namespace

TEST_CASE("a shape grammar's text is read into its parts") {
    const ShapeGrammar grammar = parse_shape_grammar(vine, "vine.fgsg");
    REQUIRE(grammar.params.size() == 1);
    CHECK(grammar.params[0].comment == "waving stems\na step");
    REQUIRE(grammar.fields.size() == 1);
    CHECK(grammar.fields[0].kind == "elements");
    CHECK(grammar.fields[0].text == "vine.json");
    CHECK(grammar.fields[0].numbers.at("smooth") == number_expression(0.03));
    REQUIRE(grammar.shapes.size() == 1);
    CHECK(grammar.shapes[0].words.at("collide") == "hull");
    CHECK(grammar.shapes[0].words.at("colour") == "#80a050");
    CHECK(grammar.options.at("cull").text == "bracket");
    CHECK(grammar.options.at("touch").numbers.at("value") == number_expression(0.02));
    REQUIRE(grammar.axioms.size() == 3);
    CHECK(grammar.axioms[0].commands.size() == 7);
    CHECK(grammar.axioms[1].numbers.size() == 3);
    CHECK(grammar.axioms[1].numbers[0] == number_expression(-1));
    CHECK(grammar.axioms[2].field == "F1");
    REQUIRE(grammar.rules.size() == 4);
    CHECK(grammar.rules[0].priority == 2);
    CHECK(grammar.rules[1].id == "a");
    CHECK(grammar.rules[1].priority == -1);
    CHECK(grammar.rules[1].probability.has_value());
    CHECK(grammar.rules[2].id == "2");
    CHECK(grammar.rules[2].place.line == 12);
    const std::vector<ShapeCommand>& commands = grammar.rules[2].successor;
    REQUIRE(commands.size() == 4);
    REQUIRE(commands[0].groups.size() == 2);
    CHECK(commands[0].groups[1][0].verb == ShapeVerb::chart);
    CHECK(commands[0].groups[1][0].groups[0].size() == 2);
    CHECK(commands[1].arguments.size() == 2);
    CHECK(commands[2].text == "#aa0000");
    CHECK(commands[3].text == "age");
}

TEST_CASE("a shape grammar's text is read again as it was written") {
    const std::string once = to_text(parse_shape_grammar(vine));
    const ShapeGrammar again = parse_shape_grammar(once);
    CHECK(to_text(again) == once);
    CHECK(again.rules.size() == 4);
    CHECK(statement_text(again.rules[3]) ==
          "Leaf(s) : near(\"leaf\") > u && F1.vector1.x >= 0 ~ S(s) Line LineSeg(u, 0.1*u)");
}

TEST_CASE("a name before a number in parentheses is not read again as a function") {
    const std::string text = "param u = 1\naxiom nearest (u) (-u) (u) A\n";
    const ShapeGrammar grammar = parse_shape_grammar(text);
    CHECK(statement_text(grammar.axioms[0]) == "axiom nearest (u) (-u) u A");
    CHECK(to_text(parse_shape_grammar(to_text(grammar))) == to_text(grammar));
}

TEST_CASE("a name before a colon is a rule's name only if a symbol follows") {
    CHECK(only_rule("a : B ~ I(\"x\")").symbol == "B");
    CHECK(only_rule("a : B(n) : n > 2 ~").id == "a");
    const ShapeRule conditional = only_rule("B : depth < 5 ~ I(\"x\")");
    CHECK(conditional.symbol == "B");
    CHECK(conditional.id.empty());
    CHECK(to_text(*conditional.condition) == "depth < 5");
    const ShapeRule flagged = only_rule("B : (go) ~");
    CHECK(flagged.symbol == "B");
    CHECK(statement_text(flagged) == "B : (go) ~");
}

TEST_CASE("a rule goes on in the next line while a bracket is open") {
    const ShapeRule rule = only_rule("A ~ [ T(1,\n   2, # to the side\n   3) B\n ] C\n");
    CHECK(rule.successor.size() == 5);
    CHECK(rule.successor[1].arguments.size() == 3);
    CHECK(rule.comment == "to the side");
}

TEST_CASE("a word that names a param is its value") {
    const ShapeGrammar grammar =
        parse_shape_grammar("param h = 2\nshape a = box height = h collide = disc\noption touch = h");
    CHECK(grammar.shapes[0].numbers.at("height") == name_expression("h"));
    CHECK(grammar.shapes[0].words.at("collide") == "disc");
    CHECK(grammar.options.at("touch").numbers.at("value") == name_expression("h"));
}

TEST_CASE("mistakes of form are named with line, column, what was expected and what was found") {
    CHECK(mistake_in("A ~ T(1,") == "1:6 expected a ')' for this '(', found none before the next statement");
    CHECK(mistake_in("A ~ [B\nB ~ I(\"x\")") == "1:5 expected a ']' for this '[', found none before the next statement");
    CHECK(mistake_in("\nA ~ B ]") == "2:7 expected a command; no '[' is open here, found ']'");
    CHECK(mistake_in("A ~ T(1, 2, 3, 4)") == "1:5 expected 1 to 3 numbers for T(x, y, z), found 4");
    CHECK(mistake_in("A ~ I(leaf)") == "1:5 expected a text in quotation marks for I(\"shape\"), found none");
    CHECK(mistake_in("A ~ T(1+, 2)") == "1:9 expected a number, a name or '(', found ','");
    CHECK(mistake_in("A ~ T(frob(2))") == "1:7 expected a function such as sin, sqrt or min, found 'frob'");
    CHECK(mistake_in("A B") == "1:3 expected ':' or '~' behind the symbol, found 'B'");
    CHECK(mistake_in("A : 1 < 2 B") == "1:11 expected '~' behind the condition, found 'B'");
    CHECK(mistake_in("T ~ A") == "1:1 expected a symbol of your own before ~, found the word 'T'");
    CHECK(mistake_in("param u = 1\nparam u = 2") == "2:7 expected another name, found the param 'u' a second time");
    CHECK(mistake_in("axiom somewhere A") ==
          "1:7 expected a place: vertex N, nearest X Y Z, scatter N or each FIELD, found 'somewhere'");
    CHECK(mistake_in("A ~ Lock{B | C").find("expected a '}' for this '{'") != std::string::npos);
    CHECK(mistake_in("A ~ {B}") == "1:5 expected Lock or Chart before a '{', found '{'");
    CHECK(mistake_in("A ~ B @ x") == "1:9 expected a number, found 'x'");
    CHECK(mistake_in("A(n, n) ~ B") == "1:6 expected another name, found the parameter 'n' twice");
    CHECK(mistake_in("A ~ I(\"x)") == "1:7 expected a closing quotation mark for this one, found the end of the line");
}

TEST_CASE("reading goes on behind a mistake") {
    const ParsedShapeGrammar parsed = read_shape_grammar("A ~ T(\nB ~ S()\nC ~ C2 D ) \nD ~ I(\"x\")\n");
    REQUIRE(parsed.mistakes.size() == 3);
    CHECK(parsed.mistakes[0].place.line == 1);
    CHECK(parsed.mistakes[1].place.line == 2);
    CHECK(parsed.mistakes[2].place.line == 3);
    REQUIRE(!parsed.grammar.rules.empty());
    CHECK(parsed.grammar.rules.back().symbol == "D");
    CHECK_THROWS_AS(parse_shape_grammar("A ~ T("), InputError);
}

TEST_CASE("brackets in each other have a bound") {
    CHECK(!mistake_in("A ~ " + std::string(5000, '[') + std::string(5000, ']')).empty());
    std::string locks = "A ~ ";
    for (int i = 0; i < 5000; ++i) locks += "Lock{";
    CHECK(!mistake_in(locks + std::string(5000, '}')).empty());
    CHECK(!mistake_in("A ~ T(" + std::string(5000, '(') + "1" + std::string(5001, ')')).empty());
}

TEST_CASE("a text is a shape grammar by its first statement") {
    CHECK(looks_like_shape_grammar("# x\n\nparam u = 2\n"));
    CHECK(looks_like_shape_grammar("A ~ I(\"x\")\n"));
    CHECK(!looks_like_shape_grammar("lsystem 1\naxiom: A\nA -> f(1)\n"));
    CHECK(!looks_like_shape_grammar(""));
}

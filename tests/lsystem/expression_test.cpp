#include "lsystem/expression.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/random.h"
#include "lsystem/derive.h"
#include "random_grammar.h"

using namespace rinceau;

/// The value of an expression without names, by way of a module that is derived.
static double value_of(const std::string& text) {
    Grammar grammar;
    grammar.axiom = {{"A", {parse_expression(text)}}};
    return derive(grammar).modules.at(0).arguments.at(0);
}

static int column_of_fault(const std::string& text) {
    try {
        parse_expression(text, {"x.lsys", 7, 1});
    } catch (const InputError& error) {
        CHECK(error.place().line == 7);
        return error.place().column;
    }
    return 0;
}

TEST_CASE("operators bind as in mathematics") {
    CHECK(value_of("1+2*3") == 7);
    CHECK(value_of("(1+2)*3") == 9);
    CHECK(value_of("7-2-1") == 4);
    CHECK(value_of("2^3^2") == 512);
    CHECK(value_of("-2^2") == -4);
    CHECK(value_of("2^-1") == 0.5);
    CHECK(value_of("12/2/3") == 2);
    CHECK(value_of("-7 % 3") == 2);
    CHECK(value_of("1 < 2 && 2 < 1 || 3 == 3") == 1);
    CHECK(value_of("!(1 > 2)") == 1);
    CHECK(value_of("1 + 1 == 2") == 1);
}

TEST_CASE("angles of functions are degrees, and quarter turns are exact") {
    CHECK(value_of("sin(30)") == Approx(0.5));
    CHECK(value_of("cos(90)") == 0);
    CHECK(value_of("sin(-450)") == -1);
    CHECK(value_of("atan2(1, 1)") == Approx(45));
    CHECK(value_of("acos(0)") == Approx(90));
}

TEST_CASE("functions and constants give their values") {
    CHECK(value_of("min(3, 1, 2) + max(3, 1, 2)") == 4);
    CHECK(value_of("pow(2, 10)") == 1024);
    CHECK(value_of("round(-2.5) + floor(2.7) + ceil(2.1) + sign(-3) + abs(-4)") == Approx(5));
    CHECK(value_of("log(e)") == Approx(1));
    CHECK(value_of("sqrt(2)*sqrt(2)") == Approx(2));
    CHECK(value_of("pi") == Approx(3.14159265358979));
}

TEST_CASE("a faulty expression is reported at the character that is at fault") {
    CHECK(column_of_fault("1 + ") == 5);
    CHECK(column_of_fault("(1 + 2") == 7);
    CHECK(column_of_fault("1 2") == 3);
    CHECK(column_of_fault("3 + foo(1)") == 5);
    CHECK(column_of_fault("sin(1, 2)") == 1);
    CHECK(column_of_fault("1e999") == 1);
    CHECK(column_of_fault("a $ b") == 3);
    CHECK(column_of_fault("") == 1);
}

TEST_CASE("expressions nested without end are refused, long ones are not") {
    const std::string deep(100'000, '(');
    CHECK_THROWS_AS(parse_expression(deep), InputError);
    CHECK_THROWS_AS(parse_expression(std::string(100'000, '-') + "1"), InputError);
    std::string sum = "0";
    for (int i = 0; i < 20'000; ++i) sum += "+1";
    CHECK(value_of(sum) == 20'000);
    CHECK(to_text(parse_expression(sum)) == sum);
    for (int i = 0; i < 60'000; ++i) sum += "+1";
    CHECK_THROWS_AS(parse_expression(sum), InputError);
}

TEST_CASE("the text of an expression is short and reads back as the same expression") {
    CHECK(to_text(parse_expression(" ( m - 1 ) ")) == "m-1");
    CHECK(to_text(parse_expression("m>0")) == "m > 0");
    CHECK(to_text(parse_expression("a-(b-c)")) == "a-(b-c)");
    CHECK(to_text(parse_expression("(a*b)+(c/d)")) == "a*b+c/d");
    CHECK(to_text(parse_expression("min(a,b+1)")) == "min(a, b+1)");
    CHECK(to_text(number_expression(-0.1)) == "-0.1");
    CHECK(to_text(number_expression(100'000)) == "100000");
    CHECK(to_text(number_expression(1e-9)) == "1e-09");
    Random random(11);
    for (int i = 0; i < 3000; ++i) {
        const Expression expression = random_expression(random, {"m", "n_2", "e"}, 5);
        INFO(to_text(expression));
        REQUIRE(parse_expression(to_text(expression)) == expression);
    }
}

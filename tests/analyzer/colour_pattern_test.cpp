#include <catch2/catch.hpp>

#include "analyzer/colour_pattern.h"

using namespace rinceau;

namespace {

constexpr double exception_bits = 20;

/// A row of these tints for each owner, the first at the largest m.
TintColumn rows(const std::vector<std::vector<Tint>>& tints) {
    TintColumn column;
    column.owners = static_cast<int>(tints.size());
    column.counter = "m";
    for (std::size_t owner = 0; owner < tints.size(); ++owner) {
        const auto count = static_cast<int>(tints[owner].size());
        column.counts.push_back(count);
        for (int k = 0; k < count; ++k)
            column.uses.push_back({static_cast<int>(owner), count - k, tints[owner][static_cast<std::size_t>(k)]});
    }
    return column;
}

TintPattern pattern_of(const TintColumn& column) { return shortest_pattern(column, {}, "c", exception_bits); }

}  // namespace

TEST_CASE("tints that count along a row are linear in the counter") {
    const TintPattern found = pattern_of(rows({{1, 2, 3, 4, 5, 6, 7, 8}}));
    CHECK(found.expression == parse_expression("9 - m"));
    CHECK(found.departures.empty());
}

TEST_CASE("tints that count on behind a gap jump there") {
    TintColumn column = rows({{1, 2, 3, 4, 0, 5, 6, 7, 8, 9}});
    std::erase_if(column.uses, [](const TintUse& use) { return use.tint == 0; });
    const TintPattern found = pattern_of(column);
    CHECK(found.departures.empty());
    CHECK(found.parameter.empty());
    CHECK(found.bits < exception_bits);
}

TEST_CASE("rows that alternate from either colour on have their phase as parameter") {
    const TintPattern found = pattern_of(rows({{1, 2, 1, 2, 1, 2}, {2, 1, 2, 1, 2, 1}, {1, 2, 1, 2, 1, 2}}));
    CHECK(found.expression == parse_expression("1 + (m + c) % 2"));
    CHECK(found.departures.empty());
    CHECK(found.parameter == std::vector<Tint>{0, 1, 0});
}

TEST_CASE("all are a copy's own but the last, which is alike everywhere") {
    const TintPattern found = pattern_of(rows({{3, 9}, {4, 9}, {5, 9}, {7, 9}, {8, 9}, {2, 9}}));
    CHECK(found.expression == parse_expression("if(m == 1, 9, c)"));
    CHECK(found.departures.empty());
    CHECK(found.parameter == std::vector<Tint>{3, 4, 5, 7, 8, 2});
    const TintPattern first = pattern_of(rows({{1, 3, 3, 3}, {1, 2, 2, 2}, {1, 7, 7, 7}, {1, 8, 8, 8}}));
    CHECK(first.expression == parse_expression("if(m == 4, 1, c)"));
}

TEST_CASE("one that departs is left to an exception, with what is missing") {
    const TintPattern found = pattern_of(rows({{3, 3, 3, 3}, {3, 3, 5, 3}, {3, 3, 3, 3}, {3, 3, 3, 3}}));
    CHECK(found.expression == number_expression(3));
    CHECK(found.departures == std::vector<int>{6});
    CHECK(found.missing == std::vector<Tint>{2});
}

TEST_CASE("what follows from a known parameter takes no new one") {
    TintColumn column;
    column.owners = 3;
    column.uses = {{0, 0, 7}, {1, 0, 9}, {2, 0, 12}};
    const std::vector<TintParameter> known{{"c", {2, 4, 7}}};
    const TintPattern found = shortest_pattern(column, known, "d", exception_bits);
    CHECK(found.expression == parse_expression("c + 5"));
    CHECK(found.parameter.empty());
}

TEST_CASE("no expression chooses a style that is not there") {
    TintColumn column = rows({{1, 2, 3, 4, 5, 6, 6, 6}});
    column.styles = 6;
    const TintPattern found = pattern_of(column);
    CHECK(found.expression != parse_expression("9 - m"));
}

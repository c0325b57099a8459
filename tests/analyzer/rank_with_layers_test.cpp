#include <catch2/catch.hpp>

#include "analyzer/generate_rules.h"
#include "analyzer/paint_order.h"
#include "analyzer/prepare_drawing.h"
#include "analyzer/rank_with_layers.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "geometry/random.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// A row of cards in two colours, each over or under its neighbours, in any order.
Scene row_in_any_order() {
    const Scene row = drawn_scene(known_grammar("axiom: P(24)\nP(m) : m > 0 -> [A] -(90) f(6) +(90) P(m-1)",
                                                {{"A", element(rectangle(16, 30), filled({200, 20, 40}))}}));
    Random random(7);
    Scene mixed = shuffled(row, random);
    for (std::size_t e = 0; e < mixed.elements.size(); e += 2) mixed.elements[e].style.fill = Color{0, 60, 150};
    return mixed;
}

/// Its rule and its list, which needs no layers.
struct Descriptions {
    Scene scene = row_in_any_order();
    PreparedDrawing prepared = prepare_drawing(scene);
    Drawing drawing{scene, prepared.readings.back().instancing, prepared.overlaps, prepared.diagonal, 5000, 1};
    Description rule = *describe(drawing, generate_rules(prepared.readings.back().starts.front(), {}).rules, 0.01);
    Description list = flat_description(drawing);
    double layers = bits_of(rule, with_paint_order(rule.exact, rule.written.element_of_leaf, prepared.overlaps)).grammar -
                    rule.bits.grammar;
};

}  // namespace

TEST_CASE("rules whose layers cost more than they save give way to others") {
    Descriptions d;
    REQUIRE(d.rule.exact.productions.size() == 1);
    REQUIRE(d.layers > 0.1 * d.rule.cost);
    d.list.cost = d.rule.cost + 0.5 * d.layers;
    for (const int threads : {1, 2}) {
        const auto ranked = ranked_with_layers({d.rule, d.list}, d.prepared.overlaps, threads);
        REQUIRE(ranked.size() == 2);
        CHECK(ranked[0].exact.productions.empty());
        CHECK(ranked[1].exact.productions.size() == 1);
    }
}

TEST_CASE("layers change no order where they cost nothing, too little, or as much in the others") {
    Descriptions d;
    const auto rule_is_first = [&](double cost_of_list, const Overlaps& overlaps, const Description& second) {
        std::vector<Description> both{d.rule, second};
        both[1].cost = cost_of_list;
        return ranked_with_layers(std::move(both), overlaps, 1)[0].cost == d.rule.cost;
    };
    CHECK(rule_is_first(d.rule.cost + 1, {}, d.list));                                // nothing overlaps
    CHECK(rule_is_first(d.rule.cost + 1.1 * d.layers, d.prepared.overlaps, d.list));  // dearer all the same
    CHECK(rule_is_first(d.rule.cost - 1, d.prepared.overlaps, d.rule));               // first for another reason
    CHECK_FALSE(rule_is_first(d.rule.cost - 1, d.prepared.overlaps, d.list));
}

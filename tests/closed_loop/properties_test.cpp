// What holds for any drawing and any weights: no junk, and the grammar draws the drawing. (Where the drawing lies and in which
// order: invariance_test.)

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/listed_scenes.h"
#include "closed_loop/scenes.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// Listed scenes that are quick to analyse, each once.
std::vector<ListedScene> small_scenes() {
    constexpr std::size_t few = 100;  // elements
    std::vector<ListedScene> scenes;
    for (const auto& family : {exception_scenes(), progress_scenes(), style_scenes(), whole_scenes()}) {
        for (const ListedScene& scene : family) {
            if (scene.make(1).elements.size() <= few) scenes.push_back(scene);
        }
    }
    return scenes;
}

/// The least distance of an element's box to that of one of `scene`, which is then taken; in lengths of the scene.
class Matcher {
  public:
    explicit Matcher(const Scene& scene) {
        for (const Element& element : scene.elements) boxes_.push_back(bounds(element.paths));
    }
    double take_nearest(const Box& box) {
        const auto away = [&](const Box& other) { return std::max(abs(other.low - box.low), abs(other.high - box.high)); };
        const auto nearest = std::ranges::min_element(boxes_, {}, away);
        if (nearest == boxes_.end()) return 1e300;
        const double distance = away(*nearest);
        boxes_.erase(nearest);
        return distance;
    }

  private:
    std::vector<Box> boxes_;
};

std::vector<ImportanceWeights> corners_of_the_weights() {
    std::vector<ImportanceWeights> weights;
    for (const double n : {0.25, 4.0})
        for (const double h : {0.0, 4.0})
            for (const double phi : {0.0, 4.0})
                for (const double l : {0.0, 4.0}) weights.push_back({n, h, phi, l});
    weights.push_back({0, 1, 1, 1});
    weights.push_back({0, 0, 0, 0});
    weights.push_back({4, 4, 4, 4});
    return weights;
}

/// Symbols that the axiom or a production calls.
std::set<std::string> called_symbols(const Grammar& grammar) {
    std::set<std::string> called;
    for (const ModuleTemplate& module : grammar.axiom) called.insert(module.symbol);
    for (const Production& production : grammar.productions) {
        for (const ModuleTemplate& module : production.successor) {
            if (module.symbol != production.symbol) called.insert(module.symbol);
        }
    }
    return called;
}

void check_no_junk(const Analysis& found) {
    CHECK(found.report.check.passed);
    CHECK(found.report.grammar_bits <= found.report.drawing_bits);
    const std::set<std::string> called = called_symbols(found.grammar);
    for (const ProductionReport& production : found.report.productions) {
        INFO(production.body);
        CHECK(called.count(production.symbol) == 1);
        CHECK(production.instances >= 1);
        // One pair, used once, says nothing, unless it makes one symbol of the whole drawing.
        const bool one_pair = production.instances == 1 && production.lengths == std::vector<int>{2};
        const bool in_axiom = std::ranges::count(found.grammar.axiom, production.symbol, &ModuleTemplate::symbol) > 0;
        CHECK((!one_pair || in_axiom || production.kind == "group"));
    }
}

}  // namespace

TEST_CASE("no weights make junk") {
    const std::vector<ImportanceWeights> weights = corners_of_the_weights();
    for (const KnownScene& known : known_scenes()) {
        if (known.scene.elements.size() > 100) continue;
        for (const ImportanceWeights& w : weights) {
            INFO(known.name << " n=" << w.count << ",h=" << w.nearness << ",phi=" << w.similarity << ",l=" << w.length);
            const Analysis found = analyze(known.scene, {.weights = w});
            INFO(rules_in_words(found.report));
            check_no_junk(found);
            if (known.rules == 0) CHECK(found.report.productions.empty());
        }
    }
}

TEST_CASE("any small drawing is drawn again, without junk") {
    for (const ListedScene& listed : small_scenes()) {
        const Scene scene = listed.make(1);
        const Analysis found = analyze(scene);
        INFO(listed.name << ": " << rules_in_words(found.report) << "\n" << to_text(found.grammar));
        check_no_junk(found);
        const Scene drawn = to_scene(found.grammar, interpret(found.grammar));
        REQUIRE(drawn.elements.size() == scene.elements.size());
        Matcher matcher(drawn);
        double worst = 0;
        for (const Element& element : scene.elements) worst = std::max(worst, matcher.take_nearest(bounds(element.paths)));
        CHECK(worst < 3e-4 * drawing_diagonal(scene));
    }
}

TEST_CASE("a small drawing whose rules are found has the same rules when it is moved, turned, scaled, mirrored and shuffled") {
    // Copies of a motif are grouped in an order that depends on where they lie; no mirror image of the whole is tried.
    const std::set<std::string> depends{"mirrored", "moved_mirrored"};
    // A half and its mirror image are a pair (a mirrored sequence of 2) or two halves about an axis (a group of 2): as many rules.
    const std::set<std::string> pairs_or_halves{"dihedral_6", "dihedral_8"};
    Random random(5);
    int found = 0;
    for (const ListedScene& listed : small_scenes()) {
        const Scene scene = carried(listed.make(1), {});
        const Analysis before = analyze(scene);
        if (!is_found(listed, before) || depends.count(listed.name) > 0) continue;
        ++found;
        INFO(listed.name << ": " << rules_in_words(before.report));
        for (const Similarity& map : {translate({1234.5, -678.25}), rotate(radians(90)), Similarity{polar(2.5, 1.1), {-300, 40}, true}}) {
            const Scene changed = carried(scene, map);
            const bool order_shows = listed.name == "facade_doors";
            const Analysis after = analyze(order_shows ? changed : shuffled(changed, random));
            if (pairs_or_halves.count(listed.name) == 0) CHECK(rules_in_words(after.report) == rules_in_words(before.report));
            CHECK(is_found(listed, after));
        }
    }
    CHECK(found >= 8);
}

TEST_CASE("every listed scene has a name of its own and comes again for the same seed") {
    std::set<std::string> names;
    for (const ListedScene& listed : listed_scenes(0)) {
        INFO(listed.name);
        CHECK(names.insert(listed.name).second);
        CHECK(listed.rules <= listed.most_rules);
        const Scene once = listed.make(1), again = listed.make(1);
        CHECK(once.elements.size() >= 5);
        REQUIRE(once.elements.size() == again.elements.size());
        CHECK(bounds(once.elements.back().paths).low == bounds(again.elements.back().paths).low);
    }
}

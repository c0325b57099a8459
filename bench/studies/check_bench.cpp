// Seconds that overlaps, paint order and the independent check take by themselves: one line a scene.

#include <chrono>
#include <cstdio>
#include <numeric>

#include "analyzer/overlaps.h"
#include "analyzer/paint_order.h"
#include "analyzer/verify.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

template <class Work>
double seconds_of(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Touching tiles in rows, painted in the order that `order` gives; every tile an outline of its own colours.
void run(const char* name, int side, bool shuffle) {
    const std::string n = std::to_string(side);
    Style style = filled({200, 80, 40});
    style.stroke.paint = Color{0, 0, 0};
    style.stroke.width = 0.05;
    const Grammar grammar = known_grammar("axiom: Q(" + n + ")\nQ(n) : n > 0 -> [P(" + n + ")] f(2) Q(n-1)\nP(m) : m > 0 -> [A] -(90) f(2) +(90) P(m-1)",
                                          {{"A", element(circle(1.05), style)}});
    Scene scene = drawn_scene(grammar);
    Random random(1);
    std::vector<int> element_of_leaf(scene.elements.size());
    std::iota(element_of_leaf.begin(), element_of_leaf.end(), 0);
    if (shuffle) {
        for (std::size_t i = scene.elements.size(); i > 1; --i) {
            std::swap(element_of_leaf[i - 1], element_of_leaf[random.below(static_cast<std::uint32_t>(i))]);
        }
        Scene ordered = scene;
        for (std::size_t k = 0; k < scene.elements.size(); ++k) {
            ordered.elements[static_cast<std::size_t>(element_of_leaf[k])] = scene.elements[k];
        }
        scene = ordered;
    }
    Overlaps overlaps;
    const double overlap_seconds = seconds_of([&] { overlaps = find_overlaps(scene); });
    Grammar ordered;
    const double order_seconds = seconds_of([&] { ordered = with_paint_order(grammar, element_of_leaf, overlaps); });
    Verification check;
    const double verify_seconds = seconds_of([&] { check = verify(ordered, rounded(scene, 1e-3)); });
    std::printf("%-16s %7zu  %8zu  %9zu  %8.3f  %8.3f  %8.3f  %s\n", name, scene.elements.size(), overlaps.pairs.size(),
                ordered.exceptions.size(), overlap_seconds, order_seconds, verify_seconds, check.summary.c_str());
    std::fflush(stdout);
}

}  // namespace

int main() {
    std::printf("%-16s %7s  %8s  %9s  %8s  %8s  %8s\n", "scene", "N", "overlaps", "excepted", "overlaps", "order", "verify");
    run("tiles in order", 100, false);
    run("tiles shuffled", 100, true);
    run("tiles in order", 316, false);
    run("tiles shuffled", 316, true);
}

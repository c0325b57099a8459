// Drawings that look the same when turned, mirrored or moved as a whole, and in which nothing else repeats.

#include <numeric>

#include "closed_loop/known_grammar.h"
#include "closed_loop/listed_scenes.h"

namespace rinceau::test {

namespace {

/// `count` elements of as many kinds in a box, none of which repeats another: what a sector holds.
std::vector<Element> motif(int count, const Box& where, Random& random) {
    std::vector<Element> elements;
    for (int k = 0; k < count; ++k) {
        const Point at{random.uniform(where.low.x, where.high.x), random.uniform(where.low.y, where.high.y)};
        const Similarity pose{polar(random.uniform(3, 6), random.uniform(-pi, pi)), at, false};
        elements.push_back(placed(element(blob(5 + k % 4, random), filled(random_color(random))), pose));
    }
    return elements;
}

Scene carried_by(const std::vector<Element>& motif, const std::vector<Similarity>& maps, std::uint64_t seed) {
    Scene scene;
    for (const Similarity& map : maps) {
        for (const Element& each : motif) {
            scene.elements.push_back(placed(each, map));
            scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
        }
    }
    Random random(seed);
    return shuffled(rounded(scene, 1e-3), random);
}

std::vector<Similarity> rotations(int fold) {
    std::vector<Similarity> maps;
    for (int k = 0; k < fold; ++k) maps.push_back(rotate(two_pi * k / fold));
    return maps;
}

std::vector<Similarity> with_mirror_images(std::vector<Similarity> maps) {
    const std::size_t count = maps.size();
    for (std::size_t k = 0; k < count; ++k) maps.push_back(maps[k] * mirror_about_heading());
    return maps;
}

/// In a narrow sector about +y, away from its borders.
constexpr Box sector{{8, 60}, {24, 160}};

}  // namespace

std::vector<ListedScene> whole_scenes() {
    const auto scene = [](const char* name, int most_rules, int elements, const Box& where, const std::vector<Similarity>& maps) {
        return ListedScene{"whole", name, 1, most_rules, 1, 0, 1, [=](std::uint64_t seed) {
                               Random random(seed);
                               return carried_by(motif(elements, where, random), maps, seed);
                           }};
    };
    return {
        scene("turned_5", 2, 10, sector, rotations(5)),
        scene("turned_6", 2, 6, sector, rotations(6)),
        scene("dihedral_6", 3, 6, sector, with_mirror_images(rotations(6))),
        scene("dihedral_8", 3, 4, sector, with_mirror_images(rotations(8))),
        scene("mirrored", 2, 16, {{8, 0}, {80, 100}}, with_mirror_images({Similarity{}})),
        scene("moved_3", 2, 12, {{0, 0}, {60, 100}}, {Similarity{}, translate({90, 0}), translate({180, 0})}),
        scene("moved_mirrored", 2, 12, {{0, 0}, {60, 100}}, {Similarity{}, translate({90, 20}) * mirror_about_heading()}),
    };
}

}  // namespace rinceau::test

#include "analyzer/same_picture.h"

#include <array>

#include "geometry/box_tree.h"
#include "geometry/parallel.h"
#include "scene/svg_raster.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

constexpr int picture_width = 900;  // pixels
constexpr double allowed = 0.002;   // of the inked pixels

double difference(const std::array<const Scene*, 2>& scenes, int threads, const Progress& progress) {
    std::array<Picture, 2> pictures;
    for_each_index(scenes.size(), threads, "check", progress, [&](std::size_t k, const Progress&) {
        pictures[k] = svg_to_picture(write_svg(*scenes[k]), picture_width);
    });
    return picture_difference(pictures[0], pictures[1]);
}

/// Where the order of the pairs can show.
std::vector<Box> places_of(const Scene& scene, const std::vector<OverlapPair>& pairs) {
    const double across = width(scene.viewport) > 0 ? width(scene.viewport) : drawing_diagonal(scene);
    const double margin = 2 * across / picture_width;  // pixels are compared with those next to them
    std::vector<Box> places;
    for (const OverlapPair& pair : pairs) {
        const Box a = grown(painted_box(scene.elements[static_cast<std::size_t>(pair.lower)]), margin);
        const Box b = grown(painted_box(scene.elements[static_cast<std::size_t>(pair.upper)]), margin);
        places.push_back({{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
                          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}});
    }
    return places;
}

/// The elements that paint in one of the places.
Scene painted_there(const Scene& scene, const BoxTree& places) {
    Scene there{scene.viewport, scene.sized, {}};
    for (const Element& element : scene.elements) {
        const Box box = painted_box(element);
        const bool unknown = !element.verbatim.empty() && is_empty(box);
        if (unknown || !places.visit(box, [](std::size_t) { return false; })) there.elements.push_back(element);
    }
    return there;
}

}  // namespace

bool same_picture(const Scene& scene, const Scene& drawn, const std::vector<OverlapPair>& exchanged, int threads,
                  const Progress& progress) {
    // What is painted elsewhere is the same in both, and can only make the share of different pixels smaller.
    const std::vector<Box> places = places_of(scene, exchanged);
    const BoxTree tree(places);
    const Scene scene_there = painted_there(scene, tree), drawn_there = painted_there(drawn, tree);
    if (difference({&scene_there, &drawn_there}, threads, progress) <= allowed) return true;
    const bool everything = scene_there.elements.size() == scene.elements.size();
    return !everything && difference({&scene, &drawn}, threads, progress) <= allowed;
}

}  // namespace rinceau

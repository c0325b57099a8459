// What of a drawing can be laid, how large, from where; the rest is laying (lay_script.h) and lifting (laid_meshes.h).

#include "growth/surface/grow_drawing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "geometry/index.h"
#include "growth/surface/laid_meshes.h"
#include "growth/surface/start_place.h"
#include "growth/surface/terminal_art.h"

namespace rinceau {
namespace {

constexpr double default_share = 0.5;      // of the surface's diagonal that the drawing's becomes
constexpr double curve_deviation = 4e-3;   // of an element's radius
constexpr double finest_deviation = 2e-5;  // of the surface's diagonal
constexpr double background_share = 0.97;  // of the drawing's box that an element fills to be its background

/// A drawing that does not lie whole at its own size is tried smaller, down to this share of it; a compact one, which would
/// come apart when walked, then also stretched, and smaller.
constexpr double smaller_step = 0.8;
constexpr double least_share = 0.4, least_compact_share = 0.2;

/// Boxes of the placed terminals' paths in the drawing.
std::vector<Box> drawn_boxes(const Grammar& grammar, const TurtleScript& script) {
    std::vector<Box> of_terminal;
    for (const Terminal& terminal : grammar.terminals) of_terminal.push_back(bounds(terminal.paths));
    std::vector<Box> boxes;
    for (const Placement& placement : script.elements) {
        const Box& box = of_terminal[at(placement.terminal)];
        Box drawn;
        if (!is_empty(box))
            for (const Point p : {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
                drawn = including(drawn, apply(placement.pose, p));
        boxes.push_back(drawn);
    }
    return boxes;
}

Box united(const std::vector<Box>& boxes) {
    return std::accumulate(boxes.begin(), boxes.end(), Box{}, [](const Box& a, const Box& b) { return including(a, b); });
}

/// The lowest elements while they fill the whole drawing: the surface takes their place.
std::vector<bool> backgrounds(const TurtleScript& script, const std::vector<DrawnElement>& drawn) {
    std::vector<bool> is_background(drawn.size(), false);
    Box all;
    for (const DrawnElement& element : drawn) all = including(all, element.box);
    std::vector<int> order(drawn.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int i) { return script.elements[at(i)].layer; });
    std::size_t left = drawn.size();
    for (const int i : order) {
        const DrawnElement& element = drawn[at(i)];
        if (element.art == nullptr) continue;
        const double filled = element.art->layers.front().area * norm(element.pose.linear);
        if (--left == 0 || filled < background_share * width(all) * height(all)) break;
        is_background[at(i)] = true;
    }
    return is_background;
}

DrawingStand first_stand(const SurfaceMesh& surface, const FieldOnSurface* field, const GrowDrawingOptions& options,
                         const TurtleWays& ways, const Box& drawn) {
    const SurfacePoint place = options.start ? *options.start : start_place(surface, 0.5 * ways.scale * diagonal(drawn));
    constexpr Complex drawn_up{0, 1};
    const Complex up = start_up(surface, field, place) * polar(1, options.heading * pi / 180);
    const DrawingStand stand{place, up * conj(drawn_up), options.start ? Point{} : center(drawn)};
    // the turtle begins where it would have come from the drawing's middle
    return moved(surface, ways, stand, {}).value_or(stand);
}

std::string counted(long count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

void add_warnings(GrownDrawing& grown, const ArtLosses& losses, long left_out) {
    auto& warnings = grown.pattern.warnings;
    if (left_out > 0)
        warnings.push_back(counted(left_out, "element fills", "elements fill") +
                           " the whole drawing and stays away: the surface is the background");
    if (losses.verbatim > 0)
        warnings.push_back(counted(losses.verbatim, "fragment", "fragments") + " of SVG cannot be laid on a surface");
    if (losses.gradients > 0)
        warnings.push_back(counted(losses.gradients, "element is", "elements are") +
                           " laid in the mean colour of its gradient");
    if (losses.translucent > 0)
        warnings.push_back(counted(losses.translucent, "translucent element is", "translucent elements are") +
                           " laid opaque, mixed with the ground's colour");
}

std::string place_text(const SurfaceMesh& surface, SurfacePoint at_place) {
    const SpacePoint p = position_in_space(surface, at_place);
    const auto number = [](double v) {
        std::string text = std::to_string(v);
        return text.substr(0, text.find('.') + 5);
    };
    return number(p.x) + " " + number(p.y) + " " + number(p.z);
}

void add_losses(GrownDrawing& grown, const Grammar& grammar, const SurfaceMesh& surface, const TurtleScript& script,
                const LaidScript& laid) {
    if (laid.dropped.empty()) return;
    const LayLoss& first = laid.dropped.front();
    const std::string& name = grammar.terminals[at(script.elements[at(first.element)].terminal)].symbol;
    grown.pattern.warnings.push_back(counted(static_cast<long>(laid.dropped.size()), "element does", "elements do") +
                                     " not lie on the surface without a fold, the first is " + name + " at " +
                                     place_text(surface, first.at) + "; a smaller --scale helps");
}

/// Does it lie flat in the plane of x and y?
bool is_plane(const SurfaceMesh& surface) {
    constexpr double level = 1e-12;
    return std::ranges::all_of(surface.frame, [&](const auto& frame) { return frame[2].z > 1 - level; });
}

/// Laid shapes of a plane as what they are: the drawing's terminals, moved and turned.
std::vector<Placement> plane_placements(const SurfaceMesh& surface, const TurtleScript& script,
                                        const std::vector<LaidShape>& shapes, const std::vector<int>& order) {
    std::vector<Placement> placements;
    for (const int i : order) {
        const LaidShape& shape = shapes[at(i)];
        const SpacePoint middle = position_in_space(surface, shape.middle);
        const SpacePoint x = direction_in_space(surface, shape.middle.face, shape.turn);
        Placement& placement = placements.emplace_back(script.elements[at(shape.element)]);
        placement.pose = Similarity{{x.x, x.y}, {middle.x, middle.y}, false} * shape.pose;
    }
    return placements;
}

}  // namespace

GrownDrawing grow_drawing(const Grammar& grammar, const SurfaceMesh& surface, const FieldOnSurface* field,
                          const GrowDrawingOptions& options, const Progress& progress) {
    DeriveOptions derive;
    derive.seed = options.seed;
    derive.depth = options.depth;
    const TurtleScript script = turtle_script(grammar, derive, options.max_shapes, progress);
    GrownDrawing grown;
    grown.elements = static_cast<long>(script.elements.size());
    const std::vector<Box> boxes = drawn_boxes(grammar, script);
    Box all = united(boxes);
    if (is_empty(all)) return grown;
    const double whole = std::max(diagonal(all), 1e-300);
    TurtleWays ways{field, options.follow, options.scale > 0 ? options.scale : default_share * surface.diagonal / whole};
    ArtStore store(grammar, curve_deviation, finest_deviation * surface.diagonal / ways.scale);
    std::vector<DrawnElement> elements;
    for (const Placement& placement : script.elements)
        elements.push_back(drawn_element(store.art(placement), placement.pose));
    const std::vector<bool> background = backgrounds(script, elements);
    long left_out = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (background[i]) {
            elements[i].art = nullptr;
            ++left_out;
        }
    Box drawn;
    for (const DrawnElement& element : elements)
        if (element.art != nullptr) drawn = including(drawn, element.box);
    if (is_empty(drawn)) drawn = all;
    LayScriptOptions laying{options.lay, options.stretch, options.meet_itself, options.height > 0};
    laying.ties = element_ties(elements);
    const auto lay_at = [&](double scale) {
        const TurtleWays ways_at{field, options.follow, scale};
        return lay_script(surface, script, elements, ways_at, first_stand(surface, field, options, ways_at, drawn), laying,
                          progress);
    };
    LaidScript laid;
    const bool may_choose = !(options.scale > 0) && options.lay != LayGroups::never;
    laying.whole_only = true;
    const bool is_compact = std::exchange(laying.ties.compact, false);
    for (double share = 1; may_choose && !laid.whole && share > least_share; share *= smaller_step)
        laid = lay_at(share * ways.scale);
    laying.ties.compact = is_compact;
    for (double share = 1; may_choose && is_compact && !laid.whole && share > least_compact_share; share *= smaller_step)
        laid = lay_at(share * ways.scale);
    laying.whole_only = false;
    if (!laid.whole) laid = lay_at(ways.scale);
    std::vector<int> layers, order(laid.shapes.size());
    for (const LaidShape& shape : laid.shapes) layers.push_back(script.elements[at(shape.element)].layer);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int i) { return layers[at(i)]; });
    // covers are told by the later derived of two; painting may want it the other way round
    std::vector<std::vector<int>> covers = laid.covers;
    for (std::size_t i = 0; i < laid.covers.size(); ++i)
        for (const int other : laid.covers[i]) covers[at(other)].push_back(static_cast<int>(i));
    LaidMeshOptions lifting;
    lifting.height = options.height;
    grown.pattern.laid = laid_meshes(surface, laid.shapes, paint_ranks(order, covers), layers, lifting);
    if (is_plane(surface)) grown.placements = plane_placements(surface, script, laid.shapes, order);
    grown.laid = static_cast<long>(laid.shapes.size());
    grown.shrunk = laid.shrunk;
    grown.split = laid.split;
    grown.spines = laid.spines;
    grown.stopped = laid.stopped;
    grown.dropped = static_cast<long>(laid.dropped.size());
    add_warnings(grown, store.losses(), left_out);
    add_losses(grown, grammar, surface, script, laid);
    return grown;
}

}  // namespace rinceau

// Ijiri et al. 2008, section 4, and what docs/growth.md adds to it: ties, the rule which rings are whole, exemplars that are
// tiles or lattices, and the figures about the exemplar that growth keeps to.

#include "growth/arrangement/exemplar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/kd_tree.h"
#include "growth/arrangement/connectivity.h"
#include "growth/arrangement/lattice_index.h"
#include "growth/arrangement/ring_likeness.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr std::size_t fewest_elements = 4;
constexpr double regular_tie = 0.25;
constexpr double irregular_tie = 0.1;

[[noreturn]] void fail(const std::string& label, const std::string& message) { throw InputError({label, 0, 0}, message); }

/// The points and, if they are a tile, their copies around, tile by tile.
std::vector<Point> tiled_positions(const std::vector<ExemplarPoint>& points, const std::optional<Box>& tile) {
    std::vector<Point> positions;
    for (const ExemplarPoint& p : points) positions.push_back(p.position);
    if (!tile) return positions;
    for (int row = -1; row <= 1; ++row)
        for (int column = -1; column <= 1; ++column) {
            if (row == 0 && column == 0) continue;
            const Point by{column * width(*tile), row * height(*tile)};
            for (const ExemplarPoint& p : points) positions.push_back(p.position + by);
        }
    return positions;
}

void check_positions(const std::vector<ExemplarPoint>& points, const ExemplarOptions& options, const std::string& label) {
    if (points.size() < fewest_elements && !(options.tile && !points.empty()))
        fail(label, "an exemplar needs at least 4 elements, and there are " + std::to_string(points.size()) +
                        "; draw more of them, or, if shapes that belong together count as one, leave them apart");
    if (options.tile && !(width(*options.tile) > 0 && height(*options.tile) > 0))
        fail(label, "the tile has no area; give it a width and a height");
}

struct ChosenConnectivity {
    Connectivity connectivity;
    bool irregular = true;
    std::optional<PointLattice> lattice;
};

/// A pattern is regular if either measure of ties makes its rings alike.
ChosenConnectivity chosen_connectivity(std::span<const Point> positions, std::size_t originals,
                                       const ExemplarOptions& options) {
    constexpr double regular = 0.6;  // share of like rings: lattices have 0.9 and more, scattered points 0
    ChosenConnectivity chosen;
    double best = -1;
    const std::vector<double> ties = options.tie > 0 ? std::vector{options.tie} : std::vector{regular_tie, irregular_tie};
    for (const double tie : ties) {
        Connectivity connectivity = connectivity_of(positions, {.tie = tie, .max_angle = options.max_angle});
        const double alike = alike_rings(positions, connectivity);
        if (alike > best || best < regular) chosen.connectivity = std::move(connectivity);
        best = std::max(best, alike);
        if (alike >= 1) break;
    }
    chosen.irregular = best < regular;
    // what was flipped by hand or merged by a given measure is meant as it is
    if (options.find_lattice && options.flips.empty() && !(options.tie > 0))
        chosen.lattice = find_lattice(positions, chosen.connectivity.spacing, originals);
    if (chosen.lattice) {
        chosen.connectivity = lattice_connectivity(positions, *chosen.lattice);
        chosen.irregular = false;
    }
    return chosen;
}

std::string edge_name(std::pair<int, int> edge) { return std::to_string(edge.first) + "-" + std::to_string(edge.second); }

/// Flips the edge in the drawing and wherever it is repeated.
Connectivity with_flip(std::span<const Point> positions, Connectivity connectivity, std::pair<int, int> flip, int originals,
                       const std::string& label) {
    if (std::min(flip.first, flip.second) < 0 || std::max(flip.first, flip.second) >= originals || flip.first == flip.second)
        fail(label, "edge " + edge_name(flip) + " cannot be flipped: elements are numbered from 0 to " +
                        std::to_string(originals - 1) + ", as the picture of the connectivity shows");
    std::vector<std::pair<int, int>> edges;
    for (int p = 0; p < static_cast<int>(positions.size()); ++p)
        for (const int q : connectivity.rings[static_cast<std::size_t>(p)])
            if (p % originals == flip.first && q % originals == flip.second) edges.emplace_back(p, q);
    if (edges.empty())
        fail(label, "edge " + edge_name(flip) +
                        " cannot be flipped, because these elements are not joined; the picture of the "
                        "connectivity shows which are");
    bool flipped = false;
    for (const auto& edge : edges)
        if (auto faces = flipped_edge(positions, connectivity, edge)) {
            connectivity = connectivity_from_faces(positions, std::move(*faces));
            flipped = true;
        }
    if (!flipped)
        fail(label, "edge " + edge_name(flip) +
                        " cannot be flipped, because the faces beside it are no two triangles that "
                        "form a convex quadrilateral; choose another edge");
    return connectivity;
}

/// Rings that are whole: none at the rim, and none that has a face with an edge on the rim, unless that leaves too few or a
/// lattice vouches for them.
std::vector<bool> usable_points(const std::vector<ExemplarPoint>& points, const ChosenConnectivity& chosen) {
    const Connectivity& connectivity = chosen.connectivity;
    constexpr std::ptrdiff_t few = 5;
    std::vector<bool> inner(points.size());
    std::vector<bool> deep(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
        inner[p] = points[p].whole && connectivity.inner[p];
        deep[p] = points[p].whole && connectivity.deep[p];
    }
    const auto candidates = std::ranges::count(inner, true);
    const auto good = std::ranges::count(deep, true);
    return chosen.lattice || good < few || 4 * good < candidates ? inner : deep;
}

void add_elements(const std::vector<ExemplarPoint>& points, std::span<const Point> positions,
                  const ChosenConnectivity& chosen, Exemplar& exemplar) {
    const Connectivity& connectivity = chosen.connectivity;
    const std::vector<bool> usable = usable_points(points, chosen);
    for (std::size_t p = 0; p < positions.size(); ++p) {
        const ExemplarPoint& original = points[p % points.size()];
        ExemplarElement element{.position = positions[p],
                                .symbol = original.symbol,
                                .sub_id = static_cast<int>(p % points.size()),
                                .outline = original.outline,
                                .usable = p < points.size() && usable[p]};
        if (chosen.lattice && chosen.lattice->index[p]) element.lattice = *chosen.lattice->index[p];
        for (const auto& polygon : element.outline)
            for (const Point corner : polygon) element.radius = std::max(element.radius, abs(corner));
        element.ring.elements = connectivity.rings[p];
        element.ring.joined = connectivity.joined[p];
        for (const int other : element.ring.elements)
            element.ring.offsets.push_back(positions[static_cast<std::size_t>(other)] - positions[p]);
        exemplar.elements.push_back(std::move(element));
    }
}

void add_edges(Exemplar& exemplar) {
    double sum = 0;
    std::size_t count = 0;
    exemplar.shortest_edge = std::numeric_limits<double>::infinity();
    exemplar.longest_edge = 0;
    for (std::size_t p = 0; p < exemplar.elements.size(); ++p)
        for (const int other : exemplar.elements[p].ring.elements) {
            if (other < static_cast<int>(p)) continue;
            exemplar.edges.emplace_back(static_cast<int>(p), other);
            if (p >= exemplar.originals) continue;
            const double edge =
                abs(exemplar.elements[static_cast<std::size_t>(other)].position - exemplar.elements[p].position);
            sum += edge;
            ++count;
            exemplar.shortest_edge = std::min(exemplar.shortest_edge, edge);
            exemplar.longest_edge = std::max(exemplar.longest_edge, edge);
        }
    std::ranges::sort(exemplar.edges);
    exemplar.mean_edge = sum / static_cast<double>(count);
}

/// Pairs of elements that stand near to each other, the first among the originals; lower first if both are.
std::vector<std::pair<int, int>> near_pairs(const Exemplar& exemplar, const KdTree& tree, double within) {
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t p = 0; p < exemplar.originals; ++p)
        for (const Neighbor& other : tree.within(exemplar.elements[p].position, within))
            if (other.index > p) pairs.emplace_back(static_cast<int>(p), static_cast<int>(other.index));
    return pairs;
}

void add_min_distances(const std::vector<std::pair<int, int>>& pairs, Exemplar& exemplar) {
    const std::size_t kinds = exemplar.symbols.size();
    exemplar.min_distance.assign(kinds, std::vector<double>(kinds, std::numeric_limits<double>::infinity()));
    for (const auto& [p, q] : pairs) {
        const ExemplarElement& a = exemplar.elements[static_cast<std::size_t>(p)];
        const ExemplarElement& b = exemplar.elements[static_cast<std::size_t>(q)];
        const auto i = static_cast<std::size_t>(a.symbol);
        const auto j = static_cast<std::size_t>(b.symbol);
        exemplar.min_distance[i][j] = std::min(exemplar.min_distance[i][j], abs(a.position - b.position));
        exemplar.min_distance[j][i] = exemplar.min_distance[i][j];
    }
}

bool outlines_overlap(const ExemplarElement& a, const ExemplarElement& b) {
    if (abs(a.position - b.position) >= a.radius + b.radius) return false;
    Region moved = b.outline;
    for (auto& polygon : moved)
        for (Point& corner : polygon) corner += b.position - a.position;
    if (!overlap(bounds(a.outline), bounds(moved))) return false;
    constexpr double touching = 1e-4;  // share of the smaller area: outlines are lines, and what touches does not overlap
    return area(intersection_of(a.outline, moved)) > touching * std::min(area(a.outline), area(moved));
}

/// Do outlines overlap as a rule? What the picture's edge cuts does not count, nor do single ones that touch by chance.
bool many_overlap(const std::vector<ExemplarPoint>& points, const std::vector<std::pair<int, int>>& pairs,
                  const Exemplar& exemplar) {
    constexpr double by_chance = 0.05;  // of the elements
    const auto is_whole = [&](int p) { return points[static_cast<std::size_t>(p) % points.size()].whole; };
    std::vector<bool> overlaps(points.size());
    for (const auto& [p, q] : pairs) {
        const std::size_t a = static_cast<std::size_t>(p) % points.size();
        const std::size_t b = static_cast<std::size_t>(q) % points.size();
        if ((overlaps[a] && overlaps[b]) || !is_whole(p) || !is_whole(q)) continue;
        if (outlines_overlap(exemplar.elements[static_cast<std::size_t>(p)], exemplar.elements[static_cast<std::size_t>(q)]))
            overlaps[a] = overlaps[b] = true;
    }
    return static_cast<double>(std::ranges::count(overlaps, true)) > by_chance * static_cast<double>(points.size());
}

/// Is the point among the faces, by the edges of the rim that lie to the right of it?
bool among_faces(Point at, std::span<const Point> positions, const Connectivity& connectivity) {
    bool inside = false;
    for (const auto& [p, q] : connectivity.rim) {
        const Point a = positions[static_cast<std::size_t>(p)];
        const Point b = positions[static_cast<std::size_t>(q)];
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

bool in_tile(Point at, const Box& tile) {
    return at.x >= tile.low.x && at.x < tile.high.x && at.y >= tile.low.y && at.y < tile.high.y;
}

/// The largest empty circle whose centre is among the faces, of a tile in its middle copy.
double largest_empty_circle(std::span<const Point> positions, const Connectivity& connectivity,
                            const std::optional<Box>& tile) {
    double largest = 0;
    for (const auto& face : connectivity.faces) {
        const FaceCircle circle = face_circle(positions, face);
        if (circle.radius <= largest || (tile && !in_tile(circle.center, *tile))) continue;
        if (tile || among_faces(circle.center, positions, connectivity)) largest = circle.radius;
    }
    return largest;
}

/// Elements per unit of area: exact on lattices, whatever their rim.
double density_of(const std::vector<ExemplarPoint>& points, const Connectivity& connectivity,
                  const std::optional<Box>& tile) {
    if (tile) return static_cast<double>(points.size()) / (width(*tile) * height(*tile));
    return 1 / (connectivity.spacing * connectivity.spacing);
}

void add_figures(const std::vector<ExemplarPoint>& points, std::span<const Point> positions,
                 const Connectivity& connectivity, Exemplar& exemplar) {
    exemplar.density = density_of(points, connectivity, exemplar.tile);
    exemplar.largest_empty = largest_empty_circle(positions, connectivity, exemplar.tile);
    for (const ExemplarPoint& p : points)
        exemplar.symbols[static_cast<std::size_t>(p.symbol)].share += 1 / static_cast<double>(points.size());
    for (ExemplarSymbol& symbol : exemplar.symbols) symbol.density = symbol.share * exemplar.density;
    constexpr double near = 3;  // mean edges: beyond, distances say nothing about who keeps away from whom
    const auto pairs = near_pairs(exemplar, KdTree(positions), near * exemplar.mean_edge);
    add_min_distances(pairs, exemplar);
    exemplar.outlines_overlap = many_overlap(points, pairs, exemplar);
}

void check_usable(const Exemplar& exemplar, const std::string& label) {
    const auto usable = std::ranges::count_if(exemplar.elements, &ExemplarElement::usable);
    if (usable == 0)
        fail(label,
             "no element has neighbours on all sides, so there is nothing to copy; draw at least one more row around, "
             "or say that the drawing is a tile");
    constexpr std::ptrdiff_t fewest_usable = 4;
    if (usable < fewest_usable && exemplar.irregular)
        fail(label,
             "only " + std::to_string(usable) + " of " + std::to_string(exemplar.originals) +
                 " elements have neighbours on all sides, and an irregular pattern needs 4; draw more elements, or say "
                 "that the drawing is a tile");
}

}  // namespace

Exemplar make_exemplar(const std::vector<ExemplarPoint>& points, const std::vector<std::string>& symbol_names,
                       const ExemplarOptions& options, const std::string& label) {
    check_positions(points, options, label);
    const std::vector<Point> positions = tiled_positions(points, options.tile);
    ChosenConnectivity chosen = chosen_connectivity(positions, points.size(), options);
    if (chosen.connectivity.faces.empty())
        fail(label, "the elements stand in one line or in one place; an exemplar needs neighbours on all sides");
    for (const auto& flip : options.flips)
        chosen.connectivity =
            with_flip(positions, std::move(chosen.connectivity), flip, static_cast<int>(points.size()), label);
    Exemplar exemplar{.originals = points.size(), .tile = options.tile, .irregular = chosen.irregular};
    for (const std::string& name : symbol_names) exemplar.symbols.push_back({.name = name});
    if (chosen.lattice) exemplar.lattice = {chosen.lattice->steps, chosen.lattice->basis};
    add_elements(points, positions, chosen, exemplar);
    check_usable(exemplar, label);
    add_edges(exemplar);
    add_figures(points, positions, chosen.connectivity, exemplar);
    return exemplar;
}

}  // namespace rinceau

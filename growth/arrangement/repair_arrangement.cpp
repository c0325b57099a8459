#include "growth/arrangement/repair_arrangement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/angle.h"
#include "geometry/polygon.h"
#include "growth/arrangement/node_links.h"
#include "growth/arrangement/outline_contact.h"
#include "growth/arrangement/place_element.h"
#include "growth/arrangement/reread_rings.h"
#include "growth/arrangement/stay_inside.h"

namespace rinceau {

namespace {

constexpr double tolerated_surplus = 0.02;  // of the exemplar's density
constexpr double removed_surplus = 0.8;     // the rest goes with what is done next
constexpr double around_hole = 1.35;        // of its radius: who stands so near is a neighbour of what fills it
constexpr std::size_t hole_neighbors = 10;  // the nearest of these
constexpr double along_line = 0.5;          // mean edges between places that are looked at beside lines
constexpr double most_places = 200'000;     // of these
constexpr double largest_hole = 4;          // times the exemplar's: what is larger was never meant to be filled

double corner_angle(Point before, Point at, Point after) {
    const Point a = before - at;
    const Point b = after - at;
    return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

// Elements of each symbol per unit of area: a face's corners belong to it by their angles, which is exact on lattices
// whatever the rim.
std::vector<double> densities(const ElementArrangement& arrangement, const GrowthGround& ground,
                              const ArrangementMesh& mesh) {
    std::vector<double> counts(ground.exemplar.symbols.size(), 0);
    double whole = 0;
    for (const std::vector<int>& face : mesh.connectivity.faces) {
        std::vector<Point> corners;
        bool grown = true;
        for (const int point : face) {
            corners.push_back(mesh.points[static_cast<std::size_t>(point)]);
            grown &= node_of(arrangement, mesh.nodes[static_cast<std::size_t>(point)]).reference >= 0;
        }
        if (!grown) continue;
        whole += signed_area(corners);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const int symbol = node_of(arrangement, mesh.nodes[static_cast<std::size_t>(face[k])]).symbol;
            const std::size_t last = face.size() - 1;
            counts[static_cast<std::size_t>(symbol)] +=
                corner_angle(corners[k > 0 ? k - 1 : last], corners[k], corners[k < last ? k + 1 : 0]) / two_pi;
        }
    }
    for (double& count : counts) count /= whole > 0 ? whole : 1;
    return counts;
}

double radius_of(const GrowthGround& ground, const ArrangementNode& node) {
    return ground.exemplar.elements[static_cast<std::size_t>(node.reference)].radius;
}

// What stands about a hole, as a ring.
TargetRing ring_about(const ElementArrangement& arrangement, const GrowthGround& ground, int seed, double radius) {
    std::vector<std::pair<double, int>> near;
    const Point at = node_of(arrangement, seed).position;
    arrangement.grid.visit(at, around_hole * radius, [&](int node, Point position) {
        if (node != seed) near.push_back({abs(position - at), node});
    });
    std::sort(near.begin(), near.end());
    if (near.size() > hole_neighbors) near.resize(hole_neighbors);
    std::vector<int> nodes;
    for (const auto& [distance, node] : near) nodes.push_back(node);
    return ring_of_nodes(arrangement, ground, seed, nodes);
}

bool keeps_distance(const ElementArrangement& arrangement, const GrowthGround& ground, int reference, Point at, int except,
                    double share) {
    const int symbol = ground.exemplar.elements[static_cast<std::size_t>(reference)].symbol;
    bool keeps = true;
    arrangement.grid.visit(at, share * ground.reach_of[static_cast<std::size_t>(symbol)], [&](int node, Point position) {
        const ArrangementNode& other = node_of(arrangement, node);
        if (node == except || !is_element(other)) return;
        keeps &= abs(position - at) >= share * least_distance(ground, symbol, other.symbol);
    });
    return keeps;
}

bool fill_hole(ElementArrangement& arrangement, const GrowthGround& ground, RingMatcher& matcher, int seed, double radius,
               double share, bool clear) {
    const TargetRing ring = ring_about(arrangement, ground, seed, radius);
    const std::vector<ReferenceMatch> matches = references_by_cost(arrangement, ground, matcher, seed, ring);
    const Point at = node_of(arrangement, seed).position;
    for (const ReferenceMatch& match : matches) {
        if (!keeps_distance(arrangement, ground, match.reference, at, seed, share)) continue;
        if (is_cut(ground, match.reference, match.angle, at)) continue;
        if (clear && !overlapped_elements(arrangement, ground, {match.reference, at, match.angle}, seed).empty()) continue;
        become_element(arrangement, ground, seed, match.reference, match.angle);
        for (std::size_t k = 0; k < ring.inner.size(); ++k) {
            const int other = ring.inner[k].node;
            const Point to = node_of(arrangement, other).position;
            if (crosses_edge(arrangement, at, to, seed, other, ground.exemplar.longest_edge) || is_barred(ground, at, to))
                continue;
            join_nodes(arrangement, seed, other);
            if (match.places[k] >= 0) fill_place(arrangement, ground, seed, other, match.places[k]);
        }
        return true;
    }
    return false;
}

// Seeds count as points: where one stands growth can go on.
bool is_hole(const ElementArrangement& arrangement, const GrowthGround& ground, Point at, const HoleLimits& limits) {
    double nearest = std::numeric_limits<double>::infinity();
    double clear = nearest;
    arrangement.grid.visit(at, std::max(limits.empty, limits.gap + ground.largest_radius), [&](int node, Point position) {
        const double distance = abs(position - at);
        nearest = std::min(nearest, distance);
        const ArrangementNode& other = node_of(arrangement, node);
        clear = std::min(clear, other.reference >= 0 ? distance - radius_of(ground, other) : distance);
    });
    return nearest > limits.empty || clear > limits.gap;
}

// The mesh ends short of the lines: places along both sides of them, where a hole that leans on a line has its middle.
std::vector<Point> places_along_lines(const GrowthGround& ground, const HoleLimits& limits) {
    std::vector<Point> places;
    const Boundary* boundary = ground.around.boundary.get();
    if (boundary == nullptr || ground.rigid) return places;
    const double step = along_line * ground.exemplar.mean_edge;
    const auto add = [&](Point a, Point b) {
        const double length = abs(b - a);
        const double count = std::ceil(length / step);
        if (!(length > 0) || static_cast<double>(places.size()) + 2 * count > most_places) return;
        const Point aside = (0.5 * limits.empty / length) * (Complex{0, 1} * (b - a));
        for (int i = 0; i < static_cast<int>(count); ++i) {
            const Point on = a + ((i + 0.5) / count) * (b - a);
            for (const Point at : {on + aside, on - aside})
                if (boundary->allows(at)) places.push_back(at);
        }
    };
    for (const Polyline& line : boundary->lines())
        for (std::size_t i = 1; i < line.size(); ++i) add(line[i - 1], line[i]);
    if (boundary->region())
        for (const std::vector<Point>& ring : *boundary->region())
            for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    return places;
}

// Elements on at least two sides: what has grown there has passed by.
bool has_grown_around(const ElementArrangement& arrangement, const GrowthGround& ground, Point at, double radius) {
    int count = 0;
    arrangement.grid.visit(at, 2 * radius, [&](int node, Point position) {
        if (is_element(node_of(arrangement, node)) && !is_barred(ground, position, at)) ++count;
    });
    return count >= 2;
}

}  // namespace

void thin_out(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh) {
    const std::vector<double> found = densities(arrangement, ground, mesh);
    std::vector<std::vector<std::pair<double, int>>> worst(found.size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const ArrangementNode& node = node_of(arrangement, mesh.nodes[i]);
        if (node.reference < 0 || node.held || !mesh.connectivity.inner[i]) continue;
        worst[static_cast<std::size_t>(node.symbol)].push_back(
            {-ring_misfit(arrangement, ground, mesh.nodes[i]), mesh.nodes[i]});
    }
    std::vector<char> beside(arrangement.nodes.size(), 0);
    for (std::size_t symbol = 0; symbol < found.size(); ++symbol) {
        const double wanted = ground.exemplar.symbols[symbol].density;
        if (!(found[symbol] > (1 + tolerated_surplus) * wanted)) continue;
        auto surplus =
            static_cast<int>(removed_surplus * (1 - wanted / found[symbol]) * static_cast<double>(worst[symbol].size()));
        std::sort(worst[symbol].begin(), worst[symbol].end());
        for (const auto& [misfit, node] : worst[symbol]) {
            if (surplus <= 0) break;
            if (beside[static_cast<std::size_t>(node)] != 0) continue;
            for (const RingLink& link : node_of(arrangement, node).links) beside[static_cast<std::size_t>(link.other)] = 1;
            remove_node(arrangement, node);
            --surplus;
        }
    }
}

void drop_crowded(ElementArrangement& arrangement, const GrowthGround& ground, double share) {
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i) {
        const int node = static_cast<int>(i);
        if (!is_element(arrangement.nodes[i])) continue;
        std::vector<int> close;
        arrangement.grid.visit(arrangement.nodes[i].position,
                               share * ground.reach_of[static_cast<std::size_t>(arrangement.nodes[i].symbol)],
                               [&](int other, Point at) {
                                   const ArrangementNode& second = node_of(arrangement, other);
                                   if (other <= node || !is_element(second)) return;
                                   if (abs(at - arrangement.nodes[i].position) <
                                       share * least_distance(ground, arrangement.nodes[i].symbol, second.symbol))
                                       close.push_back(other);
                               });
        std::sort(close.begin(), close.end());
        for (const int other : close) {
            const bool first_smaller =
                radius_of(ground, arrangement.nodes[i]) < radius_of(ground, node_of(arrangement, other));
            const int smaller =
                (first_smaller && !arrangement.nodes[i].held) || node_of(arrangement, other).held ? node : other;
            remove_node(arrangement, smaller);
            if (smaller == node) break;
        }
    }
}

HoleLimits hole_limits(const GrowthGround& ground, double slack) {
    const std::vector<ExemplarElement>& elements = ground.exemplar.elements;
    std::vector<Point> positions;
    for (const ExemplarElement& element : elements) positions.push_back(element.position);
    const Connectivity connectivity = connectivity_of(positions);
    double gap = 0;
    for (const std::vector<int>& face : connectivity.faces) {
        if (!std::all_of(face.begin(), face.end(), [&](int i) { return connectivity.inner[static_cast<std::size_t>(i)]; }))
            continue;
        const FaceCircle circle = face_circle(positions, face);
        double clear = circle.radius;
        for (const ExemplarElement& element : elements)
            clear = std::min(clear, abs(element.position - circle.center) - element.radius);
        gap = std::max(gap, clear);
    }
    return {slack * ground.exemplar.largest_empty, gap > 0 ? slack * gap : ground.exemplar.largest_empty};
}

std::vector<int> fill_holes(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh,
                            const HoleLimits& limits, double share, bool clear) {
    std::vector<std::pair<double, Point>> holes;
    for (const std::vector<int>& face : mesh.connectivity.faces) {
        const FaceCircle circle = face_circle(mesh.points, face);
        if (circle.radius > largest_hole * ground.exemplar.largest_empty) continue;
        // Whoever has gone since the mesh was made leaves a hole that its faces do not show: the next mesh does.
        const bool grown = std::all_of(face.begin(), face.end(), [&](int point) {
            return is_element(node_of(arrangement, mesh.nodes[static_cast<std::size_t>(point)]));
        });
        if (!grown || is_barred(ground, mesh.points[static_cast<std::size_t>(face.front())], circle.center)) continue;
        if (is_hole(arrangement, ground, circle.center, limits)) holes.push_back({-circle.radius, circle.center});
    }
    for (const Point at : places_along_lines(ground, limits))
        if (is_hole(arrangement, ground, at, limits) && has_grown_around(arrangement, ground, at, limits.empty))
            holes.push_back({-limits.empty, at});
    std::stable_sort(holes.begin(), holes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    RingMatcher matcher(ground, ground.options.weights);
    std::vector<int> filled;
    for (const auto& [negative_radius, center] : holes) {
        if (!is_hole(arrangement, ground, center, limits)) continue;  // filled by then
        const int seed = add_seed(arrangement, center, -1);
        if (fill_hole(arrangement, ground, matcher, seed, -negative_radius, share, clear))
            filled.push_back(seed);
        else
            remove_node(arrangement, seed);
    }
    return filled;
}

}  // namespace rinceau

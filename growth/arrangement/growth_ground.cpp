#include "growth/arrangement/growth_ground.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace rinceau {

namespace {

// Farther apart than this, in mean edges, elements do not push each other: the exemplar's least distance of two kinds that
// are seldom near is chance.
constexpr double farthest_push = 2.5;

double gap_between(Point a, Point b) {
    const double gap = std::atan2(cross(a, b), dot(a, b));
    return gap > 0 ? gap : gap + two_pi;
}

// From an element to its neighbour in columns and rows. In a tiled lattice a neighbour beyond the tile's edge has the index
// of its copy inside: there the offset tells which step it is.
std::array<int, 2> step_between(const ExemplarLattice& lattice, const ExemplarElement& from, const ExemplarElement& to,
                                Point offset) {
    const std::array<int, 2> step{to.lattice[0] - from.lattice[0], to.lattice[1] - from.lattice[1]};
    if (std::find(lattice.steps.begin(), lattice.steps.end(), step) != lattice.steps.end()) return step;
    const auto nearer = [&](const std::array<int, 2>& a, const std::array<int, 2>& b) {
        const auto off = [&](const std::array<int, 2>& s) {
            return norm(s[0] * lattice.basis[0] + s[1] * lattice.basis[1] - offset);
        };
        return off(a) < off(b);
    };
    return *std::min_element(lattice.steps.begin(), lattice.steps.end(), nearer);
}

ReferenceRing flat_ring(const Exemplar& exemplar, const ExemplarElement& element) {
    ReferenceRing ring;
    const std::size_t places = element.ring.elements.size();
    ring.offsets = element.ring.offsets;
    for (std::size_t k = 0; k < places; ++k) {
        const ExemplarElement& other = exemplar.elements[static_cast<std::size_t>(element.ring.elements[k])];
        ring.lengths.push_back(abs(ring.offsets[k]));
        ring.symbols.push_back(other.symbol);
        ring.sub_ids.push_back(other.sub_id);
        if (exemplar.lattice) ring.steps.push_back(step_between(*exemplar.lattice, element, other, ring.offsets[k]));
        const double before = gap_between(ring.offsets[(k + places - 1) % places], ring.offsets[k]);
        const double after = gap_between(ring.offsets[k], ring.offsets[(k + 1) % places]);
        ring.half_gap_cos.push_back(std::cos(std::min(0.5 * std::min(before, after), pi / 2)));
    }
    return ring;
}

// The neighbours' neighbours that are neither the element itself nor its neighbours. By where they stand, because in a tiled
// exemplar one element stands in several places.
void add_outer_ring(const Exemplar& exemplar, const ExemplarElement& element, ReferenceRing& ring) {
    const double same = 0.1 * exemplar.shortest_edge;
    const auto known = [&](Point offset) {
        const auto near = [&](Point other) { return abs(other - offset) < same; };
        return abs(offset) < same || std::any_of(ring.offsets.begin(), ring.offsets.end(), near) ||
               std::any_of(ring.outer_offsets.begin(), ring.outer_offsets.end(), near);
    };
    for (std::size_t k = 0; k < element.ring.elements.size(); ++k) {
        const ExemplarRing& beyond = exemplar.elements[static_cast<std::size_t>(element.ring.elements[k])].ring;
        for (std::size_t j = 0; j < beyond.elements.size(); ++j) {
            const Point offset = element.ring.offsets[k] + beyond.offsets[j];
            if (known(offset)) continue;
            ring.outer_offsets.push_back(offset);
            ring.outer_symbols.push_back(exemplar.elements[static_cast<std::size_t>(beyond.elements[j])].symbol);
        }
    }
}

void fill_least_distances(GrowthGround& ground) {
    const Exemplar& exemplar = ground.exemplar;
    const std::size_t symbols = exemplar.symbols.size();
    ground.least.assign(symbols, std::vector<double>(symbols, 0));
    ground.least_of.assign(symbols, 0);
    for (std::size_t a = 0; a < symbols; ++a) {
        for (std::size_t b = 0; b < symbols; ++b) {
            const double seen = exemplar.min_distance[a][b];
            // A pair that was never seen near: as near as any.
            ground.least[a][b] =
                std::isfinite(seen) ? std::min(seen, farthest_push * exemplar.mean_edge) : exemplar.shortest_edge;
            ground.reach = std::max(ground.reach, ground.least[a][b]);
        }
        ground.reach_of.push_back(*std::max_element(ground.least[a].begin(), ground.least[a].end()));
        ground.least_of[a] = *std::min_element(ground.least[a].begin(), ground.least[a].end());
    }
}

}  // namespace

GrowthGround make_ground(const Exemplar& exemplar, const ArrangeSurroundings& around, const ArrangeOptions& options) {
    GrowthGround ground{.exemplar = exemplar, .around = around, .options = options};
    ground.usable_of.resize(exemplar.symbols.size());
    for (std::size_t i = 0; i < exemplar.elements.size(); ++i) {
        const ExemplarElement& element = exemplar.elements[i];
        ground.rings.push_back(flat_ring(exemplar, element));
        if (options.two_rings) add_outer_ring(exemplar, element, ground.rings.back());
        ground.sub_ids = std::max(ground.sub_ids, element.sub_id + 1);
        ground.boxes.push_back(bounds(element.outline));
        ground.largest_radius = std::max(ground.largest_radius, element.radius);
        if (!element.usable) continue;
        ground.usable.push_back(static_cast<int>(i));
        ground.usable_of[static_cast<std::size_t>(element.symbol)].push_back(static_cast<int>(i));
    }
    fill_least_distances(ground);
    // A curved flow has no room for a lattice: rows must begin and end in it.
    ground.by_lattice = exemplar.lattice.has_value() && options.mode == RotationMode::fixed;
    ground.exclusive = options.mode == RotationMode::flow && !exemplar.outlines_overlap;
    ground.rigid = !exemplar.irregular && options.mode != RotationMode::flow;
    return ground;
}

double ring_angle(const GrowthGround& ground, Point at, Complex hint) {
    if (ground.options.mode != RotationMode::flow) return 0;
    const Complex direction = direction_at(*ground.around.flow, at);
    return arg(!ground.around.flow->directed && dot(direction, hint) < 0 ? -direction : direction);
}

Point ring_target(const GrowthGround& ground, int reference, int place, double angle, Point at) {
    const Point offset = ground.rings[static_cast<std::size_t>(reference)].offsets[static_cast<std::size_t>(place)];
    if (ground.options.mode == RotationMode::fixed) return offset;
    const Point turned = polar(1, angle) * offset;
    if (ground.options.mode == RotationMode::rotate) return turned;
    return polar(1, ring_angle(ground, at + 0.5 * turned, polar(1, angle))) * offset;
}

double least_distance(const GrowthGround& ground, int symbol, int other) {
    if (symbol < 0 && other < 0) return ground.exemplar.shortest_edge;
    if (symbol < 0) return ground.least_of[static_cast<std::size_t>(other)];
    if (other < 0) return ground.least_of[static_cast<std::size_t>(symbol)];
    return ground.least[static_cast<std::size_t>(symbol)][static_cast<std::size_t>(other)];
}

bool is_barred(const GrowthGround& ground, Point from, Point to) {
    const Boundary* boundary = ground.around.boundary.get();
    return boundary != nullptr && !boundary->is_empty() && (!boundary->allows(to) || boundary->crosses(from, to));
}

}  // namespace rinceau

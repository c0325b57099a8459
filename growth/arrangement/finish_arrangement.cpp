// Growth in a single pass leaves pockets and crowds in irregular arrangements: where two fronts meet nothing fits. A few
// rounds of thinning, filling and reading anew cure that; none of it is in the paper.
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "growth/arrangement/arrangement_mesh.h"
#include "growth/arrangement/grow_arrangement.h"
#include "growth/arrangement/node_links.h"
#include "growth/arrangement/repair_arrangement.h"
#include "growth/arrangement/reread_rings.h"
#include "growth/arrangement/separate.h"
#include "growth/arrangement/settle_arrangement.h"
#include "growth/arrangement/untangle_outlines.h"

namespace rinceau {

namespace {

constexpr int repair_rounds = 4;
constexpr int angle_rounds = 2;
constexpr int last_angle_rounds = 4;
constexpr int last_passes = 60;           // of separation
constexpr double crowded_share = 0.8;     // of the least distance: nearer, one of two goes
constexpr double last_share = 0.97;       // the same at the end
constexpr double hole_slack = 1.05;       // times the largest empty circle of the exemplar
constexpr double flow_hole_slack = 1.25;  // where a flow bends rows part: a hole is where another element would stand

std::vector<int> living_nodes(const ElementArrangement& arrangement) {
    std::vector<int> nodes;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i)
        if (!arrangement.nodes[i].dead) nodes.push_back(static_cast<int>(i));
    return nodes;
}

// One mesh a round: it is read, then tells where there are too many, too few or none.
void repair_round(ElementArrangement& arrangement, const GrowthGround& ground, const HoleLimits& limits, bool last) {
    drop_covered_seeds(arrangement, ground);
    ArrangementMesh mesh = mesh_of(arrangement, ground);
    reread_rings(arrangement, ground, mesh);
    settle_all(arrangement, ground, angle_rounds);
    if (last) return;
    move_points(mesh, arrangement);
    thin_out(arrangement, ground, mesh);
    drop_crowded(arrangement, ground, crowded_share);
    fill_holes(arrangement, ground, mesh, limits, crowded_share, !ground.exemplar.outlines_overlap);
}

// What the last steps take out again is grown beforehand.
std::size_t with_spare(std::size_t count) { return count + count / 50 + 1; }

// Elements beyond the count become seeds again, farthest from where growth began first.
void trim_rim(ElementArrangement& arrangement, std::size_t count) {
    if (arrangement.elements <= count) return;
    std::vector<std::pair<double, int>> farthest;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i)
        if (is_element(arrangement.nodes[i]) && !arrangement.nodes[i].held)
            farthest.push_back({-abs(arrangement.nodes[i].position - *arrangement.start), static_cast<int>(i)});
    std::sort(farthest.begin(), farthest.end());
    for (const auto& [distance, node] : farthest) {
        if (arrangement.elements <= count) break;
        become_seed(arrangement, node);
    }
}

}  // namespace

ElementArrangement finished(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                            const GrowOrder& order, const Progress& progress) {
    if (arrangement.elements == 0) return arrangement;
    const GrowthGround ground = make_ground(exemplar, around, arrangement.options);
    const bool flows = ground.options.mode == RotationMode::flow;
    const bool repairs = ground.options.finish && exemplar.irregular && !ground.by_lattice && !flows;
    const bool clear = !exemplar.outlines_overlap;
    const bool limited = order.count < std::numeric_limits<std::size_t>::max();
    const HoleLimits limits = hole_limits(ground, flows ? flow_hole_slack : hole_slack);
    if (ground.options.relax) settle_all(arrangement, ground, last_angle_rounds);
    for (int round = 0; repairs && round < repair_rounds; ++round) {
        if (order.stop && order.stop()) break;
        report(progress, "finish", static_cast<double>(round) / repair_rounds);
        repair_round(arrangement, ground, limits, round + 1 == repair_rounds);
        if (limited && round + 1 < repair_rounds)
            arrangement =
                grow(std::move(arrangement), exemplar, around, {.count = with_spare(order.count), .stop = order.stop});
    }
    if (repairs) {
        separate(arrangement, ground, living_nodes(arrangement), last_passes);
        if (clear) {
            untangle_outlines(arrangement, ground);
            separate(arrangement, ground, living_nodes(arrangement), last_passes);
        }
        drop_crowded(arrangement, ground, last_share);
    } else if (clear && ground.options.finish && !flows) {
        untangle_outlines(arrangement, ground);
    }
    if (clear && ground.options.finish) drop_overlapping(arrangement, ground);
    drop_cut(arrangement, ground);
    if (repairs || (flows && ground.options.finish)) {
        drop_covered_seeds(arrangement, ground);
        fill_holes(arrangement, ground, mesh_of(arrangement, ground), limits, flows ? crowded_share : last_share, clear);
    }
    if (limited) trim_rim(arrangement, order.count);
    if (repairs) relink_rings(arrangement, ground, mesh_of(arrangement, ground));
    return arrangement;
}

}  // namespace rinceau

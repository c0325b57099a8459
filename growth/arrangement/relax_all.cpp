// Ijiri et al. 2008, eq. 5 and 6. The matrix is a graph Laplacian, the same for x and y and for all turns of the rings;
// nodes that stand still are taken out of it (the paper uses Lagrange multipliers), so that it is positive definite and
// factored once.
#include "growth/arrangement/relax_all.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <cassert>
#include <numeric>
#include <vector>

#include "growth/arrangement/node_links.h"
#include "growth/arrangement/relax_near.h"

namespace rinceau {

namespace {

/// One summand of eq. 5: `to` should stand at `target` from `from`.
struct RingTerm {
    int from = 0;
    int to = 0;
    Point target;
};

std::vector<RingTerm> ring_terms(const ElementArrangement& arrangement) {
    std::vector<RingTerm> terms;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i)
        for (const RingLink& link : arrangement.nodes[i].links)
            if (link.place >= 0) terms.push_back({static_cast<int>(i), link.other, link.target});
    return terms;
}

int root_of(std::vector<int>& parents, int node) {
    while (parents[static_cast<std::size_t>(node)] != node) {
        int& parent = parents[static_cast<std::size_t>(node)];
        parent = parents[static_cast<std::size_t>(parent)];
        node = parent;
    }
    return node;
}

// The unknown of each node, or -1 for those that stand still: held ones, the first of each part without one, and all that no
// term pulls.
std::vector<int> unknowns_of(const ElementArrangement& arrangement, const std::vector<RingTerm>& terms) {
    std::vector<int> parents(arrangement.nodes.size());
    std::iota(parents.begin(), parents.end(), 0);
    std::vector<char> pulled(parents.size(), 0);
    for (const RingTerm& term : terms) {
        pulled[static_cast<std::size_t>(term.from)] = pulled[static_cast<std::size_t>(term.to)] = 1;
        const int a = root_of(parents, term.from);
        const int b = root_of(parents, term.to);
        parents[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    std::vector<char> anchored(parents.size(), 0);
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (arrangement.nodes[i].held) anchored[static_cast<std::size_t>(root_of(parents, static_cast<int>(i)))] = 1;
    std::vector<int> unknowns(parents.size(), -1);
    int count = 0;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (pulled[i] == 0 || arrangement.nodes[i].held) continue;
        char& part = anchored[static_cast<std::size_t>(root_of(parents, static_cast<int>(i)))];
        if (part == 0)
            part = 1;  // the root is the first of its part: this is it
        else
            unknowns[i] = count++;
    }
    return unknowns;
}

using SparseMatrix = Eigen::SparseMatrix<double>;

SparseMatrix laplacian(const std::vector<RingTerm>& terms, const std::vector<int>& unknowns, int count) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * terms.size());
    for (const RingTerm& term : terms) {
        const int a = unknowns[static_cast<std::size_t>(term.from)];
        const int b = unknowns[static_cast<std::size_t>(term.to)];
        if (a >= 0) entries.push_back({a, a, 1});
        if (b >= 0) entries.push_back({b, b, 1});
        if (a >= 0 && b >= 0) entries.push_back({std::max(a, b), std::min(a, b), -1});  // the lower half is all that is read
    }
    SparseMatrix matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::MatrixX2d right_sides(const ElementArrangement& arrangement, const std::vector<RingTerm>& terms,
                             const std::vector<int>& unknowns, int count) {
    Eigen::MatrixX2d sides = Eigen::MatrixX2d::Zero(count, 2);
    const auto add = [&](int unknown, Point p) {
        sides(unknown, 0) += p.x;
        sides(unknown, 1) += p.y;
    };
    for (const RingTerm& term : terms) {
        const int a = unknowns[static_cast<std::size_t>(term.from)];
        const int b = unknowns[static_cast<std::size_t>(term.to)];
        if (a >= 0) add(a, (b < 0 ? arrangement.nodes[static_cast<std::size_t>(term.to)].position : Point{}) - term.target);
        if (b >= 0)
            add(b, (a < 0 ? arrangement.nodes[static_cast<std::size_t>(term.from)].position : Point{}) + term.target);
    }
    return sides;
}

std::vector<int> all_nodes(const ElementArrangement& arrangement) {
    std::vector<int> nodes;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i)
        if (!arrangement.nodes[i].dead) nodes.push_back(static_cast<int>(i));
    return nodes;
}

}  // namespace

void relax_all(ElementArrangement& arrangement, const GrowthGround& ground, int rounds) {
    assert(ground.options.mode != RotationMode::flow);
    std::vector<RingTerm> terms = ring_terms(arrangement);
    const std::vector<int> unknowns = unknowns_of(arrangement, terms);
    const int count = 1 + *std::max_element(unknowns.begin(), unknowns.end());
    if (count == 0) return;
    const Eigen::SimplicialLDLT<SparseMatrix> factored(laplacian(terms, unknowns, count));
    const bool turns = ground.options.mode == RotationMode::rotate;
    for (int round = 0; round < (turns ? rounds : 1); ++round) {
        if (turns) {
            refit_angles(arrangement, ground, all_nodes(arrangement));
            terms = ring_terms(arrangement);
        }
        const Eigen::MatrixX2d solution = factored.solve(right_sides(arrangement, terms, unknowns, count));
        for (std::size_t i = 0; i < unknowns.size(); ++i)
            if (unknowns[i] >= 0)
                move_node(arrangement, static_cast<int>(i), {solution(unknowns[i], 0), solution(unknowns[i], 1)});
    }
}

}  // namespace rinceau

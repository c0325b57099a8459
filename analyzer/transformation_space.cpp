#include "analyzer/transformation_space.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "geometry/kd_tree.h"

namespace rinceau {

namespace {

/// Advances under this share of the size have no direction.
constexpr double no_advance = 1e-6;

/// The instances of one look.
struct LookInstances {
    int look = 0;
    std::vector<int> elements;
    std::vector<Point> places;
};

std::vector<LookInstances> instances_by_look(const Instancing& instancing) {
    std::vector<LookInstances> all(instancing.looks.size());
    for (std::size_t i = 0; i < instancing.instances.size(); ++i) {
        const Instance& instance = instancing.instances[i];
        LookInstances& look = all[static_cast<std::size_t>(instance.look)];
        look.look = instance.look;
        look.elements.push_back(static_cast<int>(i));
        look.places.push_back(instance.pose.translation);
    }
    std::erase_if(all, [&](const LookInstances& look) {
        return look.elements.empty() || !instancing.looks[static_cast<std::size_t>(look.look)].verbatim.empty();
    });
    return all;
}

Similarity pose_of(const Instancing& instancing, int element) {
    return instancing.instances[static_cast<std::size_t>(element)].pose;
}

/// Among the equivalent frames of both ends: unmirrored, least turns.
TransformationPoint reduced_point(const Instancing& instancing, int from, int to) {
    const auto symmetry = [&](int element) -> const SymmetryGroup& {
        const int look = instancing.instances[static_cast<std::size_t>(element)].look;
        return instancing.looks[static_cast<std::size_t>(look)].symmetry;
    };
    const auto turns = [](const TransformationPoint& p) { return std::abs(p.alpha) + std::abs(p.beta); };
    constexpr double same_turn = 1e-6;  // radians
    TransformationPoint best = to_transformation_point(pose_of(instancing, from), pose_of(instancing, to));
    for (const Similarity& g : symmetry(from).elements)
        for (const Similarity& h : symmetry(to).elements) {
            const TransformationPoint p =
                to_transformation_point(pose_of(instancing, from) * g, pose_of(instancing, to) * h);
            if (p.mirrored > best.mirrored) continue;
            if (p.mirrored < best.mirrored || turns(p) < turns(best) - same_turn) best = p;
        }
    if (symmetry(to).continuous) {
        best.beta = 0;  // neither a turn nor a mirror image of a circle shows
        best.mirrored = false;
    }
    best.from = from;
    best.to = to;
    return best;
}

/// How many instances of `to` each of `from` is paired with.
std::size_t pairs_each(const LookInstances& from, const LookInstances& to, const TransformationSpaceOptions& options) {
    const std::size_t few = static_cast<std::size_t>(options.all_pairs_up_to);
    const bool all_pairs = from.elements.size() <= few && to.elements.size() <= few;
    const std::size_t own = from.look == to.look ? 1 : 0;  // an element is its own nearest neighbour
    return all_pairs ? to.elements.size() : static_cast<std::size_t>(options.neighbors) + own;
}

TransformationSpace fill_space(const Instancing& instancing, const LookInstances& from, const LookInstances& to,
                               const KdTree& places, const TransformationSpaceOptions& options) {
    TransformationSpace space{from.look, to.look, {}};
    const std::size_t count = pairs_each(from, to, options);
    for (std::size_t i = 0; i < from.elements.size(); ++i)
        for (const Neighbor& neighbor : places.nearest(from.places[i], count))
            if (const int element = to.elements[neighbor.index]; element != from.elements[i])
                space.points.push_back(reduced_point(instancing, from.elements[i], element));
    std::ranges::sort(space.points, {}, [](const TransformationPoint& p) { return std::pair{p.from, p.to}; });
    return space;
}

/// Which spaces are filled, by place in `looks`: all, or the first of the most frequent looks that keep within the limit.
std::vector<std::pair<std::size_t, std::size_t>> filled_spaces(const std::vector<LookInstances>& looks,
                                                               const TransformationSpaceOptions& options) {
    std::vector<std::size_t> frequent(looks.size());
    std::iota(frequent.begin(), frequent.end(), std::size_t{0});
    if (options.most_points > 0) {
        std::ranges::stable_sort(frequent, std::greater{}, [&](std::size_t k) { return looks[k].elements.size(); });
        // Each space has a point at least.
        const auto enough = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(options.most_points)))) + 1;
        frequent.resize(std::min(frequent.size(), enough));
    }
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (const std::size_t from : frequent)
        for (const std::size_t to : frequent) all.emplace_back(from, to);
    if (options.most_points == 0) return all;
    const auto rarer = [&](const auto& pair) {
        return std::min(looks[pair.first].elements.size(), looks[pair.second].elements.size());
    };
    std::ranges::stable_sort(all, std::greater{}, rarer);
    std::size_t points = 0, kept = 0;
    for (; kept < all.size(); ++kept) {
        const LookInstances& from = looks[all[kept].first];
        const LookInstances& to = looks[all[kept].second];
        points += from.elements.size() * std::min(to.elements.size(), pairs_each(from, to, options));
        if (points > options.most_points && kept > 0) break;
    }
    all.resize(kept);
    std::ranges::sort(all);
    return all;
}

}  // namespace

TransformationPoint to_transformation_point(const Similarity& from, const Similarity& to) {
    const Similarity step = inverse(from) * to;
    TransformationPoint point;
    point.mirrored = step.mirrored;
    point.d = abs(step.translation);
    point.s = scale_of(step);
    // Heading +y: a translation straight ahead has argument pi / 2.
    if (point.d > no_advance)
        point.alpha = wrap_angle(arg(step.translation) - pi / 2);
    else
        point.d = 0;
    point.beta = wrap_angle(arg(step.linear) - point.alpha);
    return point;
}

std::vector<TransformationSpace> fill_transformation_spaces(const Instancing& instancing,
                                                            const TransformationSpaceOptions& options) {
    const std::vector<LookInstances> looks = instances_by_look(instancing);
    std::vector<KdTree> trees;
    for (const LookInstances& look : looks) trees.emplace_back(look.places);
    std::vector<TransformationSpace> spaces;
    for (const auto& [from, to] : filled_spaces(looks, options)) {
        TransformationSpace space = fill_space(instancing, looks[from], looks[to], trees[to], options);
        if (!space.points.empty()) spaces.push_back(std::move(space));
    }
    return spaces;
}

}  // namespace rinceau

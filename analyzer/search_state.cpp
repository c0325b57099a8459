#include "analyzer/search_state.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "analyzer/group_frame.h"
#include "geometry/box.h"
#include "geometry/kd_tree.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

/// Entropy in bits of a sample of bin numbers, with half a bit for the doubt in small samples, at most `cap`.
double sample_entropy(std::vector<std::int64_t> bins, double cap) {
    std::ranges::sort(bins);
    const auto total = static_cast<double>(bins.size());
    double entropy = 0;
    for (std::size_t begin = 0; begin < bins.size();) {
        std::size_t end = begin;
        while (end < bins.size() && bins[end] == bins[begin]) ++end;
        const double share = static_cast<double>(end - begin) / total;
        entropy -= share * std::log2(share);
        begin = end;
    }
    return entropy > 0 ? std::min(entropy + 0.5, cap) : 0;
}

/// Median over a sample of the distance to the nearest other point; `otherwise` if there is none or they coincide.
double median_nearest(const std::vector<Point>& origins, double otherwise) {
    if (origins.size() < 2) return otherwise;
    constexpr std::size_t most_samples = 2000;
    const std::size_t stride = 1 + origins.size() / most_samples;
    const KdTree tree(origins);
    std::vector<double> distances;
    for (std::size_t i = 0; i < origins.size(); i += stride)
        distances.push_back(tree.nearest(origins[i], 2).back().distance);
    std::ranges::nth_element(distances, distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2));
    const double median = distances[distances.size() / 2];
    return median > 0 ? median : otherwise;
}

/// The first of each place; what is within `reach` of another point stands in its place.
std::vector<Point> distinct_places(const std::vector<Point>& origins, double reach) {
    const KdTree tree(origins);
    std::vector<char> taken(origins.size(), 0);
    std::vector<Point> places;
    for (std::size_t i = 0; i < origins.size(); ++i) {
        if (taken[i]) continue;
        places.push_back(origins[i]);
        for (const Neighbor& near : tree.within(origins[i], reach)) taken[near.index] = 1;
    }
    return places;
}

/// As median_nearest; where most stand within `reach` of another one, as far apart as many places on the same area with one
/// each would be: what is in one place, but for rounding, is no sign of a crowd.
double spacing_of(const std::vector<Point>& origins, double reach, double otherwise) {
    const double nearest = median_nearest(origins, otherwise);
    if (nearest > reach) return nearest;
    const std::vector<Point> places = distinct_places(origins, reach);
    const double each = static_cast<double>(origins.size()) / static_cast<double>(places.size());
    return median_nearest(places, otherwise) / std::sqrt(each);
}

PartCost part_cost(const SearchState& state, int p, double part_bits) {
    const Part& part = state.part(p);
    const std::vector<int>& items = state.alive(p);
    PartCost cost;
    if (items.empty()) return cost;
    double log_size = 0;
    std::vector<std::int64_t> angles, scales;
    const auto rotations = std::ranges::count_if(part.symmetry.elements, [](const Similarity& s) { return !s.mirrored; });
    const bool has_mirror = static_cast<std::size_t>(rotations) < part.symmetry.elements.size();
    const double bin = 2 * state.tolerance.turn(part.radius);
    for (const int i : items) {
        const Similarity& pose = state.item(i).pose;
        const double log_scale = std::log(scale_of(pose));
        log_size += log_scale;
        scales.push_back(std::llround(log_scale / bin));
        // The angle modulo the part's rotations.
        const double folded = wrap_angle(arg(pose.linear) * static_cast<double>(rotations)) / static_cast<double>(rotations);
        const std::int64_t mirror_bin = pose.mirrored && !has_mirror ? 1'000'000 : 0;
        angles.push_back(std::llround(folded / bin) + mirror_bin);
    }
    cost.size = std::exp(log_size / static_cast<double>(items.size()));
    cost.place_bits = std::max(1.0, std::log2(state.diagonal / (state.tolerance.size * cost.size)));
    const double angle_cap = std::max(0.0, std::log2(two_pi / static_cast<double>(rotations) / bin));
    cost.angle_bits = part.symmetry.continuous ? 0 : sample_entropy(std::move(angles), angle_cap);
    constexpr double scale_cap = 10;
    cost.scale_bits = sample_entropy(std::move(scales), scale_cap);
    std::vector<Point> origins;
    for (const int i : items) origins.push_back(state.item(i).pose.translation);
    cost.neighbour_distance = spacing_of(origins, state.tolerance.size * cost.size, 0.1 * state.diagonal);
    cost.item_bits = 2 * cost.place_bits + cost.angle_bits + cost.scale_bits + part_bits;
    return cost;
}

}  // namespace

void refresh(SearchState& state, const std::vector<int>& parts) {
    state.members.resize(state.rules.parts.size());
    state.costs.resize(state.rules.parts.size());
    double living_parts = 1;
    for (const auto& members : state.members) living_parts += members.empty() ? 0 : 1;
    for (const int p : parts) {
        std::vector<int>& members = state.members[static_cast<std::size_t>(p)];
        std::erase_if(members, [&](int i) { return !state.item(i).alive; });
        state.costs[static_cast<std::size_t>(p)] = part_cost(state, p, std::log2(living_parts));
    }
}

namespace {

void add_item(SearchState& state, Item item) {
    const auto p = static_cast<std::size_t>(item.part);
    state.members.resize(state.rules.parts.size());
    state.members[p].push_back(static_cast<int>(state.rules.items.size()));
    state.rules.items.push_back(std::move(item));
}

/// Copies of one look in one pose, lowest first.
std::vector<std::vector<int>> coincident_copies(SearchState& state, int p) {
    const std::vector<int>& items = state.alive(p);
    const PoseGrid grid(state.rules, p, items);
    // Much tighter than recognition: the same outline drawn twice.
    const PoseTolerance same_place{0.1 * state.tolerance.size, 0.1 * state.tolerance.angle, 0};
    std::vector<std::vector<int>> copies;
    const auto set_alive = [&](int item, bool alive) { state.rules.items[static_cast<std::size_t>(item)].alive = alive; };
    for (const int i : items) {
        if (!state.item(i).alive) continue;
        // Each copy that is found steps aside for the next.
        std::vector<int> stack{i};
        set_alive(i, false);
        while (const auto match = grid.find(state.item(i).pose, 0, same_place)) {
            stack.push_back(match->item);
            set_alive(match->item, false);
        }
        std::ranges::sort(stack);
        if (stack.size() > 1) copies.push_back(std::move(stack));
    }
    for (const int i : items) set_alive(i, true);
    return copies;
}

/// One item instead of several copies in the same place.
void stack_copies(SearchState& state, int p, const std::vector<std::vector<int>>& copies) {
    std::unordered_map<std::size_t, int> part_of_count;
    for (const std::vector<int>& stack : copies) {
        auto [stacked, fresh] = part_of_count.try_emplace(stack.size(), static_cast<int>(state.rules.parts.size()));
        if (fresh) {
            Rule rule;
            rule.kind = RuleKind::group;
            Part part;
            part.rule = static_cast<int>(state.rules.rules.size());
            for (std::size_t k = 0; k < stack.size(); ++k) {
                rule.members.push_back({p, {}});
                part.children.push_back({p, {}});
            }
            state.rules.rules.push_back(rule);
            part.radius = state.part(p).radius;
            part.leaves = static_cast<int>(stack.size());
            part.symmetry = state.part(p).symmetry;
            state.rules.parts.push_back(part);
        }
        Item item;
        item.part = stacked->second;
        item.pose = state.item(stack.front()).pose;
        item.members = stack;
        item.first = state.item(stack.front()).first;
        for (const int i : stack) state.rules.items[static_cast<std::size_t>(i)].alive = false;
        add_item(state, item);
    }
}

/// The distance that counts as near in this drawing: of neighbours' origins, but not less than an element's size, since
/// concentric elements are no measure of how far apart things stand.
double near_distance(const SearchState& state) {
    std::vector<Point> origins;
    std::vector<double> sizes;
    for (const auto& members : state.members) {
        for (const int i : members) {
            if (!state.item(i).alive) continue;
            origins.push_back(state.item(i).pose.translation);
            sizes.push_back(scale_of(state.item(i).pose));
        }
    }
    if (origins.empty()) return state.diagonal;
    std::ranges::nth_element(sizes, sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2));
    return std::max({median_nearest(origins, 0), sizes[sizes.size() / 2], 1e-9 * state.diagonal});
}

}  // namespace

SearchState starting_state(const Instancing& instancing, const PoseTolerance& tolerance, double diagonal) {
    SearchState state;
    state.tolerance = tolerance;
    state.diagonal = diagonal;
    for (std::size_t look = 0; look < instancing.looks.size(); ++look) {
        Part part;
        part.look = static_cast<int>(look);
        part.shape = instancing.looks[look].shape;
        part.symmetry = instancing.looks[look].symmetry;
        state.rules.parts.push_back(part);
    }
    for (std::size_t e = 0; e < instancing.instances.size(); ++e) {
        const Instance& instance = instancing.instances[e];
        Item item;
        item.part = instance.look;
        item.pose = instance.pose;
        item.element = static_cast<int>(e);
        item.first = static_cast<int>(e);
        const bool verbatim = !instancing.looks[static_cast<std::size_t>(instance.look)].verbatim.empty();
        if (verbatim) {
            state.rules.items.push_back(item);  // listed in the axiom; no member of its part, so that no rule sees it
        } else {
            add_item(state, item);
        }
    }
    state.members.resize(state.rules.parts.size());
    const auto looks = static_cast<int>(state.rules.parts.size());
    for (int p = 0; p < looks; ++p) {
        const auto copies = coincident_copies(state, p);
        stack_copies(state, p, copies);
    }
    state.neighbour_distance = near_distance(state);
    std::vector<int> all(state.rules.parts.size());
    for (std::size_t p = 0; p < all.size(); ++p) all[p] = static_cast<int>(p);
    refresh(state, all);
    return state;
}

namespace {

double angle_code(double angle, double precision) {
    const double in_degrees = std::abs(degrees(wrap_angle(angle)));
    const double slack = degrees(precision) * 0.1;
    if (in_degrees <= slack) return 1;
    if (std::abs(in_degrees - 90 * std::round(in_degrees / 90)) <= slack) return 3;
    if (std::abs(in_degrees - 15 * std::round(in_degrees / 15)) <= slack) return 6;
    return std::log2(two_pi / precision);
}

}  // namespace

double step_bits(const SearchState& state, int from, int to, const Similarity& step) {
    constexpr double constant = 3, mirror = 3, other_scale = 10;
    const double precision = state.tolerance.angle;
    const TurtleStep turtle = to_turtle_step(step, state.tolerance.size);
    double bits = constant + (turtle.mirrored ? mirror : 0);
    const bool undirected = state.part(from).symmetry.continuous;
    bits += turtle.advance > 0 ? state.cost(from).place_bits + 1 : 1;
    if (turtle.advance > 0 && !undirected) bits += angle_code(turtle.turn, precision);
    bits += std::abs(std::log(turtle.scale)) <= 0.1 * precision ? 1 : other_scale;
    if (!state.part(to).symmetry.continuous) {
        bits += std::min(angle_code(turtle.spin, precision), angle_code(turtle.turn + turtle.spin, precision));
    }
    return bits;
}

}  // namespace rinceau

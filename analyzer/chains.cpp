#include "analyzer/chains.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "analyzer/canonical_step.h"
#include "geometry/index_map.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

const Item& item_at(const RuleSet& rules, int item) { return rules.items[static_cast<std::size_t>(item)]; }

/// Small numbers for keys below a limit: a table where many of the keys will be used, else a map.
class Numbers {
  public:
    static constexpr int none = IndexMap::none;

    Numbers(std::size_t limit, std::size_t expected) : map_(limit <= sparse * expected ? 0 : expected) {
        if (limit <= sparse * expected) table_.assign(limit, none);
    }
    int find(std::size_t key) const { return table_.empty() ? map_.find(key) : table_[key]; }
    void set(std::size_t key, int value) {
        if (table_.empty()) {
            map_.set(key, value);
        } else {
            table_[key] = value;
        }
    }
    int find_or_insert(std::size_t key, int value) {
        if (table_.empty()) return map_.find_or_insert(key, value);
        if (table_[key] == none) table_[key] = value;
        return table_[key];
    }

  private:
    static constexpr std::size_t sparse = 16;  // a table has at most so many times more room than keys
    std::vector<int> table_;
    IndexMap map_;
};

/// (item, gauge) pairs numbered as they are met, with who follows whom.
class States {
  public:
    States(std::size_t items, std::size_t gauges, std::size_t expected) : gauges_(gauges), ids_(items * gauges, expected) {
        list_.reserve(expected);
    }
    int id(int item, int gauge) {
        const std::size_t key = static_cast<std::size_t>(item) * gauges_ + static_cast<std::size_t>(gauge);
        const int known = ids_.find_or_insert(key, size());
        if (known == size()) list_.push_back({item, gauge});
        return known;
    }
    struct State {
        int item = 0, gauge = 0;
        int next = unknown, previous = none;
        double shift = 0;  // of the link that leads here
    };
    static constexpr int none = -1, unknown = -2;
    State& operator[](int id) { return list_[static_cast<std::size_t>(id)]; }
    const State& operator[](int id) const { return list_[static_cast<std::size_t>(id)]; }
    int size() const { return static_cast<int>(list_.size()); }

  private:
    std::size_t gauges_;
    std::vector<State> list_;
    Numbers ids_;
};

/// Which gauges lead along the same items: a symmetry that the step carries into a symmetry of the same kind (a mirror image
/// about the way of a straight row) changes nothing but the frames. For each gauge the lowest that is equivalent to it.
std::vector<int> equivalent_gauges(const Part& part, const Similarity& step, const PoseTolerance& tolerance) {
    constexpr double exact = 0.01;  // of the tolerance: symmetries are as exact as the outline that they were found on
    const std::vector<Similarity>& symmetry = part.symmetry.elements;
    std::vector<int> lowest(symmetry.size());
    for (std::size_t s = 0; s < symmetry.size(); ++s) lowest[s] = static_cast<int>(s);
    const double turn = exact * tolerance.angle;
    const auto index_of = [&](const Similarity& wanted) { return matching_gauge(part, {}, wanted, turn); };
    std::vector<char> kept(symmetry.size(), 0);
    for (std::size_t s = 0; s < symmetry.size(); ++s) {
        kept[s] = abs(apply(symmetry[s], step.translation) - step.translation) <= exact * tolerance.size;
    }
    // Only while each is carried into another one that is kept.
    const Similarity back{inverse(step).linear, {}, step.mirrored}, forth{step.linear, {}, step.mirrored};
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t s = 0; s < symmetry.size(); ++s) {
            if (!kept[s]) continue;
            const int carried = index_of(back * symmetry[s] * forth);
            if (carried >= 0 && kept[static_cast<std::size_t>(carried)]) continue;
            kept[s] = 0;
            changed = true;
        }
    }
    for (std::size_t s = 0; s < symmetry.size(); ++s) {
        for (std::size_t k = 0; k < symmetry.size(); ++k) {
            const int other = kept[k] ? index_of(symmetry[s] * symmetry[k]) : -1;
            if (other >= 0) lowest[s] = std::min(lowest[s], other);
        }
    }
    return lowest;
}

/// What links are looked up with.
struct Following {
    const RuleSet& rules;
    const PoseGrid& grid;
    const Part& part;
    const Similarity& step;
    const PoseTolerance& tolerance;
    std::vector<int> lowest_gauge;
};

/// A round item has no angle of its own.
Similarity without_angle(const Similarity& pose) { return {{scale_of(pose), 0}, pose.translation, false}; }

Similarity frame_of(const Following& following, const States::State& state) {
    if (following.part.symmetry.continuous) return without_angle(item_at(following.rules, state.item).pose);
    return item_at(following.rules, state.item).pose * following.part.symmetry.elements[static_cast<std::size_t>(state.gauge)];
}

/// Links `from` to the state that its step leads to; the nearer claimant of a state keeps it.
void link(States& states, int from, const Following& following) {
    const States::State at = states[from];
    states[from].next = States::none;
    const Similarity frame = frame_of(following, at);
    const Similarity predicted = frame * following.step;
    const double distance = abs(predicted.translation - frame.translation);
    const auto match = following.grid.find(predicted, distance, following.tolerance);
    if (!match || match->item == at.item) return;
    const int to = states.id(match->item, following.lowest_gauge[static_cast<std::size_t>(match->gauge)]);
    const int rival = states[to].previous;
    if (rival != States::none) {
        if (states[to].shift <= match->shift) return;
        states[rival].next = States::none;
    }
    states[from].next = to;
    states[to].previous = from;
    states[to].shift = match->shift;
}

/// The frame of a state that goes on from `frame`, among those of equivalent gauges.
Similarity continued_frame(const Following& following, const Similarity& frame, const States::State& state) {
    const Similarity& pose = item_at(following.rules, state.item).pose;
    if (following.part.symmetry.continuous) return without_angle(pose);
    const double turn = following.tolerance.turn(following.part.radius);
    const int gauge = matching_gauge(following.part, pose, frame * following.step, turn);
    return pose * following.part.symmetry.elements[static_cast<std::size_t>(gauge < 0 ? state.gauge : gauge)];
}

/// Walks from `start` until the end or until an item comes again; marks what it passes. `seen` holds for each item the last
/// start of a walk that met it.
Chain walk(const States& states, int start, const Following& following, std::vector<char>& passed, Numbers& seen) {
    Chain chain;
    chain.gauge = states[start].gauge;
    for (int at = start; at >= 0 && !passed[static_cast<std::size_t>(at)]; at = states[at].next) {
        const States::State& state = states[at];
        const auto item = static_cast<std::size_t>(state.item);
        if (seen.find(item) == start) {
            chain.closed = state.item == chain.items.front() && chain.items.size() >= 3;
            break;
        }
        seen.set(item, start);
        passed[static_cast<std::size_t>(at)] = 1;
        chain.frames.push_back(chain.frames.empty() ? frame_of(following, state)
                                                    : continued_frame(following, chain.frames.back(), state));
        chain.items.push_back(state.item);
        if (state.next >= 0 && states[state.next].item == chain.items.front() && chain.items.size() >= 3) chain.closed = true;
    }
    return chain;
}

/// A ring begins at its lowest element.
Chain begun_at_lowest(const RuleSet& rules, Chain chain) {
    if (!chain.closed) return chain;
    const auto lowest = std::ranges::min_element(chain.items, {}, [&](int i) { return item_at(rules, i).first; });
    const auto shift = lowest - chain.items.begin();
    std::rotate(chain.items.begin(), chain.items.begin() + shift, chain.items.end());
    std::rotate(chain.frames.begin(), chain.frames.begin() + shift, chain.frames.end());
    return chain;
}

/// Paths from states without a predecessor, then cycles.
std::vector<Chain> walked_chains(const States& states, const Following& following) {
    std::vector<char> passed(static_cast<std::size_t>(states.size()), 0);
    Numbers seen(following.rules.items.size(), static_cast<std::size_t>(states.size()));
    std::vector<Chain> chains;
    for (const bool cycles : {false, true}) {
        for (int start = 0; start < states.size(); ++start) {
            if (!cycles && states[start].previous != States::none) continue;
            // A path that meets an item twice goes on as a new chain.
            for (int at = start; at >= 0 && !passed[static_cast<std::size_t>(at)];) {
                Chain chain = walk(states, at, following, passed, seen);
                while (at >= 0 && passed[static_cast<std::size_t>(at)]) {
                    at = states[at].next;
                    if (at == start) break;
                }
                if (chain.items.size() >= 2) chains.push_back(begun_at_lowest(following.rules, std::move(chain)));
                if (cycles) break;
            }
        }
    }
    return chains;
}

}  // namespace

std::vector<Chain> sequence_chains(const RuleSet& rules, const PoseGrid& grid, std::span<const int> sources,
                                   const Similarity& step, const PoseTolerance& tolerance) {
    const Part& part = rules.parts[static_cast<std::size_t>(grid.part())];
    const Following following{rules, grid, part, step, tolerance, equivalent_gauges(part, step, tolerance)};
    const auto gauges = static_cast<int>(part.symmetry.elements.size());
    std::size_t different = 0;
    for (int gauge = 0; gauge < gauges; ++gauge) different += following.lowest_gauge[static_cast<std::size_t>(gauge)] == gauge;
    States states(rules.items.size(), part.symmetry.elements.size(), different * sources.size());
    // Follow the step from every source in every gauge that is not equivalent to another.
    for (const int source : sources) {
        if (!item_at(rules, source).alive) continue;
        for (int gauge = 0; gauge < gauges; ++gauge) {
            if (following.lowest_gauge[static_cast<std::size_t>(gauge)] != gauge) continue;
            for (int at = states.id(source, gauge); at >= 0 && states[at].next == States::unknown; at = states[at].next) {
                link(states, at, following);
            }
        }
    }
    return walked_chains(states, following);
}

namespace {

/// A frame at `item` heading for `target`.
Similarity heading_frame(const RuleSet& rules, int item, int target) {
    const Item& from = item_at(rules, item);
    const Point way = item_at(rules, target).pose.translation - from.pose.translation;
    const Complex heading = way / abs(way) * Complex{0, -1};
    return {scale_of(from.pose) * heading, from.pose.translation, false};
}

/// Directed pairs of items, numbered as they are met, with who follows whom.
class Edges {
  public:
    explicit Edges(std::size_t expected) : ids_(expected) { list_.reserve(expected); }
    int id(int from, int to) {
        const std::uint64_t key = static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint64_t>(to);
        const int known = ids_.find_or_insert(key, size());
        if (known == size()) list_.push_back({from, to});
        return known;
    }
    struct Edge {
        int from = 0, to = 0;
        int next = unknown, previous = none;
    };
    static constexpr int none = -1, unknown = -2;
    Edge& operator[](int id) { return list_[static_cast<std::size_t>(id)]; }
    const Edge& operator[](int id) const { return list_[static_cast<std::size_t>(id)]; }
    int size() const { return static_cast<int>(list_.size()); }
    /// By first item, then by second.
    std::vector<int> in_order() const {
        std::vector<int> order(list_.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::sort(order, {}, [&](int e) { return std::pair{(*this)[e].from, (*this)[e].to}; });
        return order;
    }

  private:
    std::vector<Edge> list_;
    IndexMap ids_;
};

/// The edge that the step finds after `at`, or none.
int next_edge(Edges& edges, int at, const RuleSet& rules, const PoseGrid& grid, const Similarity& step,
              const PoseTolerance& tolerance) {
    const Edges::Edge edge = edges[at];
    const double advance = step.translation.y;
    const Similarity here = heading_frame(rules, edge.from, edge.to);
    const double length = abs(item_at(rules, edge.to).pose.translation - here.translation);
    if (std::abs(length - advance * scale_of(here)) > tolerance.shift(scale_of(here), length)) return Edges::none;
    // The frame at the edge's end, as the step predicts its heading.
    Similarity there = here * step;
    there.translation = item_at(rules, edge.to).pose.translation;
    const auto match = grid.find(there * step, length, tolerance);
    if (!match || match->item == edge.to || match->item == edge.from) return Edges::none;
    return edges.id(edge.to, match->item);
}

/// Follows the edges from `start` until the end or until an item comes again; marks what it passes.
Chain walk_edges(const Edges& edges, int start, const RuleSet& rules, const Similarity& step, std::vector<char>& passed) {
    Chain chain;
    std::set<int> seen;
    for (int at = start; at >= 0 && !passed[static_cast<std::size_t>(at)]; at = edges[at].next) {
        passed[static_cast<std::size_t>(at)] = 1;
        const Edges::Edge& edge = edges[at];
        if (!seen.insert(edge.from).second) break;
        chain.items.push_back(edge.from);
        chain.frames.push_back(heading_frame(rules, edge.from, edge.to));
        if (edge.next < 0 && !seen.contains(edge.to)) {
            chain.items.push_back(edge.to);
            Similarity last = chain.frames.back() * step;
            last.translation = item_at(rules, edge.to).pose.translation;
            chain.frames.push_back(last);
        }
        if (edge.to == chain.items.front() && chain.items.size() >= 3) {
            chain.closed = true;
            break;
        }
    }
    return chain;
}

}  // namespace

std::vector<Chain> directed_chains(const RuleSet& rules, const PoseGrid& grid, std::span<const std::pair<int, int>> starts,
                                   const Similarity& step, const PoseTolerance& tolerance) {
    // Follow every start edge forward; an edge leads to at most one other.
    Edges edges(starts.size());
    for (const auto& [from, to] : starts) {
        if (!item_at(rules, from).alive || !item_at(rules, to).alive) continue;
        for (int at = edges.id(from, to); edges[at].next == Edges::unknown;) {
            edges[at].next = Edges::none;
            const int onward = next_edge(edges, at, rules, grid, step, tolerance);
            if (onward < 0 || edges[onward].previous >= 0) break;
            edges[at].next = onward;
            edges[onward].previous = at;
            at = onward;
        }
    }
    std::vector<Chain> chains;
    std::vector<char> passed(static_cast<std::size_t>(edges.size()), 0);
    const std::vector<int> order = edges.in_order();
    for (const bool cycles : {false, true}) {
        for (const int start : order) {
            if (passed[static_cast<std::size_t>(start)] || (!cycles && edges[start].previous >= 0)) continue;
            Chain chain = walk_edges(edges, start, rules, step, passed);
            if (chain.items.size() >= 2) chains.push_back(begun_at_lowest(rules, std::move(chain)));
        }
    }
    return chains;
}

namespace {

/// Extends a chain at its end while the changing step finds items; `step` is the step that led to the last item.
void extend(Chain& chain, const RuleSet& rules, const PoseGrid& grid, TurtleStep step, double turn_change,
            double spin_change, const PoseTolerance& tolerance) {
    const Part& part = rules.parts[static_cast<std::size_t>(grid.part())];
    std::set<int> seen(chain.items.begin(), chain.items.end());
    for (;;) {
        step.turn += turn_change;
        step.spin += spin_change;
        const Similarity predicted = chain.frames.back() * to_similarity(step);
        const double distance = abs(predicted.translation - chain.frames.back().translation);
        const auto match = grid.find(predicted, distance, tolerance);
        if (!match || !seen.insert(match->item).second) return;
        chain.items.push_back(match->item);
        chain.frames.push_back(item_at(rules, match->item).pose *
                               part.symmetry.elements[static_cast<std::size_t>(match->gauge)]);
    }
}

}  // namespace

std::vector<LinearChain> linear_chains(const RuleSet& rules, const PoseGrid& grid,
                                       std::span<const std::pair<int, int>> starts, const Rule& rule,
                                       const PoseTolerance& tolerance) {
    std::vector<LinearChain> chains;
    std::set<std::pair<int, int>> covered;
    for (const auto& [from, to] : starts) {
        if (covered.contains({from, to}) || !item_at(rules, from).alive || !item_at(rules, to).alive) continue;
        Chain chain;
        chain.items = {from, to};
        chain.frames = {item_at(rules, from).pose, item_at(rules, to).pose};
        const TurtleStep step = to_turtle_step(step_between(chain.frames[0], chain.frames[1]));
        extend(chain, rules, grid, step, rule.turn_change, rule.spin_change, tolerance);
        for (std::size_t k = 0; k + 1 < chain.items.size(); ++k) covered.insert({chain.items[k], chain.items[k + 1]});
        if (chain.items.size() >= 3) chains.push_back({chain, to_similarity(step)});
    }
    return chains;
}

}  // namespace rinceau

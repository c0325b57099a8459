#include "analyzer/chains.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "analyzer/canonical_step.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

const Item& item_at(const RuleSet& rules, int item) { return rules.items[static_cast<std::size_t>(item)]; }

/// (item, gauge) pairs numbered as they are met, with who follows whom.
class States {
  public:
    explicit States(std::size_t gauges) : gauges_(gauges) {}
    int id(int item, int gauge) {
        const auto key = static_cast<std::size_t>(item) * gauges_ + static_cast<std::size_t>(gauge);
        const auto [at, fresh] = ids_.try_emplace(key, static_cast<int>(list_.size()));
        if (fresh) list_.push_back({item, gauge});
        return at->second;
    }
    struct State {
        int item = 0, gauge = 0;
        int next = unknown, previous = none;
        double shift = 0;  // of the link that leads here
    };
    static constexpr int none = -1, unknown = -2;
    State& operator[](int id) { return list_[static_cast<std::size_t>(id)]; }
    int size() const { return static_cast<int>(list_.size()); }

  private:
    std::size_t gauges_;
    std::vector<State> list_;
    std::unordered_map<std::size_t, int> ids_;
};

/// Links `from` to the state that its step leads to; the nearer claimant of a state keeps it.
void link(States& states, int from, const RuleSet& rules, const PoseGrid& grid, const Part& part, const Similarity& step,
          const PoseTolerance& tolerance) {
    const States::State at = states[from];
    states[from].next = States::none;
    const Item& item = item_at(rules, at.item);
    const Similarity predicted = item.pose * part.symmetry.elements[static_cast<std::size_t>(at.gauge)] * step;
    const double distance = abs(predicted.translation - item.pose.translation);
    const auto match = grid.find(predicted, distance, tolerance);
    if (!match || match->item == at.item) return;
    const int to = states.id(match->item, match->gauge);
    const int rival = states[to].previous;
    if (rival != States::none) {
        if (states[to].shift <= match->shift) return;
        states[rival].next = States::none;
    }
    states[from].next = to;
    states[to].previous = from;
    states[to].shift = match->shift;
}

/// Walks from `start` until the end or until an item comes again; marks what it passes.
Chain walk(States& states, int start, const RuleSet& rules, const Part& part, std::vector<char>& passed) {
    Chain chain;
    chain.gauge = states[start].gauge;
    std::unordered_set<int> seen;
    for (int at = start; at >= 0 && !passed[static_cast<std::size_t>(at)]; at = states[at].next) {
        const States::State& state = states[at];
        if (!seen.insert(state.item).second) {
            chain.closed = state.item == chain.items.front() && chain.items.size() >= 3;
            break;
        }
        passed[static_cast<std::size_t>(at)] = 1;
        chain.items.push_back(state.item);
        chain.frames.push_back(item_at(rules, state.item).pose *
                               part.symmetry.elements[static_cast<std::size_t>(state.gauge)]);
        const int next = states[at].next;
        if (next >= 0 && states[next].item == chain.items.front() && chain.items.size() >= 3) chain.closed = true;
    }
    return chain;
}

/// A ring begins at its lowest element.
Chain begun_at_lowest(const RuleSet& rules, Chain chain) {
    if (!chain.closed) return chain;
    const auto lowest = std::ranges::min_element(chain.items, {}, [&](int i) { return item_at(rules, i).first; });
    const auto shift = lowest - chain.items.begin();
    std::ranges::rotate(chain.items, chain.items.begin() + shift);
    std::ranges::rotate(chain.frames, chain.frames.begin() + shift);
    return chain;
}

}  // namespace

std::vector<Chain> sequence_chains(const RuleSet& rules, const PoseGrid& grid, std::span<const int> sources,
                                   const Similarity& step, const PoseTolerance& tolerance) {
    const Part& part = rules.parts[static_cast<std::size_t>(grid.part())];
    States states(part.symmetry.elements.size());
    // Follow the step from every source in every gauge.
    for (const int source : sources) {
        if (!item_at(rules, source).alive) continue;
        for (int gauge = 0; gauge < static_cast<int>(part.symmetry.elements.size()); ++gauge) {
            for (int at = states.id(source, gauge); at >= 0 && states[at].next == States::unknown; at = states[at].next) {
                link(states, at, rules, grid, part, step, tolerance);
            }
        }
    }
    // Paths from states without a predecessor, then cycles.
    std::vector<char> passed(static_cast<std::size_t>(states.size()), 0);
    std::vector<Chain> chains;
    for (const bool cycles : {false, true}) {
        for (int start = 0; start < states.size(); ++start) {
            if (!cycles && states[start].previous != States::none) continue;
            // A path that meets an item twice goes on as a new chain.
            for (int at = start; at >= 0 && !passed[static_cast<std::size_t>(at)];) {
                Chain chain = walk(states, at, rules, part, passed);
                while (at >= 0 && passed[static_cast<std::size_t>(at)]) {
                    at = states[at].next;
                    if (at == start) break;
                }
                if (chain.items.size() >= 2) chains.push_back(begun_at_lowest(rules, std::move(chain)));
                if (cycles) break;
            }
        }
    }
    return chains;
}

namespace {

/// A frame at `item` heading for `target`.
Similarity heading_frame(const RuleSet& rules, int item, int target) {
    const Item& from = item_at(rules, item);
    const Point way = item_at(rules, target).pose.translation - from.pose.translation;
    const Complex heading = way / abs(way) * Complex{0, -1};
    return {scale_of(from.pose) * heading, from.pose.translation, false};
}

}  // namespace

std::vector<Chain> directed_chains(const RuleSet& rules, const PoseGrid& grid, std::span<const std::pair<int, int>> starts,
                                   const Similarity& step, const PoseTolerance& tolerance) {
    using Edge = std::pair<int, int>;
    std::map<Edge, Edge> next_edge;
    std::map<Edge, Edge> previous_edge;
    const Edge nowhere{-1, -1};
    const double advance = step.translation.y;
    // Follow every start edge forward; an edge leads to at most one other.
    for (const Edge& start : starts) {
        if (!item_at(rules, start.first).alive || !item_at(rules, start.second).alive) continue;
        Edge edge = start;
        while (!next_edge.contains(edge)) {
            next_edge[edge] = nowhere;
            const Similarity here = heading_frame(rules, edge.first, edge.second);
            const double length = abs(item_at(rules, edge.second).pose.translation - here.translation);
            if (std::abs(length - advance * scale_of(here)) > tolerance.shift(scale_of(here), length)) break;
            // The frame at the edge's end, as the step predicts its heading.
            Similarity there = here * step;
            there.translation = item_at(rules, edge.second).pose.translation;
            const auto match = grid.find(there * step, length, tolerance);
            if (!match || match->item == edge.second || match->item == edge.first) break;
            const Edge onward{edge.second, match->item};
            if (previous_edge.contains(onward)) break;
            next_edge[edge] = onward;
            previous_edge[onward] = edge;
            edge = onward;
        }
    }
    std::vector<Chain> chains;
    std::set<Edge> passed;
    for (const bool cycles : {false, true}) {
        for (const auto& [start, unused] : next_edge) {
            if (passed.contains(start) || (!cycles && previous_edge.contains(start))) continue;
            Chain chain;
            std::set<int> seen;
            for (Edge edge = start; edge != nowhere && passed.insert(edge).second; edge = next_edge[edge]) {
                if (!seen.insert(edge.first).second) break;
                chain.items.push_back(edge.first);
                chain.frames.push_back(heading_frame(rules, edge.first, edge.second));
                if (!next_edge.contains(edge)) break;
                const Edge onward = next_edge[edge];
                if (onward == nowhere && !seen.contains(edge.second)) {
                    chain.items.push_back(edge.second);
                    Similarity last = chain.frames.back() * step;
                    last.translation = item_at(rules, edge.second).pose.translation;
                    chain.frames.push_back(last);
                }
                if (edge.second == chain.items.front() && chain.items.size() >= 3) {
                    chain.closed = true;
                    break;
                }
            }
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

namespace {

/// What decides between chains, computed once each.
struct Precedence {
    std::size_t length = 0;
    bool closed = false, rising = false;
    int gauge = 0, first = 0;
    std::size_t index = 0;

    bool before(const Precedence& other) const {
        if (length != other.length) return length > other.length;
        if (closed != other.closed) return closed;
        if (rising != other.rising) return rising;
        if (gauge != other.gauge) return gauge < other.gauge;
        if (first != other.first) return first < other.first;
        return index < other.index;
    }
};

Precedence precedence_of(const RuleSet& rules, const Chain& chain, std::size_t index) {
    int balance = 0;
    for (std::size_t k = 0; k + 1 < chain.items.size(); ++k) {
        balance += item_at(rules, chain.items[k]).first < item_at(rules, chain.items[k + 1]).first ? 1 : -1;
    }
    return {chain.items.size(), chain.closed, balance > 0, chain.gauge, item_at(rules, chain.items.front()).first, index};
}

}  // namespace

std::vector<Chain> claimed(const RuleSet& rules, std::vector<Chain> chains) {
    std::vector<Precedence> order;
    order.reserve(chains.size());
    for (std::size_t c = 0; c < chains.size(); ++c) order.push_back(precedence_of(rules, chains[c], c));
    std::ranges::sort(order, [](const Precedence& a, const Precedence& b) { return a.before(b); });
    const bool long_ones = !order.empty() && order.front().length >= 4;
    const std::size_t least = long_ones ? 3 : 2;
    std::vector<char> used(rules.items.size(), 0);
    std::vector<Chain> disjoint;
    for (const Precedence& next : order) {
        if (next.length < least) break;
        Chain& chain = chains[next.index];
        // The longest run of free items.
        std::size_t best_begin = 0, best_length = 0, begin = 0;
        for (std::size_t k = 0; k <= chain.items.size(); ++k) {
            if (k < chain.items.size() && !used[static_cast<std::size_t>(chain.items[k])]) continue;
            if (k - begin > best_length) {
                best_length = k - begin;
                best_begin = begin;
            }
            begin = k + 1;
        }
        if (best_length < least) continue;
        if (best_length < chain.items.size()) {
            const auto from = static_cast<std::ptrdiff_t>(best_begin);
            const auto to = from + static_cast<std::ptrdiff_t>(best_length);
            chain.items = {chain.items.begin() + from, chain.items.begin() + to};
            chain.frames = {chain.frames.begin() + from, chain.frames.begin() + to};
            chain.closed = false;
        }
        for (const int item : chain.items) used[static_cast<std::size_t>(item)] = 1;
        disjoint.push_back(std::move(chain));
    }
    return disjoint;
}

}  // namespace rinceau

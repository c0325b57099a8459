// Proximity, enclosure and repetition, as a person groups shapes.

#include "growth/figure_groups.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>

#include "geometry/box_tree.h"
#include "growth/figure_shapes.h"
#include "growth/joined_sets.h"

namespace rinceau {
namespace {

enum class Contact : unsigned char { inside, touch };

struct PartContact {
    int a = 0;
    int b = 0;
    Contact contact = Contact::touch;
};

/// The parts that are grouped, by their places in the list.
class Grouping {
  public:
    Grouping(const FigureParts& parts, const std::vector<int>& among) : parts_(parts), among_(among), sets_(among.size()) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < among.size(); ++i) {
            boxes.push_back(part(i).box);
            picture_ = including(picture_, boxes.back());
        }
        tree_ = BoxTree(boxes);
    }

    std::vector<std::vector<int>> groups() {
        find_contacts();
        join_contacts();
        join_grammar_groups();
        join_clusters();
        std::vector<std::vector<int>> result = sets_.sets();
        for (auto& group : result)
            for (int& member : group) member = among_[static_cast<std::size_t>(member)];
        return result;
    }

  private:
    const FigurePart& part(std::size_t i) const { return parts_.parts[static_cast<std::size_t>(among_[i])]; }
    const FigurePart& part(int i) const { return part(static_cast<std::size_t>(i)); }

    Box box_of(const std::vector<int>& members) const {
        Box box;
        for (const int i : members) box = including(box, part(i).box);
        return box;
    }

    std::optional<Contact> contact(const FigurePart& a, const FigurePart& b) const {
        if (lies_inside({a.region, a.box}, {b.filled, b.box}) || lies_inside({b.region, b.box}, {a.filled, a.box}))
            return Contact::inside;
        if (a.kept || b.kept) return {};  // a box tells nothing about what touches
        constexpr double nearly = 0.01;   // of the smaller one
        const double slack = nearly * std::min(diagonal(a.box), diagonal(b.box));
        if (region_gap({a.region, a.box}, {b.region, b.box}, slack) < slack) return Contact::touch;
        return {};
    }

    void find_contacts() {
        for (int i = 0; i < static_cast<int>(among_.size()); ++i)
            tree_.visit(grown(part(i).box, 0.01 * diagonal(part(i).box)), [&](std::size_t other) {
                const int j = static_cast<int>(other);
                if (j <= i) return true;
                if (const auto kind = contact(part(i), part(j))) contacts_.push_back({i, j, *kind});
                return true;
            });
    }

    /// Shapes of one kind: copies of a terminal, or, of those that have few copies, what is painted in one style.
    std::pair<int, int> kind_of(int i, const std::map<int, int>& copies) const {
        const Placement& placement = part(i).placement;
        constexpr int few = 3;
        const Terminal& terminal = parts_.grammar.terminals[static_cast<std::size_t>(placement.terminal)];
        if (copies.at(placement.terminal) >= few) return {placement.terminal, -1};
        return {-1, placement.style != 0 ? placement.style : terminal.style};
    }

    /// Per part: do most of its kind stand alone?
    std::vector<bool> loners() const {
        std::map<int, int> copies;
        for (std::size_t i = 0; i < among_.size(); ++i) ++copies[part(i).placement.terminal];
        std::vector<bool> alone(among_.size(), true);
        for (const PartContact& c : contacts_)
            alone[static_cast<std::size_t>(c.a)] = alone[static_cast<std::size_t>(c.b)] = false;
        std::map<std::pair<int, int>, std::pair<int, int>> counts;  // kind -> alone, all
        for (int i = 0; i < static_cast<int>(among_.size()); ++i) {
            auto& [single, all] = counts[kind_of(i, copies)];
            single += alone[static_cast<std::size_t>(i)] ? 1 : 0;
            ++all;
        }
        std::vector<bool> result;
        for (int i = 0; i < static_cast<int>(among_.size()); ++i) {
            const auto& [single, all] = counts[kind_of(i, copies)];
            result.push_back(2 * single > all);
        }
        return result;
    }

    bool too_wide(const std::vector<int>& members) const {
        constexpr double widest = 0.5;  // of the picture
        return diagonal(box_of(members)) > widest * diagonal(picture_) && 2 * members.size() > 8;
    }

    void join_contacts() {
        const std::vector<bool> loner = loners();
        JoinedSets touching(among_.size());
        for (const PartContact& c : contacts_) {
            if (c.contact == Contact::inside) sets_.join(c.a, c.b);
            const bool by_chance = loner[static_cast<std::size_t>(c.a)] || loner[static_cast<std::size_t>(c.b)];
            if (c.contact == Contact::inside || !by_chance) touching.join(c.a, c.b);
        }
        for (const auto& net : touching.sets()) {
            if (net.size() < 2) continue;
            if (too_wide(net)) {
                join_innermost_groups(net);
            } else {
                for (const int i : net) sets_.join(net.front(), i);
            }
        }
    }

    /// Parts whose addresses begin alike are drawn by one module.
    std::map<std::vector<int>, std::vector<int>> modules_of(const std::vector<int>& members) const {
        std::map<std::vector<int>, std::vector<int>> modules;
        for (const int i : members) {
            std::vector<int> address = part(i).placement.address;
            constexpr int most_levels = 6;  // above, modules draw more than a thing
            for (int level = 0; level < most_levels && address.size() > 1; ++level) {
                address.pop_back();
                modules[address].push_back(i);
            }
        }
        std::erase_if(modules, [](const auto& module) { return module.second.size() < 2; });
        return modules;
    }

    std::vector<int> terminals_of(const std::vector<int>& members) const {
        std::vector<int> terminals;
        for (const int i : members) terminals.push_back(part(i).placement.terminal);
        std::ranges::sort(terminals);
        return terminals;
    }

    /// What modules without modules below them draw together, if it is drawn at least twice and holds different shapes.
    void join_innermost_groups(const std::vector<int>& net) {
        const auto modules = modules_of(net);
        std::map<std::vector<int>, std::vector<const std::vector<int>*>> alike;
        for (const auto& [address, members] : modules) {
            const auto next = modules.upper_bound(address);
            const bool innermost = next == modules.end() || next->first.size() <= address.size() ||
                                   !std::equal(address.begin(), address.end(), next->first.begin());
            const std::vector<int> terminals = terminals_of(members);
            if (innermost && terminals.front() != terminals.back()) alike[terminals].push_back(&members);
        }
        for (const auto& [terminals, copies] : alike) {
            if (copies.size() < 2) continue;
            for (const auto* members : copies)
                for (const int i : *members) sets_.join(members->front(), i);
        }
    }

    /// The sets of the members, if these hold nothing else.
    std::optional<std::vector<std::vector<int>>> whole_sets(const std::vector<int>& members) {
        std::map<int, std::vector<int>> sets;
        for (const int i : members) sets[sets_.root(i)].push_back(i);
        std::vector<std::vector<int>> result;
        for (auto& [root, of_members] : sets) {
            if (of_members.size() != sets_.size_of(root)) return {};
            result.push_back(std::move(of_members));
        }
        return result;
    }

    /// Least gap from the members to other parts, below `within`.
    double gap_to_others(const std::vector<int>& members, const std::function<bool(int)>& is_other, double within) const {
        for (const int i : members)
            tree_.visit(grown(part(i).box, within), [&](std::size_t other) {
                const int j = static_cast<int>(other);
                if (is_other(j)) within = region_gap({part(i).region, part(i).box}, {part(j).region, part(j).box}, within);
                return true;
            });
        return within;
    }

    /// The largest gap that must be bridged to join the sets, each to its nearest; nothing if it is more than `most`.
    std::optional<double> inner_gap(const std::vector<std::vector<int>>& sets, double most) const {
        std::vector<bool> joined(sets.size());
        std::vector<double> least(sets.size(), std::nextafter(most, INFINITY));
        double widest = 0;
        std::size_t newest = 0;
        for (std::size_t step = 1; step < sets.size(); ++step) {
            joined[newest] = true;
            std::size_t nearest = sets.size();
            for (std::size_t s = 0; s < sets.size(); ++s) {
                if (joined[s]) continue;
                const auto& members = sets[newest];
                least[s] = gap_to_others(
                    sets[s], [&](int j) { return std::ranges::binary_search(members, j); }, least[s]);
                if (nearest == sets.size() || least[s] < least[nearest]) nearest = s;
            }
            widest = std::max(widest, least[nearest]);
            if (widest > most) return {};
            newest = nearest;
        }
        return widest;
    }

    /// Gaps within a thing are small beside its parts and clearly smaller than those to other things.
    bool stands_apart(const std::vector<int>& members, const std::vector<std::vector<int>>& sets) const {
        constexpr double small = 0.3;    // of the smallest part's diagonal
        constexpr double clearly = 0.6;  // of the gap to anything else
        double smallest = INFINITY;
        for (const auto& set : sets) smallest = std::min(smallest, diagonal(box_of(set)));
        const auto inner = inner_gap(sets, small * smallest);
        if (!inner) return false;
        std::vector<int> sorted = members;
        std::ranges::sort(sorted);
        const double wanted = *inner / clearly;
        const auto outside = [&](int j) { return !std::ranges::binary_search(sorted, j); };
        return gap_to_others(members, outside, std::nextafter(wanted, INFINITY)) > wanted;
    }

    void join_grammar_groups() {
        std::vector<int> all(among_.size());
        std::iota(all.begin(), all.end(), 0);
        const auto modules = modules_of(all);
        std::map<std::vector<int>, int> copies;
        std::vector<std::pair<std::size_t, const std::vector<int>*>> by_depth;
        constexpr std::size_t most_parts = 64;  // of a thing that is not enclosed by one shape
        for (const auto& [address, members] : modules) {
            if (members.size() > most_parts || too_wide(members)) continue;
            by_depth.emplace_back(address.size(), &members);
            ++copies[terminals_of(members)];
        }
        std::ranges::stable_sort(by_depth, std::greater{}, &std::pair<std::size_t, const std::vector<int>*>::first);
        for (const auto& [depth, members] : by_depth) {
            if (copies[terminals_of(*members)] < 2) continue;
            const auto sets = whole_sets(*members);
            if (!sets || sets->size() < 2 || !stands_apart(*members, *sets)) continue;
            for (const int i : *members) sets_.join(members->front(), i);
        }
    }

    struct SetGap {
        double gap = 0;
        int a = 0;
        int b = 0;
    };

    /// Gaps between parts of different sets, shortest first, up to a share of a set's usual size.
    std::vector<SetGap> short_gaps(const std::vector<std::vector<int>>& sets) {
        constexpr double share = 0.3;
        std::vector<double> sizes;
        for (const auto& set : sets) sizes.push_back(diagonal(box_of(set)));
        std::ranges::nth_element(sizes, sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2));
        const double reach = share * sizes[sizes.size() / 2];
        std::vector<SetGap> gaps;
        for (int i = 0; i < static_cast<int>(among_.size()); ++i)
            tree_.visit(grown(part(i).box, reach), [&](std::size_t other) {
                const int j = static_cast<int>(other);
                if (j <= i || sets_.root(i) == sets_.root(j)) return true;
                const double gap = region_gap({part(i).region, part(i).box}, {part(j).region, part(j).box}, reach);
                if (gap < reach) gaps.push_back({gap, i, j});
                return true;
            });
        std::ranges::stable_sort(gaps, {}, &SetGap::gap);
        return gaps;
    }

    /// Do nearly all sets that are whole hold several parts, and the same ones?
    bool equal_clusters(JoinedSets& joined) const {
        constexpr std::size_t most_parts = 12;
        constexpr double nearly_all = 0.8;
        constexpr std::size_t fewest = 4;
        std::map<std::vector<int>, std::size_t> copies;
        std::size_t whole = 0;
        for (const auto& set : joined.sets()) {
            if (std::ranges::any_of(set, [&](int i) { return part(i).cut; })) continue;
            ++whole;
            if (set.size() >= 2 && set.size() <= most_parts) ++copies[terminals_of(set)];
        }
        std::size_t most = 0;
        for (const auto& [terminals, count] : copies) most = std::max(most, count);
        return most >= fewest && static_cast<double>(most) >= nearly_all * static_cast<double>(whole);
    }

    /// Joins by gaps up to a limit that is followed by much wider ones, if that makes clusters of equal composition.
    void join_clusters() {
        const auto sets = sets_.sets();
        constexpr std::size_t few = 8;
        if (sets.size() < few || equal_clusters(sets_)) return;
        const std::vector<SetGap> gaps = short_gaps(sets);
        constexpr double much_wider = 1.6;
        JoinedSets joined = sets_;
        for (std::size_t k = 0; k < gaps.size(); ++k) {
            joined.join(gaps[k].a, gaps[k].b);
            const bool jump = k + 1 == gaps.size() || gaps[k + 1].gap > much_wider * gaps[k].gap;
            if (!jump || !equal_clusters(joined)) continue;
            sets_ = joined;
            return;
        }
    }

    const FigureParts& parts_;
    const std::vector<int>& among_;
    JoinedSets sets_;
    std::vector<PartContact> contacts_;
    BoxTree tree_;
    Box picture_;
};

Box picture_box(const FigureParts& parts) {
    if (!is_empty(parts.grammar.canvas) && diagonal(parts.grammar.canvas) > 0) return parts.grammar.canvas;
    Box box;
    for (const FigurePart& part : parts.parts) box = including(box, part.box);
    return box;
}

double covered_share(const FigurePart& part, const Box& picture) {
    const Region all{{picture.low, {picture.high.x, picture.low.y}, picture.high, {picture.low.x, picture.high.y}}};
    return area(intersection_of(part.filled, all)) / (width(picture) * height(picture));
}

bool spans(const Box& box, const Box& picture) {
    constexpr double whole_way = 0.95;
    const double across = std::min(box.high.x, picture.high.x) - std::max(box.low.x, picture.low.x);
    const double up = std::min(box.high.y, picture.high.y) - std::max(box.low.y, picture.low.y);
    return across > whole_way * width(picture) || up > whole_way * height(picture);
}

}  // namespace

std::vector<int> background_parts(const FigureParts& parts, bool single) {
    const Box picture = picture_box(parts);
    if (!(width(picture) > 0 && height(picture) > 0)) return {};
    const auto holds_another = [&](const FigurePart& part) {
        return std::ranges::any_of(parts.parts, [&](const FigurePart& other) {
            return &other != &part && lies_inside({other.region, other.box}, {part.filled, part.box});
        });
    };
    constexpr double fills = 0.98;
    constexpr double covers_most = 0.6;
    std::vector<int> background;
    for (std::size_t i = 0; i < parts.parts.size(); ++i) {
        const FigurePart& part = parts.parts[i];
        if (!spans(part.box, picture) && width(part.box) * height(part.box) < covers_most * width(picture) * height(picture))
            continue;
        const double share = covered_share(part, picture);
        const bool below_others = share >= covers_most || (spans(part.box, picture) && holds_another(part));
        if (share >= fills || (!single && below_others)) background.push_back(static_cast<int>(i));
    }
    return background.size() < parts.parts.size() ? background : std::vector<int>{};
}

std::vector<std::vector<int>> grouped_parts(const FigureParts& parts, const std::vector<int>& among) {
    return Grouping(parts, among).groups();
}

}  // namespace rinceau

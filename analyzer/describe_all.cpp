#include "analyzer/describe_all.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>

#include "analyzer/regular_drawing.h"
#include "analyzer/regular_roots.h"
#include "geometry/parallel.h"

namespace rinceau {

namespace {

/// Stage and share that are told while no count of it is at hand.
constexpr const char* stage = "rules";
constexpr double nearly_done = 0.99;

/// Is the whole drawing one row of one thing, or rows of one row, moved only and exactly? What a person sees is found then,
/// and nothing says less: no need to look any further.
bool is_plain_lattice(const Description& description) {
    const RuleSet& found = description.ordered.rules;
    constexpr std::size_t rows_of_rows = 2;
    return description.ordered.roots.size() == 1 && !found.rules.empty() && found.rules.size() <= rows_of_rows &&
           description.exact.exceptions.empty() && std::ranges::all_of(found.rules, [](const Rule& rule) {
               return rule.kind == RuleKind::sequence && rule.step.linear == Complex{1, 0} && !rule.step.mirrored;
           });
}

/// Members of the longest ring.
int longest_ring(const Description& description) {
    const RuleSet& rules = description.ordered.rules;
    int longest = 0;
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        const Part& part = rules.parts[p];
        if (part.rule < 0 || description.written.symbol_of_part[p].empty()) continue;
        if (rules.rules[static_cast<std::size_t>(part.rule)].kind == RuleKind::ring) longest = std::max(longest, part.count);
    }
    return longest;
}

/// Is what was opened what a person sees? It must cost little enough also if nobody minds what cannot be seen, and clearly
/// less if it breaks a ring: sixty minutes are not five minutes twelve times.
bool is_convincing(const Description& opened, const Description& from_below) {
    const auto visible_cost = [](const Description& d) { return d.cost - d.bits.unseen; };
    const bool longer = opened.exact.productions.size() > from_below.exact.productions.size() ||
                        longest_ring(opened) < longest_ring(from_below);
    const ConvincingCost& most = longer ? opened.if_longer : opened.if_not_longer;
    return opened.cost < most.all * from_below.cost && visible_cost(opened) < most.visible * visible_cost(from_below);
}

class Describer {
  public:
    Describer(const std::vector<Drawing>& drawings, const std::vector<std::span<const SearchState>>& starts,
              const SearchOptions& search)
        : drawings_(drawings), starts_(starts), search_(search), from_below_(drawings.size() * tolerances()) {}

    std::vector<Description> run(int threads, const Progress& progress) {
        const Opening below = opening_from_below();
        for_each_index(from_below_.size(), threads, stage, progress, [&](std::size_t way, const Progress& told) {
            try {
                describe_from_below(below, way, told);
            } catch (const Settled&) {
                // Another one leaves nothing to wish for.
            }
        });
        if (settled_) return only_first();
        if (search_.objective == Objective::bits) describe_opened(threads, progress);
        return ranked();
    }

  private:
    struct Settled {};

    struct Opened {
        std::size_t way = 0;
        Opening opening;
        std::optional<Description> description;
    };

    std::size_t tolerances() const { return starts_.empty() ? 0 : starts_.front().size(); }
    /// `way` counts readings of the drawing and tolerances.
    const SearchState& start(std::size_t way) const { return starts_[way / tolerances()][way % tolerances()]; }

    std::optional<Description> described(const Opening& opening, std::size_t way, const Progress& told) const {
        std::optional<SearchState> opened = opening.open(start(way), search_, told);
        if (!opened) return std::nullopt;
        report(told, stage, nearly_done);
        SearchState found = generate_rules(std::move(*opened), search_, told);
        report(told, stage, nearly_done);
        auto description = describe(drawings_[way / tolerances()], std::move(found.rules), start(way).tolerance.size);
        if (!description) return std::nullopt;
        description->if_longer = opening.if_longer;
        description->if_not_longer = opening.if_not_longer;
        return description;
    }

    void describe_from_below(const Opening& below, std::size_t way, const Progress& told) {
        const Progress until_settled = [&](std::string_view now, double fraction) {
            if (settled_) throw Settled{};
            report(told, now, fraction);
        };
        if (settled_) return;
        from_below_[way] = described(below, way, until_settled);
        // Only the first of all may settle it, so that the result is the same for any order of the calls.
        if (way == 0 && from_below_[way] && is_plain_lattice(*from_below_[way])) settled_ = true;
    }

    std::vector<Description> only_first() {
        std::vector<Description> first;
        first.push_back(std::move(*from_below_.front()));
        return first;
    }

    /// Of each reading the first tolerance and the one that was best from below.
    std::vector<std::size_t> ways_to_open() const {
        std::vector<std::size_t> ways;
        const auto cost = [&](std::size_t way) { return from_below_[way] ? from_below_[way]->cost : HUGE_VAL; };
        for (std::size_t first = 0; first < from_below_.size(); first += tolerances()) {
            std::size_t best = first;
            for (std::size_t way = first; way < first + tolerances(); ++way) {
                if (cost(way) < cost(best)) best = way;
            }
            ways.push_back(first);
            if (best != first) ways.push_back(best);
        }
        return ways;
    }

    void describe_opened(int threads, const Progress& progress) {
        const std::vector<std::size_t> ways = ways_to_open();
        std::vector<std::vector<Opening>> openings(ways.size());
        for_each_index(ways.size(), threads, stage, progress,
                       [&](std::size_t k, const Progress&) { openings[k] = openings_of(start(ways[k])); });
        for (std::size_t k = 0; k < ways.size(); ++k) {
            for (Opening& opening : openings[k]) opened_.push_back({ways[k], std::move(opening), std::nullopt});
        }
        for_each_index(opened_.size(), threads, stage, progress, [&](std::size_t k, const Progress& told) {
            opened_[k].description = described(opened_[k].opening, opened_[k].way, told);
        });
    }

    /// What was opened goes before what was found from below if the best of the one convinces beside the best of the other.
    std::vector<Description> ranked() {
        std::vector<Description> below, opened;
        for (auto& description : from_below_) {
            if (description) below.push_back(std::move(*description));
        }
        for (Opened& each : opened_) {
            if (each.description) opened.push_back(std::move(*each.description));
        }
        std::ranges::stable_sort(below, {}, &Description::cost);
        std::ranges::stable_sort(opened, {}, &Description::cost);
        const bool opened_first = !opened.empty() && (below.empty() || is_convincing(opened.front(), below.front()));
        std::vector<Description>& first = opened_first ? opened : below;
        std::vector<Description>& second = opened_first ? below : opened;
        std::ranges::move(second, std::back_inserter(first));
        return std::move(first);
    }

    const std::vector<Drawing>& drawings_;
    const std::vector<std::span<const SearchState>>& starts_;
    const SearchOptions& search_;
    std::vector<std::optional<Description>> from_below_;
    std::vector<Opened> opened_;
    std::atomic<bool> settled_ = false;
};

/// Of things that are alike, how many the axiom lists one by one at most.
int most_alike_in_axiom(const Description& description) {
    std::map<int, int> times;
    int most = 0;
    for (const int root : description.ordered.roots) {
        const Item& item = description.ordered.rules.items[static_cast<std::size_t>(root)];
        most = std::max(most, ++times[item.part]);
    }
    return most;
}

/// Do exact rules leave so much that the drawing may be an irregular one?
bool may_be_irregular(const std::vector<Description>& exact) {
    // What they say in a quarter of the bits has its structure already, unless many equal things are left over.
    constexpr double well_explained = 0.25;
    constexpr int few = 5;
    if (exact.empty()) return true;
    const bool listed = most_alike_in_axiom(exact.front()) >= few;
    return listed || std::ranges::none_of(
                         exact, [](const Description& d) { return d.bits.grammar < well_explained * d.bits.drawing; });
}

/// Do nearly all elements stand where the rules put them, or next to it?
bool leaves_little_over(const Description& description) {
    constexpr double little = 0.05;          // of an element's size
    constexpr double most_exceptions = 0.2;  // of the elements
    double off = 0;
    for (std::size_t leaf = 0; leaf < description.deviation.size(); ++leaf) {
        const auto element = static_cast<std::size_t>(description.written.element_of_leaf[leaf]);
        off += description.deviation[leaf] > little * scale_of(description.reading->instancing.instances[element].pose);
    }
    return off <= most_exceptions * static_cast<double>(description.deviation.size());
}

/// Rules that leave little over are what is there; regular ones that leave more must say clearly less.
bool says_clearly_less(const Description& regular, const std::vector<Description>& exact) {
    constexpr double clearly = 0.9;
    return std::ranges::none_of(exact, [&](const Description& rules) {
        return !rules.exact.productions.empty() && leaves_little_over(rules) && regular.cost >= clearly * rules.cost;
    });
}

}  // namespace

std::vector<Description> describe_all(const std::vector<Drawing>& drawings,
                                      const std::vector<std::span<const SearchState>>& starts, const SearchOptions& search,
                                      int threads, const Progress& progress) {
    return Describer(drawings, starts, search).run(threads, progress);
}

std::vector<Description> describe_irregular(const std::vector<Drawing>& drawings, std::vector<Description> exact,
                                            const SearchOptions& search, int threads, const Progress& progress) {
    if (!may_be_irregular(exact)) return exact;
    constexpr double size = PoseTolerance{}.size;
    std::vector<const Drawing*> drawn;
    std::vector<Drawing> meant;
    std::vector<SearchState> states;
    for (const Drawing& drawing : drawings) {
        const std::optional<Instancing> regular = regular_drawing(drawing.instancing, drawing.diagonal);
        if (!regular) continue;
        drawn.push_back(&drawing);
        meant.push_back(drawing);
        states.push_back(starting_state(*regular, {size, size, PoseTolerance{}.per_distance}, drawing.diagonal));
    }
    std::vector<std::span<const SearchState>> starts;
    for (const SearchState& state : states) starts.emplace_back(&state, 1);
    std::vector<Description> loose = describe_all(meant, starts, search, threads, progress);
    for (Description& description : loose) {
        description.reading = drawn[static_cast<std::size_t>(description.reading - meant.data())];
    }
    std::erase_if(loose, [&](const Description& each) { return !says_clearly_less(each, exact); });
    // What keeps the best exact rules and says more need only be shorter.
    if (!exact.empty()) {
        if (auto placed = with_regular_roots(exact.front(), search, progress)) loose.push_back(std::move(*placed));
    }
    // Beside exact ones the cost decides; these keep their order.
    const auto place = [&](const Description& each) {
        return std::ranges::find_if(exact, [&](const Description& other) { return each.cost < other.cost; });
    };
    for (Description& description : loose) exact.insert(place(description), std::move(description));
    return exact;
}

}  // namespace rinceau

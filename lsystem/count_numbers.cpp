#include <algorithm>
#include <limits>
#include <set>

#include "geometry/index.h"
#include "lsystem/ring.h"
#include "lsystem/string_numbers.h"

namespace rinceau {

namespace {

/// "axiom.Row", "Wall.Row.2".
std::string name_of_use(const Grammar& grammar, const LoopUse& use) {
    const auto& string = string_at(grammar, use.string);
    const std::string& symbol = string[at(use.position)].symbol;
    const auto is_this = [&](const ModuleTemplate& module) { return module.symbol == symbol; };
    const auto here = string.begin() + use.position + 1;
    const auto ordinal = std::count_if(string.begin(), here, is_this);
    const bool several = ordinal > 1 || std::any_of(here, string.end(), is_this);
    const std::string name = name_of_string(grammar, use.string) + '.' + symbol;
    return several ? name + '.' + std::to_string(ordinal) : name;
}

std::string help_of(const Grammar& grammar, const RuleLoop& loop, const std::vector<Ring>& rings) {
    if (loop.continuations.size() > 1) return "levels of branches";
    const bool ring = std::ranges::any_of(rings, [&](const Ring& r) { return r.loop.production == loop.production; });
    if (ring) return "elements in the ring";
    const auto& string = grammar.productions[at(loop.production)].successor;
    const bool mirrored = std::ranges::any_of(way_to(string, loop.continuations.front().symbol),
                                              [&](int position) { return string[at(position)].symbol == "|"; });
    return mirrored ? "elements, every other one mirrored" : "elements in the row";
}

class CountNumbers {
  public:
    CountNumbers(const Grammar& grammar, const std::vector<RuleLoop>& loops)
        : grammar_(grammar), loops_(loops), rings_(closed_rings(grammar)) {}

    std::vector<GrammarNumber> list() {
        for (const RuleLoop& loop : loops_) add_loop(loop);
        return std::move(result_);
    }

  private:
    const Grammar& grammar_;
    const std::vector<RuleLoop>& loops_;
    std::vector<Ring> rings_;
    std::set<std::string> named_;
    std::vector<GrammarNumber> result_;

    void add_loop(const RuleLoop& loop) {
        const std::string role = loop.continuations.size() > 1 ? ".levels" : ".count";
        const StringPlace place{StringPlace::In::production, loop.production};
        GrammarNumber all = blank(loop, name_of_string(grammar_, place) + role);
        std::vector<GrammarNumber> each;
        for (const LoopUse& use : uses_of(grammar_, loop)) {
            if (!use.count) continue;
            GrammarNumber number = blank(loop, name_of_use(grammar_, use) + role);
            number.value = *use.count;
            number.slots = {{NumberSlot::In::expression, use.written, 0, use.law.slope, use.law.offset}};
            describe_written(grammar_, part_at(grammar_, use.written), number);
            if (named_.insert(number.name).second) each.push_back(std::move(number));
        }
        if (!each.empty()) join(std::move(all), std::move(each));
    }

    GrammarNumber blank(const RuleLoop& loop, std::string name) const {
        GrammarNumber number;
        number.name = std::move(name);
        number.kind = NumberKind::count;
        number.help = help_of(grammar_, loop, rings_);
        number.whole = true;
        number.high = std::numeric_limits<double>::infinity();
        number.rank = NumberRank::rule;
        return number;
    }

    void join(GrammarNumber all, std::vector<GrammarNumber> each) {
        all.value = each.front().value;
        const bool equal = std::ranges::all_of(each, [&](const GrammarNumber& number) { return number.value == all.value; });
        if (equal) {
            all.constant = each.front().constant;
            all.written = each.front().written;
            for (GrammarNumber& number : each) {
                if (std::ranges::find(all.slots, number.slots.front()) == all.slots.end())
                    all.slots.push_back(number.slots.front());
                if (number.constant != all.constant) all.constant = -1;
                number.rank = NumberRank::hidden;
            }
            if (all.constant >= 0) all.rank = NumberRank::hidden;
            if (all.slots.size() > 1) all.help += ", in " + std::to_string(all.slots.size()) + " places";
        } else {
            all.rank = NumberRank::hidden;
            all.help += ", in all places";
            for (const GrammarNumber& number : each) all.parts.push_back(number.name);
        }
        result_.push_back(std::move(all));
        for (GrammarNumber& number : each) result_.push_back(std::move(number));
    }
};

}  // namespace

std::vector<GrammarNumber> count_numbers(const Grammar& grammar, const std::vector<RuleLoop>& loops) {
    return CountNumbers(grammar, loops).list();
}

}  // namespace rinceau

#include "lsystem/regular_steps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "lsystem/keep_rings.h"
#include "lsystem/number_slots.h"
#include "lsystem/number_text.h"
#include "lsystem/numbers.h"
#include "lsystem/ring.h"
#include "lsystem/set_numbers.h"
#include "lsystem/string_numbers.h"

namespace rinceau {

namespace {

constexpr double full_circle = 360;

/// How near is nearly.
struct Nearness {
    double share = 0;         // of a distance or scale
    double angle = 0;         // degrees, of one step
    double bend = 0;          // degrees, of a whole row
    double closing = 0;       // degrees that a ring is open, or overlaps, ..
    double closing_step = 0;  // .. and share of its turn
};

/// At 1: what a hand misses by, and no one means. Half a step is as near to one element more as to one less.
Nearness nearness(double tolerance) {
    constexpr double less_than_half = 0.49;
    return {0.02 * tolerance, tolerance, 2.5 * tolerance, 10 * tolerance, std::min(0.25 * tolerance, less_than_half)};
}

EditResult close_near_rings(const Grammar& grammar, const Nearness& near) {
    std::vector<Ring> rings;
    for (const RuleLoop& loop : rule_loops(grammar)) {
        for (const LoopUse& use : uses_of(grammar, loop)) {
            if (!use.count) continue;
            const auto turn = turn_of(grammar, loop, use);
            const double elements = elements_of(loop, use);
            if (!turn || elements < 3) continue;
            const double missing = std::abs(elements * std::abs(*turn) - full_circle);
            constexpr double exact = 1e-9;
            if (missing < exact || missing > near.closing || missing > near.closing_step * std::abs(*turn)) continue;
            rings.push_back({loop, use, elements, *turn, 1});
        }
    }
    return close_rings(grammar, std::move(rings));
}

/// "Row.", "R.1.": what stands before a number of a step, with its number of elements.
struct Step {
    std::string path;
    double count = 1;
};

std::vector<Step> steps_of(const Grammar& grammar, const RuleLoop& loop) {
    double count = 1;
    for (const LoopUse& use : uses_of(grammar, loop)) count = std::max(count, use.count.value_or(1));
    const std::string name = name_of_string(grammar, {StringPlace::In::production, loop.production});
    std::vector<Step> steps;
    for (const Approach& approach : loop.continuations)
        steps.push_back({name + (approach.of > 1 ? '.' + std::to_string(approach.ordinal) : "") + '.', count});
    return steps;
}

class Straightener {
  public:
    Straightener(const Grammar& grammar, const Nearness& near) : near_(near), result_{grammar, {}} {}

    EditResult straighten() {
        for (const RuleLoop& loop : rule_loops(result_.grammar))
            for (const Step& step : steps_of(result_.grammar, loop)) straighten(step);
        for (const std::vector<std::string>& siblings : families()) agree(siblings);
        return std::move(result_);
    }

  private:
    Nearness near_;
    EditResult result_;

    std::map<std::string, GrammarNumber> numbers() const {
        std::map<std::string, GrammarNumber> by_name;
        for (GrammarNumber& number : grammar_numbers(result_.grammar)) by_name.emplace(number.name, std::move(number));
        return by_name;
    }
    void set(const std::string& name, double value) {
        const NumberEdit edit{name, NumberEdit::How::set, number_expression(value)};
        EditResult edited = set_numbers(result_.grammar, {&edit, 1}, {.keep_rings_closed = false});
        result_.grammar = std::move(edited.grammar);
        result_.changes.insert(result_.changes.end(), edited.changes.begin(), edited.changes.end());
    }

    void straighten(const Step& step) {
        const auto all = numbers();
        const auto value = [&](const std::string& role) {
            const auto found = all.find(step.path + role);
            return found == all.end() ? 0 : found->second.value;
        };
        const double rotation = value("rotation");
        const double reach = std::abs(rotation) * std::max(1.0, step.count - 1);
        if (rotation != 0 && std::abs(rotation) < near_.angle && reach < near_.bend) set(step.path + "rotation", 0);
        const double forward = std::abs(value("forward"));
        const double sideways = std::abs(value("sideways"));
        if (forward != 0 && forward < near_.share * sideways) set(step.path + "forward", 0);
        if (sideways != 0 && sideways < near_.share * forward) set(step.path + "sideways", 0);
    }

    /// Paths of steps that stand side by side.
    std::vector<std::vector<std::string>> families() const {
        std::map<std::vector<int>, std::set<std::string>> by_string;
        for (const RuleLoop& loop : rule_loops(result_.grammar)) {
            for (const Step& step : steps_of(result_.grammar, loop)) {
                by_string[{-1, loop.production}].insert(step.path);
                for (const LoopUse& use : uses_of(result_.grammar, loop))
                    by_string[{static_cast<int>(use.string.in), use.string.index}].insert(step.path);
            }
        }
        std::vector<std::vector<std::string>> families;
        for (const auto& [string, paths] : by_string)
            if (paths.size() > 1) families.emplace_back(paths.begin(), paths.end());
        return families;
    }

    bool nearly_equal(const GrammarNumber& a, const GrammarNumber& b) const {
        const double difference = std::abs(std::abs(a.value) - std::abs(b.value));
        if (a.kind == NumberKind::angle) return difference <= near_.angle;
        return difference <= near_.share * std::max(std::abs(a.value), std::abs(b.value));
    }

    void agree(const std::vector<std::string>& paths) {
        for (const char* role : {"turn", "distance", "forward", "sideways", "scale", "spin", "rotation"}) {
            const auto all = numbers();
            std::vector<const GrammarNumber*> members;
            for (const std::string& path : paths) {
                const auto found = all.find(path + role);
                if (found != all.end() && found->second.written.empty()) members.push_back(&found->second);
            }
            while (!members.empty()) {
                std::vector<const GrammarNumber*> near;
                std::ranges::copy_if(members, std::back_inserter(near),
                                     [&](const GrammarNumber* member) { return nearly_equal(*members.front(), *member); });
                std::erase_if(members,
                              [&](const GrammarNumber* member) { return std::ranges::find(near, member) != near.end(); });
                if (near.size() > 1) take_one_value(near);
            }
        }
    }

    void take_one_value(const std::vector<const GrammarNumber*>& near) {
        const auto digits = [](const GrammarNumber* number) { return number_text(std::abs(rounded(number->value))).size(); };
        const double value = std::abs((*std::ranges::min_element(near, {}, digits))->value);
        for (const GrammarNumber* number : near)
            if (std::abs(number->value) != value) set(number->name, std::copysign(value, number->value));
    }
};

}  // namespace

EditResult with_regular_steps(const Grammar& grammar, double tolerance) {
    const Nearness near = nearness(tolerance);
    EditResult closed = close_near_rings(grammar, near);
    EditResult straight = Straightener(closed.grammar, near).straighten();
    straight.changes.insert(straight.changes.begin(), closed.changes.begin(), closed.changes.end());
    return straight;
}

}  // namespace rinceau

#include "lsystem/keep_rings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/index.h"
#include "lsystem/noise_form.h"
#include "lsystem/number_slots.h"
#include "lsystem/number_text.h"
#include "lsystem/ring.h"

namespace rinceau {

namespace {

constexpr double full_circle = 360;
constexpr double fewest_elements = 2;
constexpr double most_elements = 1e6;

bool same_use(const LoopUse& a, const LoopUse& b) { return a.string == b.string && a.position == b.position; }

/// How often the name of a constant is written in the grammar.
int times_used(const Grammar& grammar, const std::string& name) {
    int count = 0;
    const auto look = [&](const Expression& expression) {
        for (const Expression::Node& node : expression.postfix)
            count += node.op == Expression::Op::name && node.name == name;
    };
    for (const Constant& constant : grammar.constants) look(constant.value);
    for (const StringPlace& place : strings_of(grammar))
        for (const ModuleTemplate& module : string_at(grammar, place))
            for (const Expression& argument : module.arguments) look(argument);
    for (const Production& production : grammar.productions) {
        if (production.condition) look(*production.condition);
        if (production.weight) look(*production.weight);
    }
    return count;
}

/// The rings of one production, before and now.
class RingKeeper {
  public:
    RingKeeper(const Grammar& before, Grammar& grammar, std::vector<std::string>& changes, std::vector<Ring> rings,
               const KeepRingsOptions& options = {})
        : before_(before), grammar_(grammar), changes_(changes), rings_(std::move(rings)), options_(options) {}

    void keep() {
        if (!look() || all_closed()) return;
        bool counts_differ = false;
        bool turns_differ = false;
        for (std::size_t i = 0; i < rings_.size(); ++i) {
            counts_differ = counts_differ || elements_of(loop_, uses_[i]) != rings_[i].elements;
            const auto turn = turn_of(grammar_, loop_, uses_[i]);
            turns_differ = turns_differ || !turn || *turn != rings_[i].turn;
        }
        if (counts_differ && turns_differ) return say_open("both its count and its turn were set");
        counts_differ ? follow_counts(rings_.front().turn) : follow_turn();
    }

    /// As after setting counts.
    void close() {
        if (look()) follow_counts(rings_.front().turn);
    }

  private:
    const Grammar& before_;
    Grammar& grammar_;
    std::vector<std::string>& changes_;
    std::vector<Ring> rings_;
    KeepRingsOptions options_;
    RuleLoop loop_;              ///< now
    std::vector<LoopUse> uses_;  ///< now, of the rings

    const std::string& symbol() const { return grammar_.productions[at(loop_.production)].symbol; }

    void say_open(const std::string& why) { changes_.push_back("the ring of " + symbol() + " is open now: " + why); }

    /// The loop and its uses as they are now; false if they are gone.
    bool look() {
        const std::vector<RuleLoop> loops = rule_loops(grammar_);
        const auto found = std::ranges::find(loops, rings_.front().loop.production, &RuleLoop::production);
        if (found == loops.end()) return false;
        loop_ = *found;
        uses_.clear();
        for (const Ring& ring : rings_)
            for (const LoopUse& use : uses_of(grammar_, loop_))
                if (same_use(use, ring.use) && use.count) uses_.push_back(use);
        return uses_.size() == rings_.size();
    }

    /// As often around as before.
    bool is_closed(std::size_t i) const {
        const auto turn = turn_of(grammar_, loop_, uses_[i]);
        const double elements = elements_of(loop_, uses_[i]);
        if (!turn || !closes(elements, *turn)) return false;
        return std::round(elements * std::abs(*turn) / full_circle) == rings_[i].full_turns;
    }
    bool all_closed() const {
        for (std::size_t i = 0; i < uses_.size(); ++i)
            if (!is_closed(i)) return false;
        return true;
    }

    std::string value_text(const std::string& name, const Grammar& grammar) const {
        for (const GrammarNumber& number : grammar_numbers(grammar))
            if (number.name == name) return short_text(number.value);
        return "";
    }
    void say_changed(const ExpressionPlace& place, const Grammar& was) {
        std::string name = name_of_place(grammar_numbers(grammar_), place);
        std::string change = "the turn of " + symbol();
        if (!name.empty()) change = name + ' ' + value_text(name, was) + " -> " + value_text(name, grammar_);
        change += " so that the ring is closed";
        const std::size_t others = uses_of(grammar_, loop_).size() - uses_.size();
        if (others > 0) change += "; " + std::to_string(others) + " other use(s) of " + symbol() + " turn with it";
        changes_.push_back(change);
    }

    // The counts were set.

    /// `side` has the sign of the turn.
    void follow_counts(double side) {
        const double elements = elements_of(loop_, uses_.front());
        const bool agree =
            std::ranges::all_of(uses_, [&](const LoopUse& use) { return elements_of(loop_, use) == elements; });
        if (!agree) return say_open("its uses have different counts, and one turn cannot close them all");
        if (elements < 2) return;
        const double around = rings_.front().full_turns;
        if (around > 1 && std::gcd(static_cast<long>(around), static_cast<long>(elements)) != 1)
            return say_open(number_text(elements) + " elements do not go " + number_text(around) + " times around");
        const double turn = std::copysign(full_circle * around / elements, side);
        const Grammar was = grammar_;
        if (!set_turn(turn)) return say_open("its turn is written in a way that cannot follow");
        look();
        if (all_closed()) return;
        grammar_ = was;
        say_open("its turn is written in a way that cannot follow");
    }

    /// 36, or 360/7.
    Expression closing_turn(double wanted, double elements) const {
        constexpr std::size_t longest = 7;
        if (number_text(rounded(wanted)).size() <= longest) return number_expression(rounded(wanted));
        const double around = rings_.front().full_turns;
        if (std::abs(wanted * elements - full_circle * around) > 1e-9) return number_expression(rounded(wanted));
        return {{{Expression::Op::number, full_circle * around, {}, 0},
                 {Expression::Op::number, elements, {}, 0},
                 {Expression::Op::divide, 0, {}, 0}}};
    }

    bool set_turn(double turn) {
        const auto now = turn_of(grammar_, loop_, uses_.front());
        const StringPlace string{StringPlace::In::production, loop_.production};
        const std::vector<int> way = way_to(string_at(grammar_, string), loop_.continuations.front().symbol);
        for (auto position = way.rbegin(); now && position != way.rend(); ++position) {
            const ModuleTemplate& module = string_at(grammar_, string)[at(*position)];
            const int sign = turn_sign(module);
            if (sign == 0) continue;
            const Expression base = without_noise(module.arguments.front());
            const ExpressionPlace place{ExpressionPlace::In::module,          0, string, *position, 0, 0,
                                        static_cast<int>(base.postfix.size())};
            if (set_turn_at(place, base, sign * (turn - *now))) return true;
        }
        return false;
    }

    /// `more` = what the written angle lacks.
    bool set_turn_at(const ExpressionPlace& place, const Expression& base, double more) {
        const Scope scope = constants_in(grammar_, constants_of(grammar_), place.string);
        const double elements = elements_of(loop_, uses_.front());
        if (const auto value = value_of(base, scope)) {
            write(place, closing_turn(*value + more, elements));
            return true;
        }
        // The angle, or the number of elements, comes as an argument.
        const Production production = grammar_.productions[at(loop_.production)];
        for (std::size_t i = 0; i < production.parameters.size(); ++i) {
            const bool used = std::ranges::any_of(base.postfix, [&](const Expression::Node& node) {
                return node.op == Expression::Op::name && node.name == production.parameters[i];
            });
            const bool bare = base == name_expression(production.parameters[i]);
            if (!used || static_cast<int>(i) == loop_.parameter) continue;
            if (set_arguments(static_cast<int>(i), bare ? std::optional(more) : std::nullopt)) return true;
        }
        return false;
    }

    /// Of the uses: to what it is and `more`, or from the old number of elements to the new one.
    bool set_arguments(int argument, std::optional<double> more) {
        const double elements = elements_of(loop_, uses_.front());
        for (std::size_t i = 0; i < uses_.size(); ++i) {
            const LoopUse use = uses_[i];
            const Expression written = string_at(grammar_, use.string)[at(use.position)].arguments[at(argument)];
            const auto value = value_of(written, constants_in(grammar_, constants_of(grammar_), use.string));
            if (!value || (!more && *value != rings_[i].elements)) return false;
            const ExpressionPlace place{ExpressionPlace::In::module,
                                        0,
                                        use.string,
                                        use.position,
                                        argument,
                                        0,
                                        static_cast<int>(written.postfix.size())};
            write(place, more ? closing_turn(*value + *more, elements) : number_expression(elements));
        }
        return true;
    }

    void write(ExpressionPlace place, const Expression& value) {
        const Grammar was = grammar_;
        const int constant = constant_behind(grammar_, part_at(grammar_, place));
        if (constant >= 0 && times_used(grammar_, grammar_.constants[at(constant)].name) == 1) {
            const auto size = grammar_.constants[at(constant)].value.postfix.size();
            place = {ExpressionPlace::In::constant, constant, {}, 0, 0, 0, static_cast<int>(size)};
        }
        grammar_ = with_part(std::move(grammar_), place, value);
        say_changed(place, was);
    }

    // The turn was set.

    void follow_turn() {
        const double side = turn_of(grammar_, loop_, uses_.front()).value_or(0);
        for (std::size_t i = 0; i < uses_.size(); ++i) {
            const auto turn = turn_of(grammar_, loop_, uses_[i]);
            if (!turn) return say_open("its turn is not the same from one element to the next");
            if (is_closed(i)) continue;
            const double elements = *turn == 0 ? 0 : full_circle * rings_[i].full_turns / std::abs(*turn);
            if (!options_.nearest_count || *turn == 0) expect_whole(elements, *turn);
            set_count(uses_[i], std::clamp(std::round(elements), fewest_elements, most_elements));
            look();
        }
        restore_turn();
        if (options_.nearest_count && !all_closed()) follow_counts(side);
    }

    void expect_whole(double elements, double turn) const {
        constexpr double rounding = 1e-6;
        if (elements >= fewest_elements && elements <= most_elements && std::abs(elements - std::round(elements)) < rounding)
            return;
        throw InputError(
            grammar_.productions[at(loop_.production)].place,
            "expected a turn of " + symbol() + " that a whole number of elements closes to a ring, such as " +
                number_text(full_circle / std::max(fewest_elements, std::round(std::min(elements, most_elements)))) +
                ", found " + number_text(rounded(turn)) + ": set its count, too, or let the ring open (--open)");
    }

    void set_count(const LoopUse& use, double elements) {
        const Grammar was = grammar_;
        const double count = elements - (loop_.has_drawn_end ? 1 : 0);
        ExpressionPlace place = use.written;
        const int constant = constant_behind(grammar_, part_at(grammar_, place));
        if (constant >= 0) {
            const auto size = grammar_.constants[at(constant)].value.postfix.size();
            place = {ExpressionPlace::In::constant, constant, {}, 0, 0, 0, static_cast<int>(size)};
        }
        const NumberSlot slot{NumberSlot::In::expression, place, 0, use.law.slope, use.law.offset};
        grammar_ = with_slot(std::move(grammar_), slot, number_expression(count));
        say_changed(place, was);
    }

    /// 360/count says the turn that was asked for once the count is right.
    void restore_turn() {
        Grammar restored = grammar_;
        const StringPlace string{StringPlace::In::production, loop_.production};
        string_at(restored, string) = string_at(before_, string);
        for (const LoopUse& use : uses_) {
            const auto wanted = turn_of(grammar_, loop_, use);
            const auto given = turn_of(restored, loop_, use);
            constexpr double rounding = 1e-9;
            if (!wanted || !given || std::abs(*wanted - *given) > rounding) return;
        }
        auto& now = string_at(grammar_, string);
        const auto& then = string_at(before_, string);
        for (const int position : way_to(then, loop_.continuations.front().symbol))
            if (turn_sign(then[at(position)]) != 0) now[at(position)] = then[at(position)];
    }
};

std::vector<std::vector<Ring>> by_production(std::vector<Ring> rings) {
    std::vector<std::vector<Ring>> groups;
    for (Ring& ring : rings) {
        const int production = ring.loop.production;
        const auto same = [&](const std::vector<Ring>& group) { return group.front().loop.production == production; };
        const auto group = std::ranges::find_if(groups, same);
        if (group == groups.end()) {
            groups.push_back({std::move(ring)});
        } else {
            group->push_back(std::move(ring));
        }
    }
    return groups;
}

}  // namespace

EditResult keep_rings_closed(const Grammar& before, const Grammar& after, const KeepRingsOptions& options) {
    EditResult result{after, {}};
    for (std::vector<Ring>& rings : by_production(closed_rings(before)))
        RingKeeper(before, result.grammar, result.changes, std::move(rings), options).keep();
    return result;
}

EditResult close_rings(const Grammar& grammar, std::vector<Ring> rings) {
    EditResult result{grammar, {}};
    for (std::vector<Ring>& of_one : by_production(std::move(rings)))
        RingKeeper(grammar, result.grammar, result.changes, std::move(of_one)).close();
    return result;
}

}  // namespace rinceau

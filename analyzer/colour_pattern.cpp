#include "analyzer/colour_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>

namespace rinceau {

namespace {

constexpr int longest_period = 8;
constexpr double largest_whole = 9007199254740992.0;  // 2^53: above, doubles skip numbers
constexpr std::size_t most_cases = 3;                 // of a table written as sums of comparisons: more cannot be read

double number_bits(Tint value) {
    const double magnitude = std::abs(static_cast<double>(value));
    return magnitude <= 12 ? 4 : 2 + std::log2(magnitude);
}

Tint modulo(Tint a, Tint n) { return ((a % n) + n) % n; }

/// The commonest value, the smallest of equally common ones; 0 of none.
Tint commonest(std::vector<Tint> values) {
    std::ranges::sort(values);
    Tint best = 0;
    std::size_t most = 0;
    for (std::size_t begin = 0; begin < values.size();) {
        std::size_t end = begin;
        while (end < values.size() && values[end] == values[begin]) ++end;
        if (end - begin > most) {
            most = end - begin;
            best = values[begin];
        }
        begin = end;
    }
    return best;
}

/// a*x + b
std::string linear_text(Tint a, const std::string& x, Tint b) {
    if (a == 0) return std::to_string(b);
    std::string product = std::abs(a) == 1 ? x : std::to_string(std::abs(a)) + "*" + x;
    if (a < 0) return b == 0 ? "-" + product : std::to_string(b) + " - " + product;
    if (b == 0) return product;
    return product + (b > 0 ? " + " : " - ") + std::to_string(std::abs(b));
}

/// base + factor * text, text a remainder.
std::string plus_text(Tint base, Tint factor, const std::string& text) {
    const std::string product = factor == 1 ? text : std::to_string(factor) + "*(" + text + ")";
    return base == 0 ? product : std::to_string(base) + " + " + product;
}

/// `table` by x: the commonest value, and what it changes by at the other x; nothing if that takes too many cases.
std::optional<std::string> cases_text(const std::map<Tint, Tint>& table, const std::string& x) {
    std::vector<Tint> values;
    for (const auto& [unused, value] : table) values.push_back(value);
    const Tint base = commonest(values);
    std::string text = std::to_string(base);
    std::size_t cases = 0;
    for (const auto& [at, value] : table) {
        if (value == base) continue;
        if (++cases > most_cases) return std::nullopt;
        const Tint change = value - base;
        text += change < 0 ? " - " : " + ";
        if (std::abs(change) != 1) text += std::to_string(std::abs(change)) + "*";
        text += "(" + x + " == " + std::to_string(at) + ")";
    }
    return text;
}

class PatternSearch {
  public:
    PatternSearch(const TintColumn& column, std::span<const TintParameter> known, const std::string& new_name,
                  double exception_bits)
        : column_(column), known_(known), new_name_(new_name), exception_bits_(exception_bits) {
        uses_of_owner_.resize(static_cast<std::size_t>(column.owners));
        for (std::size_t k = 0; k < column.uses.size(); ++k) {
            uses_of_owner_[static_cast<std::size_t>(column.uses[k].owner)].push_back(k);
            largest_m_ = std::max(largest_m_, column.uses[k].m);
        }
    }

    TintPattern run() {
        try_constant();
        try_known();
        try_own();
        if (!column_.counter.empty() && largest_m_ > 1 && best_.bits > simplest_bits) {
            try_linear();
            try_linear_with_jump();
            for (int period = 2; period <= std::min(longest_period, largest_m_ - 1); ++period) try_period(period);
            try_special_repetitions();
            for (const int end : {1, largest_m_}) try_all_but(end);
            try_stretch();
            try_digits();
        }
        return std::move(best_);
    }

  private:
    static constexpr double simplest_bits = 4;  // one small number

    using Predict = std::function<Tint(const TintUse&)>;

    /// Exceptions and holes leave the choice of a style where it is: it must be one everywhere.
    bool chooses_styles(const Predict& predict) const {
        if (column_.styles == 0) return true;
        const auto is_style = [&](int owner, int m) {
            const Tint tint = predict({owner, m, 0});
            return tint >= 1 && tint <= column_.styles;
        };
        for (int owner = 0; owner < column_.owners; ++owner) {
            if (column_.counter.empty() && !is_style(owner, 0)) return false;
            for (int m = column_.counter.empty() ? 0 : column_.counts[static_cast<std::size_t>(owner)]; m > 0; --m) {
                if (!is_style(owner, m)) return false;
            }
        }
        return true;
    }

    void offer(const std::string& text, const Predict& predict, std::vector<Tint> parameter = {}) {
        TintPattern pattern;
        pattern.expression = parse_expression(text);
        pattern.bits = tint_bits(pattern.expression) + parameter_bits(parameter);
        for (std::size_t k = 0; k < column_.uses.size(); ++k) {
            const Tint missing = column_.uses[k].tint - predict(column_.uses[k]);
            if (missing == 0) continue;
            pattern.departures.push_back(static_cast<int>(k));
            pattern.missing.push_back(missing);
            pattern.bits += exception_bits_;
            if (found_ && pattern.bits >= best_.bits) return;
        }
        if (found_ && (pattern.bits >= best_.bits || !chooses_styles(predict))) return;
        found_ = true;
        pattern.parameter = std::move(parameter);
        best_ = std::move(pattern);
    }

    /// Each owner's value is chosen by frequency and spelled out once.
    static double parameter_bits(const std::vector<Tint>& values) {
        if (values.empty()) return 0;
        constexpr double declared = 6;
        std::map<Tint, double> counts;
        for (const Tint value : values) ++counts[value];
        double bits = declared;
        const auto total = static_cast<double>(values.size());
        for (const auto& [value, count] : counts) bits += count * std::log2(total / count) + number_bits(value);
        return bits;
    }

    /// By owner: the commonest of f over its uses; over all uses for an owner without any.
    template <class F>
    std::vector<Tint> by_owner(F f) const {
        std::vector<Tint> result, all;
        for (const TintUse& use : column_.uses) all.push_back(f(use));
        const Tint otherwise = commonest(all);
        for (const std::vector<std::size_t>& uses : uses_of_owner_) {
            std::vector<Tint> own;
            for (const std::size_t k : uses) own.push_back(all[k]);
            result.push_back(own.empty() ? otherwise : commonest(std::move(own)));
        }
        return result;
    }

    template <class F>
    Tint over_all(F f) const {
        std::vector<Tint> all;
        for (const TintUse& use : column_.uses) all.push_back(f(use));
        return commonest(std::move(all));
    }

    static Tint of(const std::vector<Tint>& values, const TintUse& use) { return values[static_cast<std::size_t>(use.owner)]; }
    bool several_owners() const { return column_.owners > 1 && !new_name_.empty(); }

    template <class At>
    void offer_cases(const std::map<Tint, Tint>& table, const std::string& x, const At& at) {
        const auto text = cases_text(table, x);
        if (!text) return;
        std::vector<Tint> values;
        for (const auto& [unused, value] : table) values.push_back(value);
        const Tint base = commonest(std::move(values));
        offer(*text, [&](const TintUse& use) {
            const auto found = table.find(at(use));
            return found == table.end() ? base : found->second;
        });
    }

    void try_constant() {
        const Tint value = over_all([](const TintUse& use) { return use.tint; });
        offer(std::to_string(value), [=](const TintUse&) { return value; });
    }

    void try_own() {
        if (!several_owners()) return;
        const std::vector<Tint> own = by_owner([](const TintUse& use) { return use.tint; });
        offer(new_name_, [&](const TintUse& use) { return of(own, use); }, own);
    }

    void try_known() {
        for (const TintParameter& parameter : known_) {
            const auto at = [&](const TintUse& use) { return of(parameter.values, use); };
            const Tint shift = over_all([&](const TintUse& use) { return use.tint - at(use); });
            offer(linear_text(1, parameter.name, shift), [&](const TintUse& use) { return at(use) + shift; });
            std::map<Tint, std::vector<Tint>> found;
            for (const TintUse& use : column_.uses) found[at(use)].push_back(use.tint);
            if (found.size() > 2 * most_cases) continue;
            std::map<Tint, Tint> table;
            for (auto& [value, tints] : found) table[value] = commonest(std::move(tints));
            offer_cases(table, parameter.name, at);
        }
    }

    /// What the tint grows by when m grows by one.
    Tint commonest_slope() const {
        std::vector<Tint> slopes;
        for (const std::vector<std::size_t>& uses : uses_of_owner_) {
            for (std::size_t k = 1; k < uses.size(); ++k) {
                const TintUse& a = column_.uses[uses[k - 1]];
                const TintUse& b = column_.uses[uses[k]];
                if (a.m - b.m == 1) slopes.push_back(a.tint - b.tint);
            }
        }
        return commonest(std::move(slopes));
    }

    void try_linear() {
        const Tint slope = commonest_slope();
        if (slope == 0) return;
        const auto rest = [=](const TintUse& use) { return use.tint - slope * use.m; };
        const Tint start = over_all(rest);
        offer(linear_text(slope, column_.counter, start), [=](const TintUse& use) { return slope * use.m + start; });
        const std::string along = linear_text(std::abs(slope), column_.counter, 0);
        const auto starting = [&](const std::string& from) { return from + (slope < 0 ? " - " : " + ") + along; };
        for (const TintParameter& parameter : known_) {
            const auto at = [&](const TintUse& use) { return of(parameter.values, use); };
            const Tint shift = over_all([&](const TintUse& use) { return rest(use) - at(use); });
            offer(starting(linear_text(1, parameter.name, shift)),
                  [&](const TintUse& use) { return at(use) + shift + slope * use.m; });
        }
        if (!several_owners()) return;
        const std::vector<Tint> own = by_owner(rest);
        offer(starting(new_name_), [&](const TintUse& use) { return of(own, use) + slope * use.m; }, own);
    }

    /// Counting on behind a gap: slope*m + start, and from some m on a step more or less.
    void try_linear_with_jump() {
        const Tint slope = commonest_slope();
        if (slope == 0) return;
        std::map<Tint, std::vector<Tint>> found;
        for (const TintUse& use : column_.uses) found[use.m].push_back(use.tint - slope * use.m);
        std::vector<std::pair<Tint, Tint>> rests;  // (m, rest)
        for (auto& [m, rest] : found) rests.emplace_back(m, commonest(std::move(rest)));
        const Tint before = rests.front().second, behind = rests.back().second;
        const auto jump = std::ranges::find_if(rests, [&](const auto& rest) { return rest.second != before; });
        if (std::ranges::any_of(jump, rests.end(), [&](const auto& rest) { return rest.second != behind; })) return;
        if (jump == rests.end() || jump == rests.begin()) return;
        const Tint last = std::prev(jump)->first, step = behind - before;
        const std::string text = linear_text(slope, column_.counter, before) + (step < 0 ? " - " : " + ") +
                                 (std::abs(step) == 1 ? "" : std::to_string(std::abs(step)) + "*") + "(" + column_.counter +
                                 " > " + std::to_string(last) + ")";
        offer(text, [&](const TintUse& use) { return slope * use.m + before + (use.m > last ? step : 0); });
    }

    /// Commonest tint by phase(use) modulo the period; nothing if a phase does not occur.
    template <class F>
    std::optional<std::vector<Tint>> cycle(int period, F phase) const {
        std::vector<std::vector<Tint>> found(static_cast<std::size_t>(period));
        for (const TintUse& use : column_.uses) found[static_cast<std::size_t>(modulo(phase(use), period))].push_back(use.tint);
        std::vector<Tint> table;
        for (std::vector<Tint>& tints : found) {
            if (tints.empty()) return std::nullopt;
            table.push_back(commonest(std::move(tints)));
        }
        return table;
    }

    /// A cycle as base + factor * ((sign * x + shift) % period), if it is one.
    struct Run {
        Tint base = 0, factor = 1;
        int sign = 1;
        Tint shift = 0;
    };
    static std::optional<Run> run_of(const std::vector<Tint>& table) {
        const auto period = static_cast<Tint>(table.size());
        const Tint base = std::ranges::min(table), top = std::ranges::max(table);
        if (base == top || (top - base) % (period - 1) != 0) return std::nullopt;
        const Tint factor = (top - base) / (period - 1);
        for (const int sign : {1, -1}) {
            for (Tint shift = 0; shift < period; ++shift) {
                bool fits = true;
                for (Tint x = 0; x < period && fits; ++x)
                    fits = table[static_cast<std::size_t>(x)] == base + factor * modulo(sign * x + shift, period);
                if (fits) return Run{base, factor, sign, shift};
            }
        }
        return std::nullopt;
    }

    /// table[x % period], x given as text.
    static std::optional<std::string> cycle_text(const std::vector<Tint>& table, const std::string& x, bool sum) {
        const std::string period = std::to_string(table.size());
        if (const auto run = run_of(table)) {
            const std::string in_brackets = sum && run->sign < 0 ? "(" + x + ")" : x;
            const std::string inside = linear_text(run->sign, in_brackets, run->shift);
            const bool plain = inside == x && !sum;
            return plus_text(run->base, run->factor, (plain ? inside : "(" + inside + ")") + " % " + period);
        }
        std::map<Tint, Tint> cases;
        for (std::size_t k = 0; k < table.size(); ++k) cases[static_cast<Tint>(k)] = table[k];
        return cases_text(cases, (sum ? "(" + x + ")" : x) + " % " + period);
    }

    void try_period(int period) {
        const std::string& m = column_.counter;
        const auto offer_cycle = [&](const std::vector<Tint>& table, const std::string& x, bool sum, const auto& phase,
                                     const std::vector<Tint>& parameter) {
            if (const auto text = cycle_text(table, x, sum)) {
                offer(*text, [&](const TintUse& use) { return table[static_cast<std::size_t>(modulo(phase(use), period))]; },
                      parameter);
            }
        };
        const auto plain = [](const TintUse& use) -> Tint { return use.m; };
        const auto table = cycle(period, plain);
        if (table) offer_cycle(*table, m, false, plain, {});
        for (const TintParameter& parameter : known_) {
            const auto phase = [&](const TintUse& use) { return use.m + of(parameter.values, use); };
            if (const auto found = cycle(period, phase)) offer_cycle(*found, m + " + " + parameter.name, true, phase, {});
        }
        if (several_owners()) try_shifted_period(period, offer_cycle);
    }

    /// All owners have the cycle of the first one, each in a phase of its own.
    template <class Offer>
    void try_shifted_period(int period, const Offer& offer_cycle) {
        std::vector<std::vector<Tint>> found(static_cast<std::size_t>(period));
        for (const std::size_t k : uses_of_owner_.front())
            found[static_cast<std::size_t>(column_.uses[k].m % period)].push_back(column_.uses[k].tint);
        std::vector<Tint> table;
        for (std::vector<Tint>& tints : found) {
            if (tints.empty()) return;
            table.push_back(commonest(std::move(tints)));
        }
        std::vector<Tint> shifts;
        for (const std::vector<std::size_t>& uses : uses_of_owner_) {
            Tint best = 0;
            long most = -1;
            for (Tint shift = 0; shift < period; ++shift) {
                const long hits = std::ranges::count_if(uses, [&](std::size_t k) {
                    const TintUse& use = column_.uses[k];
                    return table[static_cast<std::size_t>((use.m + shift) % period)] == use.tint;
                });
                if (hits > most) {
                    most = hits;
                    best = shift;
                }
            }
            shifts.push_back(best);
        }
        const auto phase = [&](const TintUse& use) { return use.m + of(shifts, use); };
        offer_cycle(table, column_.counter + " + " + new_name_, true, phase, shifts);
    }

    /// The same tint but for one to three repetitions that stand out in all copies.
    void try_special_repetitions() {
        std::map<Tint, std::vector<Tint>> found;
        for (const TintUse& use : column_.uses) found[use.m].push_back(use.tint);
        std::map<Tint, Tint> table;
        for (auto& [m, tints] : found) table[m] = commonest(std::move(tints));
        offer_cases(table, column_.counter, [](const TintUse& use) -> Tint { return use.m; });
    }

    /// The first or the last repetition is alike in all copies, the others are each copy's own.
    void try_all_but(int end) {
        std::vector<Tint> at_end, own(uses_of_owner_.size(), 0);
        for (std::size_t owner = 0; owner < own.size(); ++owner) {
            std::vector<Tint> others;
            for (const std::size_t k : uses_of_owner_[owner]) {
                const TintUse& use = column_.uses[k];
                (use.m == end ? at_end : others).push_back(use.tint);
            }
            if (others.empty()) return;
            own[owner] = commonest(std::move(others));
        }
        if (at_end.empty()) return;
        const Tint there = commonest(std::move(at_end));
        const auto text = [&](const std::string& otherwise) {
            return "if(" + column_.counter + " == " + std::to_string(end) + ", " + std::to_string(there) + ", " + otherwise +
                   ")";
        };
        for (const TintParameter& parameter : known_) {
            const auto at = [&](const TintUse& use) { return of(parameter.values, use); };
            const Tint shift = over_all([&](const TintUse& use) { return use.m == end ? Tint{0} : use.tint - at(use); });
            offer(text(linear_text(1, parameter.name, shift)),
                  [&](const TintUse& use) { return use.m == end ? there : at(use) + shift; });
        }
        if (several_owners())
            offer(
                text(new_name_), [&](const TintUse& use) { return use.m == end ? there : of(own, use); }, own);
    }

    /// One tint up to some repetition, another one from there on, or up to a second one.
    void try_stretch() {
        std::map<Tint, std::vector<Tint>> found;
        for (const TintUse& use : column_.uses) found[use.m].push_back(use.tint);
        std::vector<std::pair<Tint, Tint>> changes;  // (last repetition before it, tint from there on)
        Tint first = 0, before = 0;
        for (auto& [m, tints] : found) {
            const Tint tint = commonest(std::move(tints));
            if (m == found.begin()->first) {
                first = tint;
            } else if (tint != before) {
                changes.emplace_back(m - 1, tint);
            }
            before = tint;
        }
        constexpr std::size_t there_and_back = 2;
        if (changes.empty() || changes.size() > there_and_back) return;
        if (changes.size() == there_and_back && changes.back().second != first) return;
        const std::string& m = column_.counter;
        const Tint begin = changes.front().first, end = changes.size() > 1 ? changes.back().first : largest_m_;
        const Tint step = changes.front().second - first;
        const std::string within = changes.size() > 1 ? " && " + m + " <= " + std::to_string(end) : "";
        const auto drawn = [&](const TintUse& use) { return use.m > begin && use.m <= end ? first + step : first; };
        offer(plus_text(first, step, "(" + m + " > " + std::to_string(begin) + within + ")"), drawn);
    }

    /// Without any order: the tints as digits of a number.
    void try_digits() {
        std::vector<Tint> values;
        for (const TintUse& use : column_.uses) values.push_back(use.tint);
        std::ranges::sort(values);
        values.erase(std::unique(values.begin(), values.end()), values.end());
        const auto base = static_cast<Tint>(values.size());
        if (base < 2 || largest_m_ * std::log2(static_cast<double>(base)) > std::log2(largest_whole)) return;
        const Tint least = values[0], factor = values[1] - values[0];
        for (std::size_t k = 1; k < values.size(); ++k) {
            if (values[k] - values[k - 1] != factor) return;
        }
        std::vector<Tint> powers{1};
        for (int k = 1; k < largest_m_; ++k) powers.push_back(powers.back() * base);
        std::vector<Tint> words(uses_of_owner_.size(), 0);
        for (const TintUse& use : column_.uses) {
            if (use.m < 1) return;
            words[static_cast<std::size_t>(use.owner)] +=
                (use.tint - least) / factor * powers[static_cast<std::size_t>(use.m - 1)];
        }
        const bool one = std::ranges::all_of(words, [&](Tint word) { return word == words.front(); });
        if (!one && new_name_.empty()) return;
        const std::string word = one ? std::to_string(words.front()) : new_name_;
        const std::string radix = std::to_string(base);
        const std::string digit = "floor(" + word + " / " + radix + "^(" + column_.counter + " - 1)) % " + radix;
        const std::vector<Tint> parameter = one ? std::vector<Tint>{} : words;
        const auto drawn = [&](const TintUse& use) {
            return least + factor * (of(words, use) / powers[static_cast<std::size_t>(use.m - 1)] % base);
        };
        offer(plus_text(least, factor, digit), drawn, one ? std::vector<Tint>{} : words);
    }

    const TintColumn& column_;
    std::span<const TintParameter> known_;
    const std::string& new_name_;
    double exception_bits_;
    std::vector<std::vector<std::size_t>> uses_of_owner_;
    int largest_m_ = 0;
    bool found_ = false;
    TintPattern best_;
};

}  // namespace

double tint_bits(const Expression& expression) {
    constexpr double other = 2;  // names and operators
    double bits = 0;
    for (const Expression::Node& node : expression.postfix) {
        bits += node.op == Expression::Op::number ? number_bits(static_cast<Tint>(node.number)) : other;
    }
    return bits;
}

TintPattern shortest_pattern(const TintColumn& column, std::span<const TintParameter> known, const std::string& new_name,
                             double exception_bits) {
    return PatternSearch(column, known, new_name, exception_bits).run();
}

}  // namespace rinceau

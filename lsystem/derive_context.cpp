// L-systems with contexts (Prusinkiewicz, Lindenmayer 1990, section 1.8), with parameters as in section 1.10.

#include "lsystem/derive_context.h"

#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "lsystem/choose_production.h"

namespace rinceau {

namespace {

constexpr auto opening = static_cast<Symbol>(TurtleCommand::push);
constexpr auto closing = static_cast<Symbol>(TurtleCommand::pop);
constexpr std::size_t nothing = static_cast<std::size_t>(-1);

/// A symbol or a bracket of the string. Other commands do not matter to contexts.
struct Standing {
    Symbol symbol = 0;
    int arguments = 0;
    std::size_t first_argument = 0;  ///< among the string's
    std::size_t decision = 0;        ///< its index
    DrawKey key = 0;
    int since = 0;  ///< the step that made it
};

struct String {
    std::vector<Standing> symbols;
    std::vector<double> arguments;
};

/// For every symbol of a string the next one that a context sees, or `nothing`.
struct Neighbours {
    std::vector<std::size_t> left;   ///< towards the root, past closed branches
    std::vector<std::size_t> right;  ///< towards the end of its own branch, past branches
};

std::size_t symbol_count(const CompiledString& string) {
    for (std::size_t i = string.size(); i-- > 0;) {
        if (string[i].number > 0) return static_cast<std::size_t>(string[i].number);
    }
    return 0;
}

class ContextDerivation {
  public:
    ContextDerivation(const CompiledGrammar& grammar, DerivationLimits& limits)
        : grammar_(grammar), limits_(limits), choice_(grammar), stack_(static_cast<std::size_t>(grammar.stack_size)) {}

    ContextDecisions derive(const Progress& progress) {
        append(grammar_.axiom, {}, grammar_.root, 0);
        std::swap(string_, next_);
        for (int step = 0; step < limits_.depth(); ++step)
            if (!rewrite(step, progress)) break;
        return std::move(decisions_);
    }

  private:
    /// A successor on its way into the next string.
    struct Frame {
        const CompiledModule* next;
        const CompiledModule* end;
        std::size_t parameters;  ///< where they begin in parameters_
        std::size_t decision;    ///< of its first symbol
        DrawKey key;
        int between;  ///< decompositions around it
    };

    const CompiledGrammar& grammar_;
    DerivationLimits& limits_;
    ProductionChoice choice_;
    std::vector<double> stack_;
    ContextDecisions decisions_;
    String string_;
    String next_;
    Neighbours neighbours_;
    std::vector<double> fitting_;     ///< parameters of the symbol in work and of its context
    std::vector<std::size_t> found_;  ///< of a left context, the nearest first
    std::vector<Frame> frames_;
    std::vector<double> parameters_;  ///< of the open frames
    std::vector<double> arguments_;

    /// Between steps and, of long strings, within them.
    void look_up(int step, const Progress& progress) const {
        limits_.check_time();
        const bool known = limits_.depth() != std::numeric_limits<int>::max();
        report(progress, "derive", known ? static_cast<double>(step) / limits_.depth() : 0);
    }

    std::size_t reserve_decisions(const CompiledString& string) {
        const std::size_t first = decisions_.symbols.size();
        decisions_.symbols.resize(first + symbol_count(string));
        return first;
    }

    void open(const CompiledString& string, std::span<const double> parameters, DrawKey key, std::size_t decision,
              int between) {
        frames_.push_back({string.data(), string.data() + string.size(), parameters_.size(), decision, key, between});
        parameters_.insert(parameters_.end(), parameters.begin(), parameters.end());
    }

    /// Appends a string to the next one, all decompositions applied.
    void append(const CompiledString& string, std::span<const double> parameters, DrawKey key, int step) {
        open(string, parameters, key, reserve_decisions(string), 0);
        while (!frames_.empty()) {
            Frame& frame = frames_.back();
            if (frame.next == frame.end) {
                parameters_.resize(frame.parameters);
                frames_.pop_back();
                continue;
            }
            const CompiledModule& module = *frame.next++;
            if (module.symbol >= command_count) {
                append_symbol(frame, module, step);
            } else if (module.symbol == opening || module.symbol == closing) {
                next_.symbols.push_back({module.symbol});
            }
        }
    }

    void append_symbol(const Frame& frame, const CompiledModule& module, int step) {
        evaluate_arguments(frame, module);
        const DrawKey key = key_below(frame.key, static_cast<std::uint64_t>(module.number));
        const std::size_t decision = frame.decision + static_cast<std::size_t>(module.number) - 1;
        const auto& decompositions = grammar_.productions_of[static_cast<std::size_t>(module.symbol)].decomposition;
        const int production = choice_.choose_by_count(decompositions, arguments_, key);
        if (production < 0) {
            next_.symbols.push_back({module.symbol, module.argument_count, next_.arguments.size(), decision, key, step});
            next_.arguments.insert(next_.arguments.end(), arguments_.begin(), arguments_.end());
            return;
        }
        const int between = frame.between + 1;
        limits_.count_application(production, step, between, frames_.size());
        const CompiledString& successor = grammar_.productions[static_cast<std::size_t>(production)].successor;
        const std::size_t first = reserve_decisions(successor);
        decisions_.symbols[decision] = {production, step, first, decisions_.values.size()};
        open(successor, arguments_, key, first, between);
    }

    void evaluate_arguments(const Frame& frame, const CompiledModule& module) {
        const double* constants = grammar_.values.data() + module.first_value;
        if (module.constant) return arguments_.assign(constants, constants + module.argument_count);
        arguments_.clear();
        for (const Program& argument : module.arguments) {
            const double value = evaluate(argument, parameters_.data() + frame.parameters, stack_.data(), frame.key);
            if (!std::isfinite(value)) throw_not_finite(module);
            arguments_.push_back(value);
        }
    }

    /// One step; false if no production applied.
    bool rewrite(int step, const Progress& progress) {
        constexpr std::size_t symbols_at_once = 1u << 14U;
        find_neighbours();
        next_.symbols.clear();
        next_.arguments.clear();
        bool rewritten = false;
        for (std::size_t i = 0; i < string_.symbols.size(); ++i) {
            if (i % symbols_at_once == 0) look_up(step, progress);
            const Standing& standing = string_.symbols[i];
            if (standing.symbol < command_count) {
                next_.symbols.push_back(standing);
                continue;
            }
            limits_.count_module();
            const DrawKey key = key_after(standing.key, step - standing.since);
            const auto values_of = [&](const CompiledProduction& production) { return fitting_values(production, i); };
            const auto& productions = grammar_.productions_of[static_cast<std::size_t>(standing.symbol)].rewriting;
            const int production = choice_.choose(productions, values_of, key);
            if (production < 0) {
                keep(standing);
            } else {
                replace(i, production, key, step);
                rewritten = true;
            }
        }
        std::swap(string_, next_);
        return rewritten;
    }

    void keep(const Standing& standing) {
        const auto first = string_.arguments.begin() + static_cast<std::ptrdiff_t>(standing.first_argument);
        next_.symbols.push_back(standing);
        next_.symbols.back().first_argument = next_.arguments.size();
        next_.arguments.insert(next_.arguments.end(), first, first + standing.arguments);
    }

    void replace(std::size_t at, int production, DrawKey key, int step) {
        limits_.count_application(production, step + 1, 0, 0);
        const CompiledProduction& applied = grammar_.productions[static_cast<std::size_t>(production)];
        fitting_values(applied, at);  // with weights another one was looked at last
        const std::size_t decision = string_.symbols[at].decision;
        decisions_.symbols[decision] = {production, step, decisions_.symbols.size(), decisions_.values.size()};
        decisions_.values.insert(decisions_.values.end(), fitting_.begin() + applied.parameters, fitting_.end());
        append(applied.successor, fitting_, key, step + 1);
    }

    void find_neighbours() {
        const std::size_t count = string_.symbols.size();
        neighbours_.left.assign(count, nothing);
        neighbours_.right.assign(count, nothing);
        std::vector<std::size_t> outside;
        std::size_t seen = nothing;
        for (std::size_t i = 0; i < count; ++i) {
            const Symbol symbol = string_.symbols[i].symbol;
            if (symbol == opening) {
                outside.push_back(seen);
            } else if (symbol == closing) {
                seen = leave(outside);
            } else {
                neighbours_.left[i] = seen;
                if (is_seen(symbol)) seen = i;
            }
        }
        outside.clear();
        seen = nothing;
        for (std::size_t i = count; i-- > 0;) {
            const Symbol symbol = string_.symbols[i].symbol;
            if (symbol == closing) {
                outside.push_back(seen);
                seen = nothing;
            } else if (symbol == opening) {
                seen = leave(outside);
            } else {
                neighbours_.right[i] = seen;
                if (is_seen(symbol)) seen = i;
            }
        }
    }

    /// The turtle refuses a bracket without its partner; here it bounds nothing.
    static std::size_t leave(std::vector<std::size_t>& outside) {
        if (outside.empty()) return nothing;
        const std::size_t seen = outside.back();
        outside.pop_back();
        return seen;
    }

    bool is_seen(Symbol symbol) const { return !grammar_.ignored[static_cast<std::size_t>(symbol)]; }

    /// The values of the production's parameters and of those of its context, if all of them stand there: in fitting_.
    std::optional<const double*> fitting_values(const CompiledProduction& production, std::size_t at) {
        fitting_.clear();
        if (!take({string_.symbols[at].symbol, production.parameters}, at)) return std::nullopt;
        const bool fits = take_left(production.left_context, at) && take_right(production.right_context, at);
        return fits ? std::optional<const double*>(fitting_.data()) : std::nullopt;
    }

    bool take(const CompiledContext& wanted, std::size_t at) {
        const Standing& standing = string_.symbols[at];
        if (standing.symbol != wanted.symbol || standing.arguments != wanted.parameters) return false;
        const auto first = string_.arguments.begin() + static_cast<std::ptrdiff_t>(standing.first_argument);
        fitting_.insert(fitting_.end(), first, first + standing.arguments);
        return true;
    }

    /// The nearest one is the last of the context, the values are wanted from the first on.
    bool take_left(const std::vector<CompiledContext>& context, std::size_t at) {
        found_.clear();
        for (std::size_t k = context.size(); k-- > 0;) {
            at = neighbours_.left[at];
            if (at == nothing || string_.symbols[at].symbol != context[k].symbol) return false;
            found_.push_back(at);
        }
        for (std::size_t k = 0; k < context.size(); ++k) {
            if (!take(context[k], found_[context.size() - 1 - k])) return false;
        }
        return true;
    }

    bool take_right(const std::vector<CompiledContext>& context, std::size_t at) {
        for (const CompiledContext& wanted : context) {
            at = neighbours_.right[at];
            if (at == nothing || !take(wanted, at)) return false;
        }
        return true;
    }
};

}  // namespace

ContextDecisions decide_by_context(const CompiledGrammar& grammar, DerivationLimits& limits, const Progress& progress) {
    return ContextDerivation(grammar, limits).derive(progress);
}

}  // namespace rinceau

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "lsystem/check_strings.h"
#include "lsystem/compile.h"
#include "lsystem/grammar_text.h"
#include "lsystem/parse_text.h"
#include "lsystem/stream.h"

namespace rinceau {

namespace {

constexpr double seconds_for_trials = 1;  // a check answers while one waits

/// Stops trial derivations that take too long; what they have found until then counts.
struct TrialOver {};

Progress stop_after(double seconds) {
    const auto start = std::chrono::steady_clock::now();
    return [start, seconds](std::string_view, double) {
        if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > seconds) throw TrialOver{};
    };
}

/// Remembers which exceptions were met.
struct ExceptionWatch {
    std::vector<bool> met;

    void command(const CompiledModule&, std::span<const double>) {}
    void leaf(const CompiledModule&, std::span<const double>, const StreamPlace&) {}
    void exception(int index) { met[static_cast<std::size_t>(index)] = true; }
};

/// What its condition, weight and successor may use.
std::vector<std::string> names_in(const Production& production) {
    std::vector<std::string> names = production.parameters;
    for (const auto* context : {&production.left_context, &production.right_context}) {
        for (const ContextModule& module : *context)
            names.insert(names.end(), module.parameters.begin(), module.parameters.end());
    }
    return names;
}

class GrammarChecker {
  public:
    GrammarChecker(std::string_view text, const std::string& file_name) : file_name_(file_name) {
        state_ = parse_text(text, file_name);
        warnings_ = state_.mistakes;
    }

    std::vector<Warning> check() {
        names_.emplace(grammar());
        check_constants();
        check_axiom();
        for (const Production& production : grammar().productions) check_production(production);
        for (const Exception& exception : grammar().exceptions) check_exception(exception);
        check_terminals();
        if (warnings_.empty()) try_derivation();
        std::ranges::stable_sort(warnings_, [](const Warning& a, const Warning& b) {
            return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
        });
        return std::move(warnings_);
    }

  private:
    std::string file_name_;
    ParseState state_;
    Scope scope_;  // the constants, and the parameters of the production that is being checked
    std::optional<KnownNames> names_;
    /// Of the productions so far, by symbol and number of parameters: the line of the one without a condition.
    std::map<std::pair<std::string_view, std::size_t>, std::optional<int>> unconditional_;
    std::map<std::vector<int>, int> exception_lines_;  // by address
    std::vector<Warning> warnings_;

    const Grammar& grammar() const { return state_.grammar; }
    void warn(const SourcePlace& place, const std::string& message) { warnings_.push_back({place, message}); }

    void check_constants() {
        for (const Constant& constant : grammar().constants) {
            double value = 1;  // stands for a faulty one, so that its users are not reported too
            try {
                value = compile_expression(constant.value, scope_, constant.place).code.front().number;
            } catch (const InputError& error) {
                warnings_.push_back(warning_of(error));
            }
            if (!std::isfinite(value)) warn(constant.place, "expected a finite value of the constant " + constant.name);
            scope_.constants.try_emplace(constant.name, value);
        }
    }

    void check_string_here(const std::vector<ModuleTemplate>& string) {
        const std::vector<Warning> found = check_string(*names_, string, scope_);
        warnings_.insert(warnings_.end(), found.begin(), found.end());
    }

    void check_axiom() {
        if (!state_.lines.contains("axiom")) {
            warn({file_name_, 1, 1}, "expected an axiom, such as 'axiom: A', found none: nothing would be drawn");
        }
        check_string_here(grammar().axiom);
    }

    void check_production(const Production& production) {
        scope_.parameters = names_in(production);
        check_string_here(production.successor);
        bool always = !production.condition;
        if (production.condition) {
            try {
                const Program condition = compile_expression(*production.condition, scope_, production.place);
                const bool fixed = is_constant(condition);
                always = fixed && condition.code.front().number != 0;
                if (fixed && !always)
                    warn(production.place, "expected a condition that can hold, found one that never does");
            } catch (const InputError& error) {
                warnings_.push_back(warning_of(error));
            }
        }
        scope_.parameters.clear();
        check_turn(production, always);
    }

    /// Productions of one symbol are tried in order.
    void check_turn(const Production& production, bool always) {
        const auto [found, is_first] = unconditional_.try_emplace({production.symbol, production.parameters.size()});
        std::optional<int>& unconditional = found->second;
        if (unconditional) {
            warn(production.place, "expected a production that can apply, found one that never does: the one in line " +
                                       std::to_string(*unconditional) + " always comes first; give that one a condition");
            return;
        }
        if (!production.condition) unconditional = production.place.line;
        const bool recursive = std::ranges::any_of(production.successor, [&](const ModuleTemplate& module) {
            return module.symbol == production.symbol && module.arguments.size() == production.parameters.size();
        });
        if (always && is_first && recursive) {
            warn(production.place,
                 "expected a production that ends, found " + production.symbol +
                     " in its own successor without a condition: add one, such as ': m > 0', or derive to a depth");
        }
    }

    void check_exception(const Exception& exception) {
        check_string_here(exception.successor);
        const auto [first, is_first] = exception_lines_.try_emplace(exception.address, exception.place.line);
        if (!is_first) {
            warn(exception.place, "expected one exception at an address, found another: the first is in line " +
                                      std::to_string(first->second));
        }
    }

    void check_terminals() {
        for (const Terminal& terminal : grammar().terminals) {
            if (!terminal.verbatim.empty() || names_->styles.contains(terminal.style)) continue;
            warn(terminal.place, "expected the number of a style of the grammar, found " + std::to_string(terminal.style) +
                                     ": add 'style " + std::to_string(terminal.style) + ": ..'");
        }
    }

    /// What only shows when the grammar is derived.
    void try_derivation() {
        try {
            const CompiledGrammar compiled = compile(grammar());
            const Progress deadline = stop_after(seconds_for_trials);
            ExceptionWatch watch{std::vector<bool>(grammar().exceptions.size())};
            stream_modules(compiled, {}, deadline, false, watch);
            report_unused_exceptions(watch.met);
            visit_placements(
                grammar(), {}, [](const Placement&) {}, deadline);
        } catch (const InputError& error) {
            warnings_.push_back(warning_of(error));
        } catch (const LimitError& error) {
            std::string message = error.what();
            message.erase(0, located(error.place(), "").size());
            warn(error.place(), message);
        } catch (const TrialOver&) {
            // too large to be tried out; what could be seen without is reported
        }
    }

    void report_unused_exceptions(const std::vector<bool>& met) {
        for (std::size_t i = 0; i < grammar().exceptions.size(); ++i) {
            if (met[i]) continue;
            warn(grammar().exceptions[i].place,
                 "expected the address of a module, found one where none stands: "
                 "count it again, or take the exception away");
        }
    }
};

}  // namespace

std::vector<Warning> check_grammar(std::string_view text, const std::string& file_name) {
    return GrammarChecker(text, file_name).check();
}

}  // namespace rinceau

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "lsystem/check_ends.h"
#include "lsystem/check_productions.h"
#include "lsystem/check_strings.h"
#include "lsystem/compile.h"
#include "lsystem/grammar_hints.h"
#include "lsystem/grammar_text.h"
#include "lsystem/parse_text.h"
#include "lsystem/resolve_uses.h"
#include "lsystem/similar_name.h"
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

class GrammarChecker {
  public:
    GrammarChecker(std::string_view text, const std::string& file_name, const GrammarLoader& load)
        : file_name_(file_name), state_(parse_text(text, file_name)), warnings_(state_.mistakes) {
        if (grammar().uses.empty()) return;
        if (!load) {
            complete_ = false;
            warn(grammar().uses.front().place, "expected a grammar without 'use' where no other file can be read");
            return;
        }
        ResolvedGrammar resolved = resolve_uses_with_mistakes(grammar(), load);
        complete_ = resolved.mistakes.empty();
        add(resolved.mistakes);
        state_.grammar = std::move(resolved.grammar);
    }

    GrammarFindings check() {
        check_names();
        if (warnings_.empty()) try_derivation();
        const bool full = warnings_.size() >= max_mistakes;
        put_in_order();
        if (full) {
            warnings_.push_back({warnings_.back().place, "expected fewer mistakes than " + std::to_string(max_mistakes) +
                                                             ", found more: correct these first"});
        }
        GrammarFindings findings{std::move(warnings_), {}};
        if (findings.mistakes.empty()) findings.hints = grammar_hints(grammar(), file_name_);
        return findings;
    }

  private:
    std::string file_name_;
    ParseState state_;
    Scope scope_;  // the constants; those whose value is not known are parameters
    std::optional<KnownNames> names_;
    std::map<std::vector<int>, int> exception_lines_;  // by address
    std::vector<Warning> warnings_;
    bool complete_ = true;  // else unknown names may be those of files that could not be read

    const Grammar& grammar() const { return state_.grammar; }
    void warn(const SourcePlace& place, const std::string& message) { add_mistake(warnings_, place, message); }
    void add(const std::vector<Warning>& found) {
        for (const Warning& warning : found) warn(warning.place, warning.message);
    }

    /// By file in the order in which they are met, the grammar's own first, then by place.
    void put_in_order() {
        std::map<std::string, std::size_t> files{{file_name_, 0}};
        for (const Warning& warning : warnings_) files.try_emplace(warning.place.file, files.size());
        const auto key = [&](const Warning& warning) {
            return std::tuple(files.at(warning.place.file), warning.place.line, warning.place.column);
        };
        std::ranges::stable_sort(warnings_, {}, key);
    }

    void check_names() {
        names_.emplace(grammar(), state_.spoilt, complete_);
        check_constants();
        check_axiom();
        const ProductionOrder order(grammar(), scope_);
        add(check_productions(grammar(), *names_, scope_, order, state_.unsure));
        add(check_ends(grammar(), order, state_.unsure));
        for (const Exception& exception : grammar().exceptions) check_exception(exception);
        check_exceptions_with_contexts();
        check_ignored();
        check_terminals();
    }

    void check_constants() {
        for (const Constant& constant : grammar().constants) {
            const CheckedExpression checked = check_expression(*names_, constant.value, scope_, constant.place);
            add(checked.mistakes);
            if (checked.program && is_constant(*checked.program)) {
                scope_.constants.try_emplace(constant.name, checked.program->code.front().number);
            } else {
                scope_.parameters.push_back(constant.name);
            }
        }
        scope_.parameters.insert(scope_.parameters.end(), state_.spoilt.begin(), state_.spoilt.end());
    }

    void check_string_here(const std::vector<ModuleTemplate>& string) { add(check_string(*names_, string, scope_)); }

    void check_axiom() {
        if (!state_.first_places.contains("axiom") || (grammar().axiom.empty() && warnings_.empty())) {
            warn({file_name_, 1, 1}, "expected an axiom, such as 'axiom: A', found none: nothing would be drawn");
        }
        check_string_here(grammar().axiom);
    }

    void check_exception(const Exception& exception) {
        check_string_here(exception.successor);
        const auto [first, is_first] = exception_lines_.try_emplace(exception.address, exception.place.line);
        if (!is_first) {
            warn(exception.place, "expected one exception at an address, found another: the first is in line " +
                                      std::to_string(first->second));
        }
    }

    void check_exceptions_with_contexts() {
        const auto in_context = std::ranges::find_if(grammar().productions, [](const Production& production) {
            return !production.left_context.empty() || !production.right_context.empty();
        });
        if (in_context == grammar().productions.end() || grammar().exceptions.empty()) return;
        warn(grammar().exceptions.front().place,
             "expected no exceptions in a grammar with contexts, found both: the production in line " +
                 std::to_string(in_context->place.line) + " has a context; take that away, or write a rule instead of this");
    }

    void check_ignored() {
        for (const std::string& symbol : grammar().ignored) {
            if (names_->occurring.contains(symbol) || names_->is_excused(symbol)) continue;
            const auto place = state_.first_places.find("ignore " + symbol);
            if (place == state_.first_places.end()) continue;  // of another file
            warn(place->second, "expected symbols behind 'ignore' that stand in the axiom or a successor, found '" + symbol +
                                    "', which stands in none" + did_you_mean(symbol, names_->symbols) + ": take it away");
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

GrammarFindings inspect_grammar(std::string_view text, const std::string& file_name, const GrammarLoader& load) {
    return GrammarChecker(text, file_name, load).check();
}

std::vector<Warning> check_grammar(std::string_view text, const std::string& file_name, const GrammarLoader& load) {
    return inspect_grammar(text, file_name, load).mistakes;
}

}  // namespace rinceau

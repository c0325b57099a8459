#pragma once
// Derivation as a stream: the modules of the derived string one after the other, depth first, with an explicit stack.
// Memory is proportional to the depth. Internal to the folder.

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "lsystem/choose_production.h"
#include "lsystem/derive_context.h"
#include "lsystem/interpret.h"
#include "lsystem/parameter_stack.h"

namespace rinceau {

/// Where the module stands that a sink is given. References hold during the call only; addresses and trails are empty
/// unless the stream is tracked.
struct StreamPlace {
    Occurrence occurrence;
    const std::vector<int>& address_front;       ///< the address but its last number ..
    int number = 0;                              ///< .. which is this; 0 = the module has no address
    const std::vector<Occurrence>& trail_front;  ///< the trail but its last occurrence
};

/// Sink: void command(const CompiledModule&, std::span<const double> arguments);
///       void leaf(const CompiledModule&, std::span<const double> arguments, const StreamPlace&);
///       void exception(int index), called when an exception takes the place of a module.
///       If it has them: void opened(const CompiledModule&, std::span<const double> arguments, int generation), called when
///       a module is replaced by what a production or an exception makes of it (an exception: without arguments), with the
///       steps that its modules have taken, and void closed() when all of that has been passed. opened may instead take
///       (const CompiledModule&, std::span<const double> arguments, int production, const StreamPlace&): by which production
///       (of an exception: -1), and where the module stands.
/// A sink with a member draws_nothing gets the derived string: homomorphisms do not apply.
/// tracked: addresses and trails are kept and exceptions apply. A grammar with exceptions needs it.
/// keyed: modules have keys to draw by. A grammar that draws anything needs it.
/// decided: what is rewritten was decided before, by contexts.
template <class Sink, bool tracked, bool keyed, bool decided>
class ModuleStream {
  public:
    ModuleStream(const CompiledGrammar& grammar, DerivationLimits& limits, const Progress& progress, Sink& sink,
                 const ContextDecisions& decisions)
        : grammar_(grammar),
          limits_(limits),
          progress_(progress),
          sink_(sink),
          decisions_(decisions),
          choice_(grammar),
          scratch_(static_cast<std::size_t>(grammar.stack_size)) {}

    void run() {
        open(grammar_.axiom, axiom_occurrence, no_symbol);
        set_key(frames_.back(), grammar_.root);
        for (std::uint32_t step = 1; !frames_.empty(); ++step) {
            if (step % steps_between_looks == 0) look_around();
            Frame& frame = frames_.back();
            if (frame.next == frame.end) {
                close();
                continue;
            }
            const CompiledModule& module = *frame.next++;
            if (module.symbol < command_count) {
                pass_command(frame, module);
            } else {
                pass_symbol(frame, module);
            }
        }
    }

  private:
    static constexpr int axiom_occurrence = -1;
    static constexpr int exception_occurrence = -2;
    static constexpr Symbol no_symbol = -1;
    static constexpr std::uint32_t steps_between_looks = 1U << 16U;

    struct NoKey {};
    /// A string that is being passed: the axiom, a production's or an exception's successor.
    struct Frame {
        const CompiledModule* next;
        const CompiledModule* end;
        std::size_t values;  ///< where the parameters begin
        int occurrence;      ///< Occurrence::production of its modules
        Symbol own;          ///< modules of this symbol continue the level
        int generation = 0;
        int between = 0;       ///< productions on the way that took no step
        bool drawing = false;  ///< what a homomorphism made: only homomorphisms apply to it
        bool opens_level = false;
        bool opens_trail = false;
        int fixed_number = 0;  ///< > 0: the one module of an exception stands at the address of the module it replaces
        int fixed_node = ExceptionTree::none;
        std::size_t decision = 0;                                               ///< of its first symbol, if decided
        [[no_unique_address]] std::conditional_t<keyed, DrawKey, NoKey> key{};  ///< of the module whose place it takes
    };
    /// A symbol on its way: where it stands and what it draws by.
    struct Standing {
        bool continues = false;  ///< the level of the production whose own symbol it is
        int number = 0;          ///< of its address, 0 = none
        int node = ExceptionTree::none;
        DrawKey key = 0;
    };
    static constexpr bool draws = !requires { Sink::draws_nothing; };
    /// Modules counted below one address.
    struct Level {
        int count = 0;
        int node = ExceptionTree::none;
    };

    static void set_key(Frame& frame, DrawKey key) {
        if constexpr (keyed) frame.key = key;
    }
    static DrawKey key_of(const Frame& frame) {
        if constexpr (keyed) return frame.key;
        return 0;
    }
    /// An exception with a single symbol hands on the key as it hands on the address.
    static DrawKey key_of(const Frame& frame, const CompiledModule& module) {
        if constexpr (keyed) {
            return frame.fixed_number > 0 ? frame.key : key_below(frame.key, static_cast<std::uint64_t>(module.number));
        }
        return 0;
    }

    const CompiledGrammar& grammar_;
    DerivationLimits& limits_;
    const Progress& progress_;
    Sink& sink_;
    const ContextDecisions& decisions_;
    ProductionChoice choice_;
    std::vector<double> scratch_;
    std::vector<Frame> frames_;
    ParameterStack values_;  ///< parameters of the open frames
    std::vector<int> address_;
    std::vector<Level> levels_{Level{0, 0}};
    std::vector<Occurrence> trail_;

    void look_around() {
        limits_.check_time();
        if (!progress_) return;
        double done = 0;
        double share = 1;
        constexpr std::size_t levels_that_show = 6;
        for (std::size_t i = 0; i < frames_.size() && i < levels_that_show; ++i) {
            const Frame& frame = frames_[i];
            const CompiledString* string = string_of(frame);
            if (string == nullptr || string->empty()) break;
            const double size = static_cast<double>(string->size());
            const double in_work = i + 1 < frames_.size() ? 1 : 0;
            done += share * (size - static_cast<double>(frame.end - frame.next) - in_work) / size;
            share /= size;
        }
        report(progress_, "derive", done);
    }
    /// nullptr for an exception's successor: too small a part of the work to show.
    const CompiledString* string_of(const Frame& frame) const {
        if (frame.occurrence == exception_occurrence) return nullptr;
        return frame.occurrence >= 0 ? &grammar_.productions[static_cast<std::size_t>(frame.occurrence)].successor
                                     : &grammar_.axiom;
    }

    Frame& open(const CompiledString& string, int occurrence, Symbol own) {
        frames_.push_back({string.data(), string.data() + string.size(), values_.size(), occurrence, own});
        return frames_.back();
    }

    void close() {
        if constexpr (requires { sink_.closed(); }) {
            if (frames_.size() > 1) sink_.closed();  // the axiom was not opened
        }
        const Frame& frame = frames_.back();
        values_.shrink_to(frame.values);
        if constexpr (tracked) {
            if (frame.opens_level) {
                levels_.pop_back();
                address_.pop_back();
            }
            if (frame.opens_trail) trail_.pop_back();
        }
        frames_.pop_back();
    }

    std::span<const double> arguments_of(const Frame& frame, const CompiledModule& module) {
        if (module.constant) {
            return {grammar_.values.data() + module.first_value, static_cast<std::size_t>(module.argument_count)};
        }
        const auto count = static_cast<std::size_t>(module.argument_count);
        double* const values = values_.room(count);
        for (std::size_t i = 0; i < count; ++i) {
            values[i] = evaluate(module.arguments[i], values_.from(frame.values), scratch_.data(), key_of(frame));
            if (!std::isfinite(values[i])) throw_not_finite(module);
        }
        return {values, count};
    }

    void pass_command(const Frame& frame, const CompiledModule& module) {
        limits_.count_module();
        sink_.command(module, arguments_of(frame, module));
    }

    void pass_symbol(Frame& frame, const CompiledModule& module) {
        Standing standing{module.symbol == frame.own};
        if constexpr (keyed) standing.key = key_of(frame, module);
        if constexpr (tracked) {
            if (!standing.continues && count_and_except(frame, module, standing)) return;
        }
        const std::span<const double> arguments = arguments_of(frame, module);
        const ProductionsOfSymbol& productions = grammar_.productions_of[static_cast<std::size_t>(module.symbol)];
        if constexpr (decided) {
            if (!frame.drawing && expand_as_decided(frame, module, arguments, standing)) return;
        }
        const int production = frame.drawing ? choice_.choose_by_count(productions.homomorphism, arguments, standing.key)
                                             : rewriting(frame, productions, arguments, standing.key);
        if (production >= 0) {
            expand(frame, module, production, arguments, standing);
        } else {
            pass_rest(frame, module, arguments, standing);
        }
    }

    /// False if the symbol stands in the derived string.
    bool expand_as_decided(const Frame& frame, const CompiledModule& module, std::span<const double> arguments,
                           Standing& standing) {
        const ContextDecisions::Decision decision =
            decisions_.symbols[frame.decision + static_cast<std::size_t>(module.number) - 1];
        if (decision.production < 0) return false;
        const CompiledProduction& applied = grammar_.productions[static_cast<std::size_t>(decision.production)];
        const int waited = decision.step - frame.generation;
        standing.key = key_after(standing.key, waited);
        expand(frame, module, decision.production, arguments, standing, waited);
        frames_.back().decision = decision.first;
        values_.add(
            std::span(decisions_.values).subspan(decision.values, static_cast<std::size_t>(applied.context_parameters)));
        return true;
    }

    int rewriting(const Frame& frame, const ProductionsOfSymbol& productions, std::span<const double> arguments,
                  DrawKey key) {
        if constexpr (decided) return -1;
        const int production = choice_.choose_by_count(productions.decomposition, arguments, key);
        if (production >= 0 || frame.generation >= limits_.depth()) return production;
        return choice_.choose_by_count(productions.rewriting, arguments, key);
    }

    /// A symbol that is not rewritten.
    void pass_rest(Frame& frame, const CompiledModule& module, std::span<const double> arguments, Standing& standing) {
        if constexpr (tracked) {
            const bool counted = frame.drawing ? grammar_.terminal_of[static_cast<std::size_t>(module.symbol)] >= 0
                                               : grammar_.is_drawn(module.symbol);
            if (standing.continues && counted && count_and_except(frame, module, standing)) return;
        }
        if constexpr (draws) {
            const ProductionsOfSymbol& productions = grammar_.productions_of[static_cast<std::size_t>(module.symbol)];
            const int production =
                frame.drawing ? -1 : choice_.choose_by_count(productions.homomorphism, arguments, standing.key);
            if (production >= 0) {
                standing.continues = false;
                expand(frame, module, production, arguments, standing);
                return;
            }
        }
        limits_.count_module();
        sink_.leaf(module, arguments, {{frame.occurrence, module.position}, address_, standing.number, trail_});
    }

    /// Gives the module its number; true if an exception takes its place.
    bool count_and_except(Frame& frame, const CompiledModule& module, Standing& standing) {
        if (frame.fixed_number > 0) {
            standing.number = frame.fixed_number;
            standing.node = frame.fixed_node;
            return false;
        }
        Level& level = levels_.back();
        standing.number = ++level.count;
        standing.node = grammar_.exception_tree.child(level.node, standing.number);
        const int exception = grammar_.exception_tree.exception_at(standing.node);
        if (exception == ExceptionTree::none) return false;
        sink_.exception(exception);
        open_exception(frame, module, grammar_.exceptions[static_cast<std::size_t>(exception)], standing);
        return true;
    }

    void tell_opened(const Frame& at, const CompiledModule& module, std::span<const double> arguments, int generation,
                     int production, int number) {
        if constexpr (requires { sink_.opened(module, arguments, generation); }) sink_.opened(module, arguments, generation);
        const StreamPlace place{{at.occurrence, module.position}, address_, number, trail_};
        if constexpr (requires { sink_.opened(module, arguments, production, place); })
            sink_.opened(module, arguments, production, place);
    }

    void open_exception(const Frame& at, const CompiledModule& module, const CompiledString& successor,
                        const Standing& standing) {
        tell_opened(at, module, {}, at.generation, -1, standing.number);
        int symbols = 0;
        for (const CompiledModule& part : successor) symbols += part.symbol >= command_count;
        trail_.push_back({at.occurrence, module.position});
        const Frame before = at;  // opening one may move the others
        Frame& frame = open(successor, exception_occurrence, no_symbol);
        frame.generation = before.generation;
        frame.between = before.between;
        frame.drawing = before.drawing;
        set_key(frame, standing.key);
        frame.opens_trail = true;
        if (symbols == 1) {
            frame.fixed_number = standing.number;
            frame.fixed_node = standing.node;
        } else {
            frame.opens_level = true;
            address_.push_back(standing.number);
            levels_.push_back({0, standing.node});
        }
    }

    void expand(const Frame& at, const CompiledModule& module, int production, std::span<const double> arguments,
                const Standing& standing, int waited = 0) {
        const CompiledProduction& applied = grammar_.productions[static_cast<std::size_t>(production)];
        const bool step = applied.kind == ProductionKind::rewriting;
        const int generation = at.generation + waited + (step ? 1 : 0);
        const int between = at.between + (step ? 0 : 1);
        const int occurrence = at.occurrence;
        limits_.count_application(production, generation, between, frames_.size());
        tell_opened(at, module, arguments, generation, production, standing.number);
        Frame& frame = open(applied.successor, production, applied.symbol);
        frame.generation = generation;
        frame.between = between;
        frame.drawing = applied.kind == ProductionKind::homomorphism;
        set_key(frame, standing.key);
        values_.add(arguments);
        if constexpr (tracked) {
            if (standing.continues) return;
            frame.opens_level = frame.opens_trail = true;
            address_.push_back(standing.number);
            levels_.push_back({0, standing.node});
            trail_.push_back({occurrence, module.position});
        }
    }
};

/// Streams the derivation of the grammar into the sink, tracked if asked for or if the grammar has exceptions.
template <class Sink>
void stream_modules(const CompiledGrammar& grammar, const DeriveOptions& options, const Progress& progress, bool track,
                    Sink& sink) {
    const bool tracked = track || !grammar.exception_tree.empty();
    DerivationLimits limits(grammar, options);
    ContextDecisions decisions;
    const auto run = [&]<bool is_tracked, bool is_keyed, bool is_decided>() {
        ModuleStream<Sink, is_tracked, is_keyed, is_decided>(grammar, limits, progress, sink, decisions).run();
    };
    if (grammar.contextual) {
        decisions = decide_by_context(grammar, limits, progress);
        limits.count_from_zero();
        run.template operator()<true, true, true>();
    } else if (grammar.random) {
        tracked ? run.template operator()<true, true, false>() : run.template operator()<false, true, false>();
    } else {
        tracked ? run.template operator()<true, false, false>() : run.template operator()<false, false, false>();
    }
}

}  // namespace rinceau

#pragma once
// Derivation as a stream: the modules of the derived string one after the other, depth first, with an explicit stack.
// Memory is proportional to the depth. Internal to the folder.

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "lsystem/compile.h"
#include "lsystem/derive.h"
#include "lsystem/interpret.h"

namespace rinceau {

/// Where the module stands that a sink is given. References hold during the call only; addresses and trails are empty
/// unless the stream is tracked.
struct StreamPlace {
    Occurrence occurrence;
    const std::vector<int>& address_front;       ///< the address but its last number ..
    int number = 0;                              ///< .. which is this; 0 = the module has no address
    const std::vector<Occurrence>& trail_front;  ///< the trail but its last occurrence
};

/// Counts what is derived and stops what does not end (derive.h, DeriveOptions).
class DerivationLimits {
  public:
    DerivationLimits(const CompiledGrammar& grammar, const DeriveOptions& options);

    void count_module() {
        if (++work_ > options_.max_modules) throw_too_large();
    }
    void count_application(int production, int generation, std::size_t open) {
        ++applied_[static_cast<std::size_t>(production)];
        count_module();
        if (generation > deepest_ || open > max_open) throw_too_deep(production);
    }
    /// Called now and then.
    void check_time() const;
    /// Modules are rewritten while their generation is below this.
    int depth() const { return options_.depth < 0 ? std::numeric_limits<int>::max() : options_.depth; }

  private:
    static constexpr std::size_t max_open = 4'000'000;  // productions being expanded at a time: some 300 MB

    const CompiledGrammar& grammar_;
    DeriveOptions options_;
    std::uint64_t work_ = 0;  ///< modules that were passed on or rewritten
    std::vector<std::uint64_t> applied_;
    int deepest_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

    [[noreturn]] void throw_too_large() const;
    [[noreturn]] void throw_too_deep(int production) const;
    [[noreturn]] void throw_at(int production, const std::string& what) const;
    int most_applied() const;
};

/// Sink: void command(const CompiledModule&, double argument);
///       void leaf(const CompiledModule&, std::span<const double> arguments, const StreamPlace&);
///       void exception(int index), called when an exception takes the place of a module.
///       If it has them: void opened(const CompiledModule&, std::span<const double> arguments, int generation), called when
///       a module is replaced by what a production or an exception makes of it (an exception: without arguments), with the
///       steps that its modules have taken, and void closed() when all of that has been passed.
/// tracked: addresses and trails are kept and exceptions apply. A grammar with exceptions needs it.
template <class Sink, bool tracked>
class ModuleStream {
  public:
    ModuleStream(const CompiledGrammar& grammar, const DeriveOptions& options, const Progress& progress, Sink& sink)
        : grammar_(grammar),
          limits_(grammar, options),
          progress_(progress),
          sink_(sink),
          scratch_(static_cast<std::size_t>(grammar.stack_size)) {}

    void run() {
        open(grammar_.axiom, axiom_occurrence, no_symbol, 0);
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

    /// A string that is being passed: the axiom, a production's or an exception's successor.
    struct Frame {
        const CompiledModule* next;
        const CompiledModule* end;
        std::size_t values;  ///< where the parameters begin
        int occurrence;      ///< Occurrence::production of its modules
        int generation;
        Symbol own;  ///< modules of this symbol continue the level
        bool opens_level = false;
        bool opens_trail = false;
        int fixed_number = 0;  ///< > 0: the one module of an exception stands at the address of the module it replaces
        int fixed_node = ExceptionTree::none;
    };
    /// Modules counted below one address.
    struct Level {
        int count = 0;
        int node = ExceptionTree::none;
    };

    const CompiledGrammar& grammar_;
    DerivationLimits limits_;
    const Progress& progress_;
    Sink& sink_;
    std::vector<double> scratch_;
    std::vector<Frame> frames_;
    std::vector<double> values_;  ///< parameters of the open frames
    std::vector<double> arguments_;
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

    Frame& open(const CompiledString& string, int occurrence, Symbol own, int generation) {
        frames_.push_back({string.data(), string.data() + string.size(), values_.size(), occurrence, generation, own});
        return frames_.back();
    }

    void close() {
        if constexpr (requires { sink_.closed(); }) {
            if (frames_.size() > 1) sink_.closed();  // the axiom was not opened
        }
        const Frame& frame = frames_.back();
        values_.resize(frame.values);
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
        arguments_.clear();
        for (const Program& argument : module.arguments) {
            const double value = evaluate(argument, values_.data() + frame.values, scratch_.data());
            if (!std::isfinite(value)) throw_not_finite(module);
            arguments_.push_back(value);
        }
        return arguments_;
    }
    [[noreturn]] static void throw_not_finite(const CompiledModule& module) {
        throw InputError(module.source->place, "expected finite arguments of " + module.source->symbol +
                                                   ", found a division by zero or an overflow");
    }

    void pass_command(const Frame& frame, const CompiledModule& module) {
        limits_.count_module();
        const std::span<const double> arguments = arguments_of(frame, module);
        sink_.command(module, arguments.empty() ? 0 : arguments.front());
    }

    void pass_symbol(Frame& frame, const CompiledModule& module) {
        int number = 0;
        int node = ExceptionTree::none;
        const bool continues = module.symbol == frame.own;
        if constexpr (tracked) {
            if (!continues && count_and_except(frame, module, number, node)) return;
        }
        const std::span<const double> arguments = arguments_of(frame, module);
        const int production = frame.generation < limits_.depth() ? production_for(module, arguments) : -1;
        if (production >= 0) {
            expand(frame, module, production, arguments, continues, number, node);
            return;
        }
        if constexpr (tracked) {
            const bool drawn = grammar_.terminal_of[static_cast<std::size_t>(module.symbol)] >= 0;
            if (continues && drawn && count_and_except(frame, module, number, node)) return;
        }
        limits_.count_module();
        sink_.leaf(module, arguments, {{frame.occurrence, module.position}, address_, number, trail_});
    }

    /// Gives the module its number; true if an exception takes its place.
    bool count_and_except(Frame& frame, const CompiledModule& module, int& number, int& node) {
        if (frame.fixed_number > 0) {
            number = frame.fixed_number;
            node = frame.fixed_node;
            return false;
        }
        Level& level = levels_.back();
        number = ++level.count;
        node = grammar_.exception_tree.child(level.node, number);
        const int exception = grammar_.exception_tree.exception_at(node);
        if (exception == ExceptionTree::none) return false;
        sink_.exception(exception);
        open_exception(frame, module, grammar_.exceptions[static_cast<std::size_t>(exception)], number, node);
        return true;
    }

    void tell_opened(const CompiledModule& module, std::span<const double> arguments, int generation) {
        if constexpr (requires { sink_.opened(module, arguments, generation); }) sink_.opened(module, arguments, generation);
    }

    void open_exception(const Frame& at, const CompiledModule& module, const CompiledString& successor, int number,
                        int node) {
        tell_opened(module, {}, at.generation);
        int symbols = 0;
        for (const CompiledModule& part : successor) symbols += part.symbol >= command_count;
        trail_.push_back({at.occurrence, module.position});
        Frame& frame = open(successor, exception_occurrence, no_symbol, at.generation);
        frame.opens_trail = true;
        if (symbols == 1) {
            frame.fixed_number = number;
            frame.fixed_node = node;
        } else {
            frame.opens_level = true;
            address_.push_back(number);
            levels_.push_back({0, node});
        }
    }

    int production_for(const CompiledModule& module, std::span<const double> arguments) {
        for (const int index : grammar_.productions_of[static_cast<std::size_t>(module.symbol)]) {
            const CompiledProduction& production = grammar_.productions[static_cast<std::size_t>(index)];
            if (production.parameters != static_cast<int>(arguments.size())) continue;
            if (!production.conditional) return index;
            const double holds = evaluate(production.condition, arguments.data(), scratch_.data());
            if (std::isnan(holds)) throw_undefined(index);
            if (holds != 0) return index;
        }
        return -1;
    }
    [[noreturn]] void throw_undefined(int production) const {
        const Production& source = grammar_.grammar->productions[static_cast<std::size_t>(production)];
        throw InputError(source.place, "expected a condition of " + source.symbol + " with a value, found 0/0 or the like");
    }

    void expand(const Frame& at, const CompiledModule& module, int production, std::span<const double> arguments,
                bool continues, int number, int node) {
        const int generation = at.generation + 1;
        const int occurrence = at.occurrence;
        limits_.count_application(production, generation, frames_.size());
        tell_opened(module, arguments, generation);
        const CompiledProduction& applied = grammar_.productions[static_cast<std::size_t>(production)];
        Frame& frame = open(applied.successor, production, applied.symbol, generation);
        values_.insert(values_.end(), arguments.begin(), arguments.end());
        if constexpr (tracked) {
            if (continues) return;
            frame.opens_level = frame.opens_trail = true;
            address_.push_back(number);
            levels_.push_back({0, node});
            trail_.push_back({occurrence, module.position});
        }
    }
};

/// Streams the derivation of the grammar into the sink, tracked if asked for or if the grammar has exceptions.
template <class Sink>
void stream_modules(const CompiledGrammar& grammar, const DeriveOptions& options, const Progress& progress, bool track,
                    Sink& sink) {
    if (track || !grammar.exception_tree.empty()) {
        ModuleStream<Sink, true>(grammar, options, progress, sink).run();
    } else {
        ModuleStream<Sink, false>(grammar, options, progress, sink).run();
    }
}

}  // namespace rinceau

#include "lsystem/unfolded_exceptions.h"

#include <algorithm>
#include <set>

#include "lsystem/flat_grammar.h"
#include "lsystem/stream.h"

namespace rinceau {

namespace {

/// Which expansions an exception lies in. Expansions are numbered in order of derivation.
class ExpansionMarker {
  public:
    void command(const CompiledModule&, std::span<const double>) {}
    void leaf(const CompiledModule&, std::span<const double>, const StreamPlace&) {}
    /// The exception's own successor is opened next: it is an expansion that stands in the axiom, too.
    void exception(int) {
        for (const std::size_t expansion : open_) marked_[expansion] = true;
        next_is_exception_ = true;
    }
    void opened(const CompiledModule&, std::span<const double>, int) {
        open_.push_back(marked_.size());
        marked_.push_back(next_is_exception_);
        next_is_exception_ = false;
    }
    void closed() { open_.pop_back(); }

    std::vector<bool> marked() && { return std::move(marked_); }

  private:
    std::vector<bool> marked_;
    std::vector<std::size_t> open_;
    bool next_is_exception_ = false;
};

std::string unused_parameter(const Grammar& grammar) {
    std::set<std::string> taken;
    for (const Constant& constant : grammar.constants) taken.insert(constant.name);
    for (const Production& production : grammar.productions) {
        taken.insert(production.parameters.begin(), production.parameters.end());
        for (const auto* context : {&production.left_context, &production.right_context}) {
            for (const ContextModule& module : *context) taken.insert(module.parameters.begin(), module.parameters.end());
        }
    }
    std::string name = "steps";
    while (taken.contains(name)) name += '_';
    return name;
}

/// Which symbols carry the steps that are left. Empty without a limit of depth.
std::set<std::string> counted_symbols(const Grammar& grammar, int depth) {
    std::set<std::string> counted;
    if (depth < 0) return counted;
    for (const Production& production : grammar.productions) {
        if (production.kind != ProductionKind::homomorphism) counted.insert(production.symbol);
    }
    return counted;
}

/// The axiom in which marked expansions are expanded and all other modules stand as they are.
class AxiomWriter {
  public:
    AxiomWriter(const std::vector<bool>& marked, const std::set<std::string>& counted, int depth)
        : marked_(marked), counted_(counted), depth_(depth) {}

    void command(const CompiledModule& module, std::span<const double> arguments) {
        if (hidden_ == 0) append(module, arguments);
    }
    void leaf(const CompiledModule& module, std::span<const double> arguments, const StreamPlace&) {
        if (hidden_ == 0) append(module, arguments);
    }
    void exception(int) {}
    void opened(const CompiledModule& module, std::span<const double> arguments, int generation) {
        const bool expanded = marked_[expansions_++];
        if (hidden_ == 0 && !expanded) append(module, arguments);
        if (hidden_ > 0 || !expanded) {
            ++hidden_;
        } else {
            generations_.push_back(generation);
        }
    }
    void closed() {
        if (hidden_ > 0) {
            --hidden_;
        } else {
            generations_.pop_back();
        }
    }

    std::vector<ModuleTemplate> axiom() && { return std::move(axiom_); }

  private:
    const std::vector<bool>& marked_;
    const std::set<std::string>& counted_;
    int depth_;
    std::vector<ModuleTemplate> axiom_;
    std::vector<int> generations_{0};  ///< of the open expansions that stand in the axiom
    std::size_t expansions_ = 0;
    int hidden_ = 0;  ///< open expansions inside a module that stays

    void append(const CompiledModule& module, std::span<const double> arguments) {
        ModuleTemplate written{module.source->symbol, {}, module.source->place};
        for (const double argument : arguments) written.arguments.push_back(number_expression(argument));
        if (counted_.contains(written.symbol)) written.arguments.push_back(number_expression(depth_ - generations_.back()));
        axiom_.push_back(std::move(written));
    }
};

/// steps > 0 && condition
Expression while_steps_last(const std::string& steps, const std::optional<Expression>& condition) {
    Expression holds{{{Expression::Op::name, 0, steps}, {Expression::Op::number, 0}, {Expression::Op::greater}}};
    if (!condition) return holds;
    holds.postfix.insert(holds.postfix.end(), condition->postfix.begin(), condition->postfix.end());
    holds.postfix.push_back({Expression::Op::logical_and});
    return holds;
}

Expression one_less(const std::string& steps) {
    return {{{Expression::Op::name, 0, steps}, {Expression::Op::number, 1}, {Expression::Op::subtract}}};
}

Production counted_production(Production production, const std::set<std::string>& counted, const std::string& steps) {
    const auto is_counted = [&](const std::string& symbol) { return counted.contains(symbol); };
    Expression left = number_expression(0);  // below a homomorphism nothing is rewritten
    if (is_counted(production.symbol)) production.parameters.push_back(steps);
    if (production.kind == ProductionKind::rewriting) {
        production.condition = while_steps_last(steps, production.condition);
        left = one_less(steps);
    } else if (production.kind == ProductionKind::decomposition) {
        left = name_expression(steps);
    }
    for (auto* context : {&production.left_context, &production.right_context}) {
        int number = 0;  // names of a production's contexts differ
        for (ContextModule& module : *context) {
            if (!is_counted(module.symbol)) continue;
            const std::string side = context == &production.left_context ? "_left" : "_right";
            module.parameters.push_back(steps + side + std::to_string(++number));
        }
    }
    for (ModuleTemplate& module : production.successor) {
        if (is_counted(module.symbol)) module.arguments.push_back(left);
    }
    return production;
}

}  // namespace

Grammar unfolded_exceptions(const Grammar& grammar, const DeriveOptions& options) {
    if (grammar.exceptions.empty() && options.depth < 0) return grammar;
    // what a homomorphism makes is not rewritten, but it would be in an axiom
    const auto only_draws = [](const Production& production) { return production.kind == ProductionKind::homomorphism; };
    if (!grammar.exceptions.empty() && std::ranges::any_of(grammar.productions, only_draws))
        return flat_grammar(grammar, options);
    const CompiledGrammar compiled = compile(grammar);
    ExpansionMarker marker;
    stream_modules(compiled, options, {}, true, marker);
    const std::vector<bool> marked = std::move(marker).marked();
    const std::set<std::string> counted = counted_symbols(grammar, options.depth);
    AxiomWriter writer(marked, counted, options.depth);
    stream_modules(compiled, options, {}, true, writer);

    Grammar result = grammar;
    result.axiom = std::move(writer).axiom();
    result.exceptions.clear();
    if (options.depth < 0) return result;
    const std::string steps = unused_parameter(grammar);
    for (Production& production : result.productions) production = counted_production(std::move(production), counted, steps);
    return result;
}

}  // namespace rinceau

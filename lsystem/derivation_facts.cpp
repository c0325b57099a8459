#include "lsystem/derivation_facts.h"

#include <algorithm>
#include <cmath>

#include "lsystem/stream.h"

namespace rinceau {

namespace {

class FactCollector {
  public:
    explicit FactCollector(const CompiledGrammar& grammar) : grammar_(grammar) {}

    void command(const CompiledModule&, std::span<const double>) {}
    void leaf(const CompiledModule& module, std::span<const double> arguments, const StreamPlace&) {
        note(module, arguments);
    }
    void exception(int) { is_exception_ = true; }
    void opened(const CompiledModule& module, std::span<const double> arguments, int) {
        if (!is_exception_) note(module, arguments);
        is_exception_ = false;
        facts_.depth = std::max(facts_.depth, ++open_);
    }
    void closed() { --open_; }

    DerivationFacts facts() && { return std::move(facts_); }

  private:
    const CompiledGrammar& grammar_;
    DerivationFacts facts_;
    int open_ = 0;
    bool is_exception_ = false;

    void note(const CompiledModule& module, std::span<const double> arguments) {
        const std::string& symbol = grammar_.symbols[static_cast<std::size_t>(module.symbol)];
        const auto [place, added] = facts_.arguments.try_emplace({symbol, arguments.size()});
        std::vector<ArgumentRange>& ranges = place->second;
        if (added) {
            for (const double value : arguments) ranges.push_back({value, value});
        }
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            ranges[i].lowest = std::min(ranges[i].lowest, arguments[i]);
            ranges[i].highest = std::max(ranges[i].highest, arguments[i]);
            ranges[i].whole = ranges[i].whole && arguments[i] == std::floor(arguments[i]);
        }
    }
};

}  // namespace

DerivationFacts derivation_facts(const Grammar& grammar, const DeriveOptions& options, const Progress& progress) {
    const CompiledGrammar compiled = compile(grammar);
    FactCollector collector(compiled);
    stream_modules(compiled, options, progress, true, collector);
    return std::move(collector).facts();
}

}  // namespace rinceau

#include "lsystem/derivation_limits.h"

#include <algorithm>

namespace rinceau {

namespace {

/// 50000001 -> "50,000,001"
std::string grouped(std::uint64_t count) {
    std::string digits = std::to_string(count);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    return digits;
}

}  // namespace

DerivationLimits::DerivationLimits(const CompiledGrammar& grammar, const DeriveOptions& options)
    : grammar_(grammar),
      options_(options),
      applied_(grammar.productions.size()),
      deepest_(options.depth < 0 ? options.max_recursion : std::numeric_limits<int>::max()) {}

void DerivationLimits::check_time() const {
    if (options_.max_seconds <= 0) return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    if (spent.count() > options_.max_seconds)
        throw_at<LimitError>(most_applied(), "the derivation took longer than its time limit");
}

int DerivationLimits::most_applied() const {
    const auto most = std::ranges::max_element(applied_);
    return most == applied_.end() || *most == 0 ? -1 : static_cast<int>(most - applied_.begin());
}

void DerivationLimits::throw_too_large() const {
    throw_at<TooManyModules>(most_applied(),
                             "the limit is " + grouped(options_.max_modules) + " modules, rewritten ones included");
}

void DerivationLimits::throw_too_deep(int production) const {
    const bool step = grammar_.productions[static_cast<std::size_t>(production)].kind == ProductionKind::rewriting;
    const auto recursion = static_cast<std::uint64_t>(options_.max_recursion);
    if (step && options_.depth >= 0) {
        throw_at<LimitError>(production, "the limit is " + grouped(max_open) + " productions one inside the other");
    }
    throw_at<LimitError>(
        production, "the limit is " + grouped(recursion) +
                        (step ? " steps one inside the other" : " decompositions or homomorphisms one inside the other"));
}

template <class Error>
void DerivationLimits::throw_at(int production, const std::string& what) const {
    if (production < 0) throw Error({}, "the derived string is too long: " + what);
    const Production& source = grammar_.grammar->productions[static_cast<std::size_t>(production)];
    std::string message = "production " + source.symbol;
    if (source.place.line > 0) message += " at line " + std::to_string(source.place.line);
    message += " was applied " + grouped(applied_[static_cast<std::size_t>(production)]) + " times (" + what +
               "): lower the count or give it a condition that ends";
    throw Error(source.place, message);
}

}  // namespace rinceau

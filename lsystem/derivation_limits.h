#pragma once
// What stops a derivation that does not end. Internal to the folder.

#include <chrono>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "lsystem/compile.h"
#include "lsystem/derive.h"

namespace rinceau {

/// DeriveOptions::max_modules was reached.
class TooManyModules : public LimitError {
  public:
    using LimitError::LimitError;
};

/// Counts what is derived and stops what does not end (derive.h, DeriveOptions).
class DerivationLimits {
  public:
    DerivationLimits(const CompiledGrammar& grammar, const DeriveOptions& options);

    void count_module() {
        if (++work_ > options_.max_modules) throw_too_large();
    }
    /// `generation`: steps of rewriting down to it; `between`: productions that took no step on the way.
    void count_application(int production, int generation, int between, std::size_t open) {
        ++applied_[static_cast<std::size_t>(production)];
        count_module();
        if (generation > deepest_ || between > options_.max_recursion || open > max_open) throw_too_deep(production);
    }
    /// What was counted does not count any more; the time does.
    void count_from_zero() {
        work_ = 0;
        applied_.assign(applied_.size(), 0);
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
    /// Of the kind of LimitError.
    template <class Error>
    [[noreturn]] void throw_at(int production, const std::string& what) const;
    int most_applied() const;
};

}  // namespace rinceau

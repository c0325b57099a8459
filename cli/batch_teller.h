#pragma once
// What a batch says while it works, on standard error.

#include <chrono>
#include <cstddef>
#include <string>

#include "cli/batch_report.h"
#include "cli/progress_bar.h"

namespace rinceau {

/// On a terminal a bar, and a line for each drawing that fails; otherwise a line for each drawing.
class BatchTeller {
  public:
    /// `todo` of `drawings` are not whole yet; says so if that is not all.
    BatchTeller(std::size_t todo, std::size_t drawings);

    /// One more drawing has ended.
    void tell(const std::string& input, const BatchRow& row);

    void tell_interruption();

  private:
    ProgressBar bar_;
    Progress progress_;
    std::size_t todo_;
    std::size_t ended_ = 0;
    std::size_t failed_ = 0;
    std::chrono::steady_clock::time_point start_;

    std::string stage() const;
};

/// Says how many drawings are done and how many are not; returns the latter.
std::size_t say_totals(const BatchEntries& entries);

}  // namespace rinceau

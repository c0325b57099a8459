#pragma once
// rinceau analyze with many drawings: what one run takes, what it writes, what it says (docs/batch.md).

#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "analyzer/analyze.h"
#include "cli/batch_drawings.h"

namespace rinceau {

struct BatchOptions {
    std::optional<int> jobs;  ///< processes at a time; 0 = one per processor
    std::optional<Shard> shard;
    bool resume = false;            ///< leave what is whole already
    std::optional<double> seconds;  ///< for one drawing; 0 = any
    std::optional<int> memory_mib;  ///< for one drawing; 0 = the machine's, divided by the jobs
};

void add_batch_options(CLI::App& verb, BatchOptions& options);

/// Is this more than one drawing, read and written by name?
bool is_batch(const std::vector<std::string>& inputs, const std::string& output, const BatchOptions& options);

/// Analyses every drawing into `folder`, writes the reports, and returns the exit status. Throws as main.cpp knows.
int run_batch(const std::vector<std::string>& inputs, const std::string& folder, const std::vector<std::string>& reports,
              const AnalyzeOptions& analyze, const BatchOptions& options);

}  // namespace rinceau

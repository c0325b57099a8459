#pragma once
// What the command line of rinceau arrange asks for.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "growth/arrangement/arrange_options.h"
#include "growth/arrangement/jitter.h"

namespace rinceau {

struct ArrangeSettings {
    std::string input;
    std::string output;
    std::optional<std::size_t> count;
    std::optional<Point> size;                  ///< of the canvas
    std::string region, boundary, flow, spray;  ///< names of drawings; empty = none
    double spray_radius = 0;
    bool undirected = false;
    std::optional<bool> tile;  ///< none = as the drawing looks
    std::vector<std::string> raised;
    std::vector<std::pair<std::string, double>> priorities;
    std::vector<std::pair<int, int>> flips;
    JitterOptions jitter;
    std::string connectivity, numbering, report;  ///< names of outputs; empty = none
    double seconds = 0;                           ///< 0 = no limit
    ArrangeOptions growth;                        ///< but for the priorities
};

/// Declares all options; what is at fault by itself is refused while the command line is parsed.
void add_arrange_options(CLI::App& verb, ArrangeSettings& settings);

/// Throws CLI::ValidationError for options that do not go together and for names of outputs that are none, OutputError for
/// outputs that cannot be written.
void expect_consistent(const ArrangeSettings& settings);

}  // namespace rinceau

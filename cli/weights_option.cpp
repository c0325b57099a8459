#include "cli/weights_option.h"

#include <CLI/Error.hpp>

#include "cli/named_values.h"

namespace rinceau {
namespace {

constexpr double largest_weight = 4;

}  // namespace

ImportanceWeights parse_weights(const std::string& text) {
    ImportanceWeights weights;
    const NamedValues format{.option = "--weights", .names = {"n", "h", "phi", "l"}, .low = 0, .high = largest_weight};
    for (const auto& [name, value] : parse_named_values(format, text)) {
        if (name == "n") weights.count = value;
        if (name == "h") weights.nearness = value;
        if (name == "phi") weights.similarity = value;
        if (name == "l") weights.length = value;
    }
    return weights;
}

Objective parse_objective(const std::string& text) {
    if (text == "bits") return Objective::bits;
    if (text == "paper") return Objective::paper;
    throw CLI::ValidationError("--objective", "expected bits or paper, found '" + text + "'");
}

}  // namespace rinceau

#include "cli/weights_option.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <string_view>

#include <CLI/Error.hpp>

namespace rinceau {
namespace {

constexpr double largest_weight = 4;

struct WeightName {
    std::string_view name;
    double ImportanceWeights::*weight;
};

constexpr std::array<WeightName, 4> weight_names{{{"n", &ImportanceWeights::count},
                                                  {"h", &ImportanceWeights::nearness},
                                                  {"phi", &ImportanceWeights::similarity},
                                                  {"l", &ImportanceWeights::length}}};

[[noreturn]] void fail(const std::string& expected, std::string_view found) {
    throw CLI::ValidationError("--weights", "expected " + expected + ", found '" + std::string(found) + "'");
}

double parse_weight(std::string_view text, std::string_view part) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    if (!whole || !(value >= 0 && value <= largest_weight)) fail("a number from 0 to 4 after '='", part);
    return value;
}

}  // namespace

ImportanceWeights parse_weights(const std::string& text) {
    ImportanceWeights weights;
    std::set<std::string_view> seen;
    std::string_view rest = text;
    while (true) {
        const std::string_view part = rest.substr(0, rest.find(','));
        const std::string_view name = part.substr(0, part.find('='));
        const auto found = std::ranges::find(weight_names, name, &WeightName::name);
        if (name.size() == part.size() || found == weight_names.end()) fail("n=.., h=.., phi=.. or l=..", part);
        if (!seen.insert(name).second) fail("each weight once", part);
        weights.*(found->weight) = parse_weight(part.substr(name.size() + 1), part);
        if (part.size() == rest.size()) return weights;
        rest.remove_prefix(part.size() + 1);
    }
}

Objective parse_objective(const std::string& text) {
    if (text == "bits") return Objective::bits;
    if (text == "paper") return Objective::paper;
    throw CLI::ValidationError("--objective", "expected bits or paper, found '" + text + "'");
}

}  // namespace rinceau

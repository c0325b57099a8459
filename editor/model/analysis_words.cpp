#include "editor/model/analysis_words.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace rinceau {
namespace {

/// 41800 -> "41,800".
std::string counted(double number) {
    std::string digits = std::to_string(std::llround(number));
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

std::string counted(double number, const char* one, const char* many) {
    return counted(number) + ' ' + (number == 1 ? one : many);
}

std::string short_number(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", number);
    return text.data();
}

}  // namespace

std::string analysis_summary(const AnalysisReport& report) {
    const std::string elements = counted(report.elements, "element", "elements");
    if (report.productions.empty()) return elements + ": no rule says them in less than a list of them";
    return elements + " in " + counted(static_cast<double>(report.productions.size()), "rule", "rules") + ": " +
           counted(report.grammar_bits) + " bits instead of " + counted(report.drawing_bits);
}

std::string analysis_label(const AnalyzeOptions& before, const AnalyzeOptions& after) {
    std::vector<std::string> changes;
    const auto number = [&](double was, double is, const char* name) {
        if (was != is) changes.push_back(name + (' ' + short_number(is)));
    };
    const auto choice = [&](bool was, bool is, const char* on, const char* off) {
        if (was != is) changes.emplace_back(is ? on : off);
    };
    if (before.tolerance != after.tolerance)
        changes.push_back(after.tolerance == 0 ? "automatic tolerance" : "tolerance " + short_number(after.tolerance));
    number(before.similarity.tolerance, after.similarity.tolerance, "similarity");
    number(before.weights.count, after.weights.count, "count weight");
    number(before.weights.nearness, after.weights.nearness, "nearness weight");
    number(before.weights.similarity, after.weights.similarity, "similarity weight");
    number(before.weights.length, after.weights.length, "length weight");
    choice(before.similarity.mirrored_copies, after.similarity.mirrored_copies, "mirrored copies", "no mirrored copies");
    choice(before.objective == Objective::paper, after.objective == Objective::paper, "the paper's importance", "bits");
    choice(before.symmetrize, after.symmetrize, "the regular layout", "the layout as drawn");
    choice(before.stochastic, after.stochastic, "noise", "no noise");
    if (before.grouping != after.grouping) changes.emplace_back("groups made by hand");
    return changes.size() == 1 ? "analyse with " + changes.front() : "analyse";
}

std::string stage_in_words(std::string_view stage) {
    constexpr std::array<std::pair<std::string_view, const char*>, 6> words{{
        {"begin", "beginning"},
        {"similarity", "finding equal shapes"},
        {"overlaps", "finding what lies on what"},
        {"items", "weighing the elements"},
        {"rules", "finding rules"},
        {"check", "checking that the picture is the same"},
    }};
    for (const auto& [name, text] : words)
        if (name == stage) return text;
    return std::string(stage);
}

}  // namespace rinceau

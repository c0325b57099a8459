#include "cli/numbers_output.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

namespace rinceau {

namespace {

constexpr std::size_t lines_on_a_screen = 40;

std::string value_text(const GrammarNumber& number) {
    constexpr int digits = 6;
    std::array<char, 32> text{};
    const double value = number.value == 0 ? 0 : number.value;
    const auto end = number.whole
                         ? std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 0)
                         : std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

/// How many of the leading ranks fit.
NumberRank last_rank_that_fits(const std::vector<GrammarNumber>& numbers) {
    std::size_t lines = 0;
    NumberRank last = NumberRank::rule;
    for (const NumberRank rank :
         {NumberRank::rule, NumberRank::part, NumberRank::axiom, NumberRank::style, NumberRank::exception}) {
        lines += static_cast<std::size_t>(std::ranges::count(numbers, rank, &GrammarNumber::rank));
        if (lines > lines_on_a_screen && rank != NumberRank::rule) break;
        last = rank;
    }
    return last;
}

/// "40 of parts of rules, 12 of the axiom".
std::string left_out(const std::vector<GrammarNumber>& numbers, NumberRank last) {
    static const std::map<NumberRank, std::string> words{
        {NumberRank::part, "within rules"},       {NumberRank::axiom, "of the axiom"}, {NumberRank::style, "of styles"},
        {NumberRank::exception, "of exceptions"}, {NumberRank::detail, "others"},
    };
    std::string text;
    for (const auto& [rank, word] : words) {
        const auto count = std::ranges::count(numbers, rank, &GrammarNumber::rank);
        if (rank <= last || count == 0) continue;
        text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + word;
    }
    return text;
}

const char* kind_text(NumberKind kind) {
    constexpr std::array words{"count", "angle", "length", "scale", "style", "layer", "share", "seed", "other"};
    return words[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string numbers_text(const std::vector<GrammarNumber>& numbers, bool all) {
    const NumberRank last = all ? NumberRank::detail : last_rank_that_fits(numbers);
    std::vector<const GrammarNumber*> listed;
    for (const GrammarNumber& number : numbers)
        if (number.rank <= last) listed.push_back(&number);
    std::ranges::stable_sort(listed, {}, [](const GrammarNumber* number) { return number->rank; });
    std::size_t name_width = 0;
    std::size_t value_width = 0;
    for (const GrammarNumber* number : listed) {
        name_width = std::max(name_width, number->name.size());
        value_width = std::max(value_width, value_text(*number).size());
    }
    std::string text;
    for (const GrammarNumber* number : listed) {
        const std::string value = value_text(*number);
        text += number->name + std::string(name_width - number->name.size() + 2 + value_width - value.size(), ' ') + value;
        if (!number->unit.empty()) text += ' ' + number->unit;
        text += "  " + number->help;
        if (!number->written.empty()) text += " = " + number->written;
        text += '\n';
    }
    const std::string rest = left_out(numbers, last);
    if (!rest.empty()) text += "and " + rest + ": --all lists them\n";
    return text;
}

std::string numbers_json(const std::vector<GrammarNumber>& numbers) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const auto limit = [](double value) {
        return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
    };
    for (const GrammarNumber& number : numbers) {
        if (number.rank == NumberRank::hidden) continue;
        nlohmann::ordered_json entry{{"name", number.name},      {"value", number.value},          {"unit", number.unit},
                                     {"help", number.help},      {"kind", kind_text(number.kind)}, {"whole", number.whole},
                                     {"low", limit(number.low)}, {"high", limit(number.high)}};
        if (!number.written.empty()) entry["written"] = number.written;
        list.push_back(std::move(entry));
    }
    return nlohmann::ordered_json{{"schema", 1}, {"numbers", std::move(list)}}.dump(2) + '\n';
}

}  // namespace rinceau

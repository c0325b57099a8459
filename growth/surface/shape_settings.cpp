#include "growth/surface/shape_settings.h"

#include <algorithm>
#include <cmath>

#include "lsystem/number_text.h"

namespace rinceau {
namespace {

[[noreturn]] void fail(const ShapeSource& source, const std::string& expected, const std::string& found) {
    const std::string kind = source.kind.empty() ? "option" : source.kind;
    throw InputError(source.place, "the " + kind + " '" + source.name + "': expected " + expected + ", found " + found);
}

void check_names(const ShapeSource& source, const std::vector<NumberSetting>& numbers,
                 const std::vector<WordSetting>& words) {
    std::vector<std::string_view> known;
    for (const NumberSetting& n : numbers) known.push_back(n.name);
    for (const WordSetting& w : words) known.push_back(w.name);
    const auto check = [&](const std::string& name, bool is_number) {
        const bool number = std::ranges::find(numbers, name, &NumberSetting::name) != numbers.end();
        const bool word = std::ranges::find(words, name, &WordSetting::name) != words.end();
        if (!number && !word) fail(source, "a setting among " + listed(known), "'" + name + "'");
        if (is_number && !number) fail(source, "a word for " + name, "a number");
        if (!is_number && !word) fail(source, "a number for " + name, "a word");
    };
    for (const auto& [name, value] : source.numbers) check(name, true);
    for (const auto& [name, value] : source.words) check(name, false);
}

double checked_number(const ShapeSource& source, const NumberSetting& setting, double value) {
    const bool fits = value >= setting.low && value <= setting.high && (!setting.whole || std::floor(value) == value);
    if (!fits)
        fail(source,
             std::string(setting.whole ? "a whole number" : "a number") + " from " + number_text(setting.low) + " to " +
                 number_text(setting.high) + " for " + std::string(setting.name),
             std::isnan(value) ? "none" : number_text(value));
    return value;
}

}  // namespace

std::string listed(const std::vector<std::string_view>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += names[i];
    }
    return text;
}

SettingValues setting_values(const ShapeSource& source, const std::map<std::string, double>& values,
                             const std::vector<NumberSetting>& numbers, const std::vector<WordSetting>& words) {
    check_names(source, numbers, words);
    SettingValues result;
    for (const NumberSetting& setting : numbers) {
        const auto said = values.find(std::string(setting.name));
        result.numbers.emplace(setting.name,
                               said == values.end() ? setting.value : checked_number(source, setting, said->second));
    }
    for (const WordSetting& setting : words) {
        const auto said = source.words.find(std::string(setting.name));
        if (said == source.words.end()) {
            if (!setting.choices.empty()) result.words.emplace(setting.name, setting.choices.front());
            continue;
        }
        if (!setting.choices.empty() && std::ranges::find(setting.choices, said->second) == setting.choices.end())
            fail(source, listed(setting.choices) + " for " + std::string(setting.name), "'" + said->second + "'");
        result.words.emplace(setting.name, said->second);
    }
    return result;
}

}  // namespace rinceau

#pragma once
// What a source says, checked against what its kind knows.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "growth/surface/shape_grammar.h"

namespace rinceau {

struct NumberSetting {
    std::string_view name;
    double value = 0;  ///< unless the source says another
    double low = 0, high = 1;
    bool whole = false;
};

struct WordSetting {
    std::string_view name;
    std::vector<std::string_view> choices;  ///< the first unless the source says another; none: any text
};

struct SettingValues {
    std::map<std::string, double, std::less<>> numbers;     ///< all that the kind knows
    std::map<std::string, std::string, std::less<>> words;  ///< those with choices, and others that the source has

    double number(std::string_view name) const { return numbers.find(name)->second; }
    int whole(std::string_view name) const { return static_cast<int>(number(name)); }
};

/// "a, b or c"
std::string listed(const std::vector<std::string_view>& names);

/// Throws InputError at the source's place for a setting of another name, a number out of its range, an unknown word.
/// `values` are the evaluated numbers of the source.
SettingValues setting_values(const ShapeSource& source, const std::map<std::string, double>& values,
                             const std::vector<NumberSetting>& numbers, const std::vector<WordSetting>& words);

}  // namespace rinceau

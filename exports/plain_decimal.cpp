#include "exports/plain_decimal.h"

#include <array>
#include <charconv>
#include <cmath>

namespace rinceau {

std::string plain_decimal(double value, std::size_t longest) {
    std::array<char, 1100> buffer{};
    auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
    std::string text(buffer.data(), result.ptr);
    if (text.size() > longest) {
        const std::size_t point = text.find('.');
        const std::size_t whole = point == std::string::npos ? text.size() : point;
        const int decimals = whole + 1 < longest ? static_cast<int>(longest - whole - 1) : 0;
        result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
        text.assign(buffer.data(), result.ptr);
    }
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

}  // namespace rinceau

#include "lsystem/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace rinceau {

void append_number(std::string& text, double value) {
    if (value == 0) {
        text += '0';
        return;
    }
    // 100000 reads better than the shorter 1e+05
    const bool plain = std::abs(value) >= 1e-6 && std::abs(value) < 1e15;
    std::array<char, 64> buffer;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                      plain ? std::chars_format::fixed : std::chars_format::general);
    text.append(buffer.data(), result.ptr);
}

std::string number_text(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

bool is_name(std::string_view text) {
    return !text.empty() && starts_name(text.front()) && std::ranges::all_of(text, continues_name);
}

}  // namespace rinceau

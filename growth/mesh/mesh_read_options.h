#pragma once
// What all readers of meshes have in common: limits, and words of a line as numbers.

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace rinceau {

struct MeshReadOptions {
    std::string file_name;                   ///< for messages
    std::size_t max_positions = 10'000'000;  ///< more -> LimitError
    std::size_t max_triangles = 20'000'000;  ///< more -> LimitError
    std::size_t max_corners = 1000;          ///< of a face -> LimitError
    /// Positions keep the numbers that the file gives them, also where no face uses them. (Read from OBJ they are otherwise
    /// in order of their first use; OFF and PLY always keep them.)
    bool keep_numbers = false;
};

/// The next word of a line, and the line without it; empty at the line's end.
inline std::string_view take_word(std::string_view& line) {
    constexpr std::string_view blanks = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

/// The next line, and the text without it.
inline std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

/// Is the whole word this number?
template <class Number>
bool reads_whole(std::string_view word, Number& value) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end == word.data() + word.size();
}

}  // namespace rinceau

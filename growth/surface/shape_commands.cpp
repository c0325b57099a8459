#include "growth/surface/shape_commands.h"

#include <algorithm>
#include <array>

namespace rinceau {

namespace {

using Verb = ShapeVerb;
using Text = TextArgument;

constexpr std::array known_commands{
    ShapeCommandInfo{Verb::move, "T", Text::none, 1, 3, "T(x, y, z)",
                     "move by (x, y) over the surface, keeping the angle to the field, and by z along the normal"},
    ShapeCommandInfo{Verb::go_straight, "G", Text::none, 1, 3, "G(x, y, z)",
                     "the same along a straight line of the surface, a geodesic"},
    ShapeCommandInfo{Verb::size, "S", Text::none, 1, 3, "S(x, y, z)", "the scope's size; one number is all three"},
    ShapeCommandInfo{Verb::turn_x, "Rx", Text::none, 1, 1, "Rx(degrees)", "turn about the scope's X axis"},
    ShapeCommandInfo{Verb::turn_y, "Ry", Text::none, 1, 1, "Ry(degrees)", "turn about the scope's Y axis"},
    ShapeCommandInfo{Verb::turn_z, "Rz", Text::none, 1, 1, "Rz(degrees)",
                     "turn about the scope's Z axis; of an untilted scope: within the surface"},
    ShapeCommandInfo{Verb::place, "I", Text::needed, 0, 0, "I(\"shape\")", "place a shape in the scope"},
    ShapeCommandInfo{Verb::place_clear, "IC", Text::needed, 0, 0, "IC(\"shape\")",
                     "place a shape unless it would overlap one that is there"},
    ShapeCommandInfo{Verb::place_merged, "IM", Text::needed, 1, 2, "IM(\"shape\", distance, degrees)",
                     "place a shape unless its like is that near and turned at most so far; then the scope moves there"},
    ShapeCommandInfo{Verb::line, "Line", Text::none, 0, 1, "Line(merge)",
                     "begin a line; with merge = 1 it ends where it meets another"},
    ShapeCommandInfo{Verb::line_segment, "LineSeg", Text::none, 2, 2, "LineSeg(length, width)",
                     "a piece of the line along X, as T(length, 0, 0) goes"},
    ShapeCommandInfo{Verb::colour, "Colour", Text::instead, 1, 3, "Colour(n) or Colour(\"#rrggbb\")",
                     "colour of what follows: of the palette by number, three numbers from 0 to 255, or a text"},
    ShapeCommandInfo{Verb::attribute, "Set", Text::needed, 1, 1, "Set(\"name\", value)",
                     "give what is placed from here on a number of its own"},
    ShapeCommandInfo{Verb::lock, "Lock", Text::none, 0, 0, "Lock{a | b}",
                     "parts that are placed all or none, tested as one"},
    ShapeCommandInfo{Verb::chart, "Chart", Text::none, 0, 0, "Chart{a}",
                     "moves inside go through one map of the surroundings, so that rings close"},
};

constexpr std::array<std::string_view, 5> statement_words{"param", "shape", "field", "option", "axiom"};

std::string counted(int number) { return std::to_string(number) + (number == 1 ? " number" : " numbers"); }

}  // namespace

std::span<const ShapeCommandInfo> shape_commands() { return known_commands; }

const ShapeCommandInfo* find_shape_command(std::string_view word) {
    if (word == "Color") word = "Colour";
    const auto* found = std::ranges::find(known_commands, word, &ShapeCommandInfo::word);
    return found == known_commands.end() ? nullptr : found;
}

const ShapeCommandInfo& shape_command(ShapeVerb verb) {
    return *std::ranges::find(known_commands, verb, &ShapeCommandInfo::verb);
}

std::optional<std::string> wrong_arguments(const ShapeCommandInfo& info, const ShapeCommand& command) {
    const auto found = static_cast<int>(command.arguments.size());
    const bool has_text = command.has_text;
    const auto wrong = [&](const std::string& expected, const std::string& instead) {
        return "expected " + expected + " for " + std::string(info.form) + ", found " + instead;
    };
    if (info.text == Text::needed && !has_text) return wrong("a text in quotation marks", "none");
    if (info.text == Text::none && has_text) return wrong("numbers", "a text");
    if (info.text == Text::instead && has_text) {
        if (found > 0) return wrong("a text or numbers", "both");
        return std::nullopt;
    }
    const bool one_or_three = info.verb == Verb::colour || info.verb == Verb::size;
    if (found >= info.fewest && found <= info.most && !(one_or_three && found == 2)) return std::nullopt;
    const std::string range =
        info.fewest == info.most ? counted(info.fewest) : std::to_string(info.fewest) + " to " + counted(info.most);
    return wrong(one_or_three ? "1 or 3 numbers" : range, std::to_string(found));
}

bool is_statement_word(std::string_view word) { return std::ranges::find(statement_words, word) != statement_words.end(); }

bool is_reserved_word(std::string_view word) { return find_shape_command(word) != nullptr || is_statement_word(word); }

}  // namespace rinceau

#pragma once
// The commands of shape grammars as data (Li et al. 2010, sections 3.3 and 3.4).

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "growth/surface/shape_grammar.h"

namespace rinceau {

enum class TextArgument : unsigned char { none, needed, instead };  ///< instead: of the numbers

/// One command. It takes `fewest` to `most` numbers, behind its text if it needs one.
struct ShapeCommandInfo {
    ShapeVerb verb;
    std::string_view word;
    TextArgument text;
    int fewest;
    int most;
    std::string_view form;  ///< with its arguments, as a person would write it
    std::string_view help;
};

/// All but [ ] and symbols.
std::span<const ShapeCommandInfo> shape_commands();
/// nullptr if no command has that name.
const ShapeCommandInfo* find_shape_command(std::string_view word);
const ShapeCommandInfo& shape_command(ShapeVerb verb);
/// What is wrong with the number of its arguments: "expected 3 numbers for S, found 2".
std::optional<std::string> wrong_arguments(const ShapeCommandInfo& info, const ShapeCommand& command);

/// param shape field option axiom: what statements begin with.
bool is_statement_word(std::string_view word);

/// Those and all commands: no symbol may be called so.
bool is_reserved_word(std::string_view word);

}  // namespace rinceau

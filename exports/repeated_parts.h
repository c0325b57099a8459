#pragma once
// A long string of parts, some in brackets, written shortly: what comes again gets a name (Larsson & Moffat 2000, Re-Pair,
// with brackets kept whole). Internal to the folder.

#include <string>
#include <vector>

namespace rinceau {

/// A string with brackets as a directed graph without circles: numbers below `atoms.size()` are atoms, the others stand for
/// brackets, whose contents are `groups[number - atoms.size()]`. Equal brackets have the same number.
struct BracketedString {
    std::vector<std::string> atoms;
    std::vector<std::vector<int>> groups;
    std::vector<int> whole;
};

/// name = text, and the name of the whole. A text refers to names by their single characters.
struct NamedPart {
    char name = 0;
    std::string text;
    std::vector<std::string> pieces;  ///< of the text, between which a line may end
    int depth = 1;                    ///< rounds of replacing until no name is left
};

/// Names parts where that makes the text shorter, at most one for each of `names`; the whole is the last part and has the
/// last name.
std::vector<NamedPart> named_parts(const BracketedString& string, const std::string& names);

}  // namespace rinceau

#pragma once
// The lines of a grammar's text as statements with their comments. Internal to lsystem and growth.

#include <string>
#include <string_view>
#include <vector>

#include "scene/input_error.h"

namespace rinceau {

/// A line that begins at the margin with the indented lines below it. Comments are blanks in `text`, so that places in it
/// are places in the file.
struct Statement {
    std::string text;
    SourcePlace place;     ///< of the first character
    std::string comment;   ///< the comment lines right before it, then those behind its own lines
    std::string verbatim;  ///< what stands between <<<TAG and TAG, without the last line end
    bool has_verbatim = false;
};

struct StatementList {
    std::vector<Statement> statements;
    std::vector<std::string> comments;  ///< comment lines that belong to no statement: an empty line follows them
    std::vector<Warning> faults;        ///< what cannot be a statement
};

StatementList split_statements(std::string_view text, const std::string& file_name);

/// An offset in a text with the line that it is in.
struct PlaceInText {
    std::size_t offset = 0;
    std::size_t line_start = 0;
    int lines_before = 0;
};

/// The place of an offset, found from that of another in time proportional to the way forward (to the whole way from the
/// start, for one that lies before).
PlaceInText place_after(PlaceInText from, std::string_view text, std::size_t offset);

SourcePlace place_in(const Statement& statement, const PlaceInText& place);

/// The lines of a comment; none for an empty one.
std::vector<std::string> comment_lines(const std::string& comment);

/// A line of one as it stands in a text: behind a #, ended.
std::string comment_line(const std::string& line);

/// Its lines as they stand in a text.
std::string commented(const std::string& comment);

/// In double quotes, with the escapes that Scanner::quoted() reads.
std::string in_quotes(const std::string& value);

}  // namespace rinceau

#include "lsystem/statement.h"

#include <algorithm>

#include "lsystem/number_text.h"

namespace rinceau {

PlaceInText place_after(PlaceInText from, std::string_view text, std::size_t offset) {
    if (offset < from.offset) from = {};
    for (; from.offset < offset; ++from.offset) {
        if (text[from.offset] != '\n') continue;
        ++from.lines_before;
        from.line_start = from.offset + 1;
    }
    return from;
}

SourcePlace place_in(const Statement& statement, const PlaceInText& place) {
    return {statement.place.file, statement.place.line + place.lines_before,
            static_cast<int>(place.offset - place.line_start) + 1};
}

std::vector<std::string> comment_lines(const std::string& comment) {
    std::vector<std::string> lines;
    if (comment.empty()) return lines;
    std::size_t start = 0;
    for (std::size_t end = comment.find('\n'); end != std::string::npos; end = comment.find('\n', start)) {
        lines.push_back(comment.substr(start, end - start));
        start = end + 1;
    }
    lines.push_back(comment.substr(start));
    return lines;
}

namespace {

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0) text += '\n';
        text += lines[i];
    }
    return text;
}

/// "# text" -> "text"
std::string without_sign(std::string_view comment) {
    comment.remove_prefix(1);
    if (comment.starts_with(' ')) comment.remove_prefix(1);
    return std::string(comment);
}

class Splitter {
  public:
    Splitter(std::string_view text, const std::string& file_name) : text_(text), file_name_(file_name) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
    }

    StatementList split() {
        while (at_ < text_.size()) {
            const std::string_view line = next_line();
            const std::size_t indent = line.find_first_not_of(" \t");
            if (indent == std::string_view::npos) {
                loosen_comments();
                open_ = false;
            } else if (line[indent] == '#' && (indent == 0 || !in_string_)) {
                pass_comment(line.substr(indent), indent);
            } else if (indent > 0 && open_) {
                result_.statements.back().text += '\n';
                add_line(line);
            } else {
                begin_statement(line, indent);
            }
        }
        loosen_comments();
        return std::move(result_);
    }

  private:
    std::string_view text_;
    std::string file_name_;
    std::size_t at_ = 0;
    int line_number_ = 0;
    bool open_ = false;  // indented lines continue the last statement
    bool in_string_ = false;
    std::vector<std::string> pending_;  // comment lines that wait for their statement
    StatementList result_;

    std::string_view next_raw_line() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1;
        ++line_number_;
        return line;
    }
    std::string_view next_line() {
        std::string_view line = next_raw_line();
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    void loosen_comments() {
        result_.comments.insert(result_.comments.end(), pending_.begin(), pending_.end());
        pending_.clear();
    }

    void pass_comment(std::string_view comment, std::size_t indent) {
        if (indent > 0 && open_) {
            result_.statements.back().text += '\n';
            add_comment(result_.statements.back(), comment);
        } else {
            pending_.push_back(without_sign(comment));
            open_ = false;
        }
    }

    static void add_comment(Statement& statement, std::string_view comment) {
        if (!statement.comment.empty()) statement.comment += '\n';
        statement.comment += without_sign(comment);
    }

    void begin_statement(std::string_view line, std::size_t indent) {
        in_string_ = false;
        if (indent > 0) {
            result_.faults.push_back({{file_name_, line_number_, static_cast<int>(indent) + 1},
                                      "expected a statement at the margin, found an indented line that continues none"});
        }
        Statement statement;
        statement.place = {file_name_, line_number_, 1};
        statement.comment = joined(pending_);
        pending_.clear();
        result_.statements.push_back(std::move(statement));
        open_ = true;
        add_line(line);
        if (indent > 0) result_.statements.pop_back();
        if (indent > 0) open_ = false;
    }

    /// Adds a line to the last statement: blanks for its comment, and what stands between <<<TAG and TAG.
    void add_line(std::string_view line) {
        Statement& statement = result_.statements.back();
        for (std::size_t i = 0; i < line.size(); ++i) {
            const char c = line[i];
            if (c == '"' && !(in_string_ && is_escaped(line, i))) in_string_ = !in_string_;
            if (!in_string_ && starts_comment(line, i)) {
                add_comment(statement, line.substr(i));
                return;
            }
            statement.text += c;
            if (!in_string_ && c == '<' && line.substr(i).starts_with("<<<")) {
                statement.text += line.substr(i + 1);
                read_verbatim(statement, line, i);
                return;
            }
        }
    }
    static bool is_escaped(std::string_view line, std::size_t at) {
        std::size_t strokes = 0;
        while (strokes < at && line[at - strokes - 1] == '\\') ++strokes;
        return strokes % 2 == 1;
    }
    /// A '#' between blanks; colours such as #ffcc00 are none.
    static bool starts_comment(std::string_view line, std::size_t at) {
        return line[at] == '#' && at > 0 && is_blank(line[at - 1]) && (at + 1 == line.size() || is_blank(line[at + 1]));
    }

    void read_verbatim(Statement& statement, std::string_view line, std::size_t marker) {
        std::string_view tag = line.substr(marker + 3);
        while (!tag.empty() && is_blank(tag.back())) tag.remove_suffix(1);
        const SourcePlace place{file_name_, line_number_, static_cast<int>(marker) + 1};
        open_ = false;
        if (!is_name(tag)) {
            result_.faults.push_back(
                {place, "expected a name at the end of the line after <<<, found '" + std::string(tag) + "'"});
            return;
        }
        statement.has_verbatim = true;
        bool first = true;
        while (at_ < text_.size()) {
            const std::string_view raw = next_raw_line();
            if (raw == tag || (raw.ends_with('\r') && raw.substr(0, raw.size() - 1) == tag)) return;
            if (!first) statement.verbatim += '\n';
            statement.verbatim += raw;
            first = false;
        }
        result_.faults.push_back(
            {place, "expected the line '" + std::string(tag) + "' that ends the fragment, found the end of the text"});
    }
};

}  // namespace

StatementList split_statements(std::string_view text, const std::string& file_name) {
    return Splitter(text, file_name).split();
}

std::string comment_line(const std::string& line) { return (line.empty() ? "#" : "# " + line) + '\n'; }

std::string commented(const std::string& comment) {
    std::string text;
    for (const std::string& line : comment_lines(comment)) text += comment_line(line);
    return text;
}

std::string in_quotes(const std::string& value) {
    std::string text = "\"";
    for (const char c : value) {
        constexpr std::string_view special = "\"\\\n\r\t";
        const std::size_t known = special.find(c);
        if (known == std::string_view::npos) {
            text += c;
        } else {
            text += '\\';
            text += "\"\\nrt"[known];
        }
    }
    return text + '"';
}

}  // namespace rinceau

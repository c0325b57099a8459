#include "growth/surface/shape_statements.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "growth/surface/shape_commands.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

struct OpenBracket {
    char kind;
    SourcePlace place;
};

char closing(char open) { return open == '(' ? ')' : open == '[' ? ']' : '}'; }

/// "# text" -> "text"
std::string without_sign(std::string_view comment) {
    comment.remove_prefix(std::min(comment.find_first_not_of('#'), comment.size()));
    if (comment.starts_with(' ')) comment.remove_prefix(1);
    return std::string(comment);
}

void append_line(std::string& text, const std::string& line) {
    if (!text.empty()) text += '\n';
    text += line;
}

/// Where the comment of a line begins, its size if there is none.
std::size_t comment_start(std::string_view line) {
    bool in_text = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') in_text = !in_text;
        if (line[i] == '#' && !in_text) return i;
    }
    return line.size();
}

/// Outside quotation marks.
bool has_rule_sign(std::string_view line) {
    bool in_text = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') in_text = !in_text;
        if (!in_text && (line.substr(i).starts_with(rule_sign) || line.substr(i).starts_with(rule_arrow))) return true;
    }
    return false;
}

bool begins_with_keyword(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos) return false;
    std::size_t end = start;
    while (end < line.size() && continues_name(line[end])) ++end;
    const std::string_view word = line.substr(start, end - start);
    return is_statement_word(word) && end < line.size() && is_blank(line[end]);
}

class ShapeSplitter {
  public:
    ShapeSplitter(std::string_view text, const std::string& file_name) : text_(text), file_name_(file_name) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
    }

    StatementList split() {
        while (at_ < text_.size()) add_line(next_line());
        end_statement();
        loosen_comments();
        return std::move(result_);
    }

  private:
    std::string_view text_;
    std::string file_name_;
    std::size_t at_ = 0;
    int line_number_ = 0;
    std::vector<OpenBracket> open_;
    std::vector<std::string> pending_;  // comment lines that wait for their statement
    StatementList result_;

    std::string_view next_line() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1;
        ++line_number_;
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    void loosen_comments() {
        result_.comments.insert(result_.comments.end(), pending_.begin(), pending_.end());
        pending_.clear();
    }

    void add_line(std::string_view line) {
        const std::size_t end = comment_start(line);
        const std::string_view content = line.substr(0, end);
        if (!open_.empty() && (begins_with_keyword(content) || has_rule_sign(content))) end_statement();
        const bool blank = content.find_first_not_of(" \t") == std::string_view::npos;
        if (!open_.empty()) {
            result_.statements.back().text += '\n';
        } else if (blank) {
            if (end == line.size()) loosen_comments();
            if (end < line.size()) pending_.push_back(without_sign(line.substr(end)));
            return;
        } else {
            begin_statement();
        }
        Statement& statement = result_.statements.back();
        statement.text += content;
        if (end < line.size()) append_line(statement.comment, without_sign(line.substr(end)));
        follow_brackets(content);
    }

    void begin_statement() {
        Statement statement;
        statement.place = {file_name_, line_number_, 1};
        for (const std::string& line : pending_) append_line(statement.comment, line);
        pending_.clear();
        result_.statements.push_back(std::move(statement));
    }

    void end_statement() {
        if (!open_.empty()) {
            result_.statements.pop_back();
            std::string message = "expected a '";
            message += closing(open_.back().kind);
            message += "' for this '";
            message += open_.back().kind;
            message += "', found none before the next statement";
            result_.faults.push_back({open_.back().place, std::move(message)});
        }
        open_.clear();
    }

    void follow_brackets(std::string_view content) {
        bool in_text = false;
        std::size_t text_start = 0;
        for (std::size_t i = 0; i < content.size(); ++i) {
            const char c = content[i];
            if (c == '"') {
                in_text = !in_text;
                text_start = i;
            }
            if (in_text) continue;
            if (c == '(' || c == '[' || c == '{') open_.push_back({c, {file_name_, line_number_, static_cast<int>(i) + 1}});
            // a bracket that closes none, or another kind, is for the parser to name
            if ((c == ')' || c == ']' || c == '}') && !open_.empty()) open_.pop_back();
        }
        if (!in_text) return;
        result_.statements.pop_back();
        open_.clear();
        result_.faults.push_back({{file_name_, line_number_, static_cast<int>(text_start) + 1},
                                  "expected a closing quotation mark for this one, found the end of the line"});
    }
};

}  // namespace

StatementList split_shape_statements(std::string_view text, const std::string& file_name) {
    return ShapeSplitter(text, file_name).split();
}

}  // namespace rinceau

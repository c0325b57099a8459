#include "lsystem/parse_text.h"

#include <algorithm>
#include <utility>

#include "lsystem/mistakes.h"
#include "lsystem/statement.h"

namespace rinceau {

ParseState parse_text(std::string_view text, const std::string& file_name) {
    StatementList list = split_statements(text, file_name);
    ParseState state;
    for (const Statement& statement : list.statements) {
        if (state.mistakes.size() == max_mistakes) break;
        parse_statement(statement, state);
    }
    if (!state.versioned && list.faults.empty()) {
        add_mistake(state.mistakes, {file_name, 1, 1}, "expected 'lsystem 1' as the first statement, found an empty text");
    }
    state.mistakes.insert(state.mistakes.end(), list.faults.begin(), list.faults.end());
    std::ranges::stable_sort(state.mistakes, [](const Warning& a, const Warning& b) {
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    std::vector<std::string>& comments = state.grammar.comments;
    comments.insert(comments.begin(), list.comments.begin(), list.comments.end());
    return state;
}

}  // namespace rinceau

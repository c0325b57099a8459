#pragma once
// Reads a statement of a grammar's text piece by piece. Internal to the folder.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/statement.h"

namespace rinceau {

/// Every function skips blanks first and throws InputError with what was expected and what was found.
class Scanner {
  public:
    explicit Scanner(const Statement& statement) : statement_(statement), text_(statement.text) {}

    bool at_end();
    bool peek(std::string_view token);
    bool take(std::string_view token);
    void expect(std::string_view token);
    void expect_end(std::string_view otherwise);
    /// A letter or underscore, then letters, digits, underscores.
    std::string name(std::string_view what);
    /// Small letters and hyphens: the name of a property.
    std::string property();
    /// Everything up to a blank, ',', ';' or ')'.
    std::string word();
    double number();
    int integer(std::string_view what);
    std::uint64_t large_integer(std::string_view what);
    /// A name that stands there next, without passing it; empty if there is none.
    std::string_view peek_name();
    /// "..." with the escapes \" \\ \n \r \t; a line end and the blanks around it are one blank.
    std::string quoted();
    /// "..." as it stands; `start` becomes the place in the statement of its first character.
    std::string_view raw_quoted(std::size_t& start);
    Expression expression_until(std::string_view stops);
    /// An expression up to "->".
    Expression condition();
    /// Modules up to one of `stops`, or else to the end of the statement.
    std::vector<ModuleTemplate> modules(std::string_view stops = {});

    std::size_t position();
    SourcePlace place();
    /// Of an offset in the statement's text; for rising offsets the whole text is read through once.
    SourcePlace place_at(std::size_t position);
    [[noreturn]] void fail(std::string_view expected);
    const Statement& statement() const { return statement_; }

  private:
    const Statement& statement_;
    std::string_view text_;
    std::size_t at_ = 0;
    PlaceInText last_place_;

    void skip_blanks();
    std::string found() const;
    ModuleTemplate module();
};

}  // namespace rinceau

#pragma once
// Reads a statement of a grammar's text piece by piece. Internal to lsystem and growth.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/statement.h"

namespace rinceau {

/// Every function skips blanks first and throws InputError with what was expected and what was found. Mistakes that the
/// rest of the statement can be read in spite of are kept in `mistakes` instead.
class Scanner {
  public:
    Scanner(const Statement& statement, std::vector<Warning>& mistakes)
        : statement_(statement), text_(statement.text), mistakes_(mistakes) {}

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
    /// As much as makes an expression.
    Expression expression_here(const ExpressionForm& form);
    /// The number 1 takes the place of an expression with a mistake, which is kept.
    Expression expression_until(std::string_view stops);
    /// An expression up to "->", in the same way.
    Expression condition();
    /// Modules up to one of `stops`, or else to the end of the statement. What is none is a mistake, which is kept.
    std::vector<ModuleTemplate> modules(std::string_view stops = {});

    /// Reads a piece; if that fails, keeps the mistake and passes over the text up to the next ';' that is in no string.
    template <class Read>
    void piece(Read read) {
        const std::size_t start = position();
        const PlaceInText place = last_place_;
        try {
            read();
        } catch (const InputError& error) {
            keep(error);
            at_ = start;
            last_place_ = place;
            skip_piece();
        }
    }
    /// Keeps a mistake; throws it if there are so many that reading is given up.
    void keep(const InputError& error);
    std::size_t mistakes() const { return mistakes_.size(); }
    /// Passes over the text up to the token; false, and to the end, if there is none.
    bool skip_to(std::string_view token);

    std::size_t position();
    /// Back to an offset that position() gave.
    void go_to(std::size_t position) { at_ = position; }
    SourcePlace place();
    /// Of an offset in the statement's text; for rising offsets the whole text is read through once.
    SourcePlace place_at(std::size_t position);
    [[noreturn]] void fail(std::string_view expected);
    const Statement& statement() const { return statement_; }

  private:
    const Statement& statement_;
    std::string_view text_;
    std::vector<Warning>& mistakes_;
    std::size_t at_ = 0;
    PlaceInText last_place_;

    void skip_blanks();
    std::string found() const;
    Expression expression_or_one(std::string_view text, std::size_t start);
    ModuleTemplate module();
    void read_arguments(ModuleTemplate& module);
    void skip_what_begins_no_module(std::string_view stops);
    void skip_piece();
};

}  // namespace rinceau

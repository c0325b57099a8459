#include "growth/surface/parse_shape_commands.h"

#include <string>

#include "growth/surface/shape_commands.h"
#include "growth/surface/shape_statements.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

constexpr int max_nesting = 100;  // of [ ] and { }: keeps the call stack small whatever the text

bool is_stop(Scanner& scanner, std::string_view stops) {
    for (std::size_t i = 0; i < stops.size(); ++i)
        if (scanner.peek(stops.substr(i, 1))) return true;
    return false;
}

class CommandParser {
  public:
    explicit CommandParser(Scanner& scanner) : scanner_(scanner) {}

    std::vector<ShapeCommand> commands(std::string_view stops) {
        std::vector<ShapeCommand> result;
        std::vector<SourcePlace> open;
        while (!scanner_.at_end() && !is_stop(scanner_, stops)) {
            if (scanner_.peek("]") && open.empty()) scanner_.fail("a command; no '[' is open here");
            result.push_back(command());
            if (result.back().verb == ShapeVerb::push) open.push_back(result.back().place);
            if (result.back().verb == ShapeVerb::pop) open.pop_back();
            if (open.size() > max_nesting)
                scanner_.fail("at most " + std::to_string(max_nesting) + " brackets in each other");
        }
        if (!open.empty()) throw InputError(open.back(), "expected a ']' for this '[', found none");
        return result;
    }

  private:
    Scanner& scanner_;
    int nesting_ = 0;

    ShapeCommand command() {
        ShapeCommand result;
        result.place = scanner_.place();
        if (scanner_.take("[")) {
            result.verb = ShapeVerb::push;
        } else if (scanner_.take("]")) {
            result.verb = ShapeVerb::pop;
        } else {
            if (scanner_.peek("{")) scanner_.fail("Lock or Chart before a '{'");
            named(result);
        }
        return result;
    }

    void named(ShapeCommand& command) {
        const std::string word = scanner_.name("a command or a symbol");
        if (is_statement_word(word)) {
            throw InputError(command.place, "expected a command or a symbol, found the keyword '" + word + "'");
        }
        const ShapeCommandInfo* info = find_shape_command(word);
        command.verb = info != nullptr ? info->verb : ShapeVerb::symbol;
        if (info == nullptr) command.name = word;
        if (command.verb == ShapeVerb::lock || command.verb == ShapeVerb::chart) {
            groups(command);
            return;
        }
        if (scanner_.take("(")) arguments(command);
        if (info == nullptr) {
            if (command.has_text)
                throw InputError(command.place, "expected numbers for the symbol " + word + ", found a text");
        } else if (const auto wrong = wrong_arguments(*info, command)) {
            scanner_.keep(InputError(command.place, *wrong));
        }
    }

    void arguments(ShapeCommand& command) {
        if (scanner_.take(")")) return;
        if (scanner_.peek("\"")) {
            command.text = scanner_.quoted();
            command.has_text = true;
            if (scanner_.take(")")) return;
            if (!scanner_.take(",")) scanner_.fail("',' or ')'");
        }
        do {
            if (scanner_.peek("\"")) scanner_.fail("a number: a text comes first");
            command.arguments.push_back(parse_shape_expression(scanner_));
        } while (scanner_.take(","));
        if (!scanner_.take(")")) scanner_.fail("',' or ')'");
    }

    void groups(ShapeCommand& command) {
        const bool many = command.verb == ShapeVerb::lock;
        if (!scanner_.take("{")) scanner_.fail(many ? "'{' as in Lock{A | B}" : "'{' as in Chart{A}");
        if (++nesting_ > max_nesting) scanner_.fail("at most " + std::to_string(max_nesting) + " braces in each other");
        do {
            command.groups.push_back(commands(many ? "|}" : "}"));
        } while (many && scanner_.take("|"));
        --nesting_;
        if (!scanner_.take("}")) scanner_.fail(many ? "'|' or '}'" : "'}'");
    }
};

}  // namespace

Expression parse_shape_expression(Scanner& scanner) { return scanner.expression_here({.queries = true}); }

std::vector<ShapeCommand> parse_shape_commands(Scanner& scanner, std::string_view stops) {
    return CommandParser(scanner).commands(stops);
}

}  // namespace rinceau

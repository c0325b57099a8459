#include "lsystem/parse_statement.h"

#include <algorithm>
#include <array>

#include "lsystem/number_text.h"
#include "lsystem/parse_production.h"
#include "lsystem/scanner.h"
#include "lsystem/style_text.h"
#include "lsystem/turtle_commands.h"
#include "scene/svg_path_data.h"

namespace rinceau {

namespace {

/// Comments before what keeps none of its own go to the top of the grammar.
void keep_comment(const Statement& statement, Grammar& grammar) {
    const std::vector<std::string> lines = comment_lines(statement.comment);
    grammar.comments.insert(grammar.comments.end(), lines.begin(), lines.end());
}

void once(ParseState& state, const std::string& what, const SourcePlace& place) {
    const auto [first, added] = state.lines.try_emplace(what, place.line);
    if (added) return;
    throw InputError(
        place, "expected '" + what + "' once, found it again (the first is in line " + std::to_string(first->second) + ")");
}

void parse_version(Scanner& scanner, ParseState& state) {
    once(state, "lsystem", scanner.statement().place);
    const SourcePlace place = scanner.place();
    const int version = scanner.integer("the version 1 of the format");
    if (version != 1) throw InputError(place, "expected the version 1 of the format, found " + std::to_string(version));
    scanner.expect_end("the end of the line");
    keep_comment(scanner.statement(), state.grammar);
}

void parse_title(Scanner& scanner, ParseState& state) {
    once(state, "title", scanner.statement().place);
    state.grammar.title = scanner.quoted();
    scanner.expect_end("the end of the line after the title");
    keep_comment(scanner.statement(), state.grammar);
}

/// canvas x y width height | canvas corners left top right bottom | canvas none; then perhaps "unsized".
void parse_canvas(Scanner& scanner, ParseState& state) {
    once(state, "canvas", scanner.statement().place);
    Box& canvas = state.grammar.canvas;
    if (!scanner.take("none")) {
        const bool corners = scanner.take("corners");
        const double left = scanner.number();
        const double top = scanner.number();
        const SourcePlace place = scanner.place();
        const double third = scanner.number();
        const double fourth = scanner.number();
        const double right = corners ? third : left + third;
        const double bottom = corners ? fourth : top + fourth;
        if (!(right >= left && bottom >= top)) throw InputError(place, "expected a width and a height that are not below 0");
        canvas = {{left, 0 - bottom}, {right, 0 - top}};
    }
    if (scanner.take("unsized")) state.grammar.sized = false;
    scanner.expect_end("'unsized' or the end of the line");
    keep_comment(scanner.statement(), state.grammar);
}

void parse_define(Scanner& scanner, ParseState& state) {
    Constant constant;
    constant.place = scanner.place();
    constant.name = scanner.name("the name of a constant");
    scanner.expect("=");
    constant.value = scanner.expression_until("");
    constant.comment = scanner.statement().comment;
    once(state, "define " + constant.name, constant.place);
    state.grammar.constants.push_back(std::move(constant));
}

void parse_axiom(Scanner& scanner, ParseState& state) {
    once(state, "axiom", scanner.statement().place);
    scanner.expect(":");
    state.grammar.axiom = scanner.modules();
    keep_comment(scanner.statement(), state.grammar);
}

void parse_exception(Scanner& scanner, ParseState& state) {
    Exception exception;
    exception.place = scanner.statement().place;
    do {
        const SourcePlace place = scanner.place();
        exception.address.push_back(scanner.integer("an address such as 1.2.3"));
        if (exception.address.back() < 1) throw InputError(place, "expected numbers from 1 in an address, found 0");
    } while (scanner.take("."));
    scanner.expect("->");
    exception.successor = scanner.modules();
    exception.comment = scanner.statement().comment;
    state.grammar.exceptions.push_back(std::move(exception));
}

void parse_numbered_style(Scanner& scanner, ParseState& state) {
    NumberedStyle style;
    style.place = scanner.place();
    style.number = scanner.integer("the number of a style, from 1");
    if (style.number < 1) throw InputError(style.place, "expected the number of a style, from 1, found 0");
    scanner.expect(":");
    style.style = parse_style(scanner);
    style.comment = scanner.statement().comment;
    once(state, "style " + std::to_string(style.number), style.place);
    state.grammar.styles.push_back(std::move(style));
}

std::vector<Path> parse_outline(Scanner& scanner) {
    std::size_t start = 0;
    const std::string_view data = scanner.raw_quoted(start);
    ParsedPath parsed = parse_path_data(data);
    if (parsed.faulty) {
        throw InputError(scanner.place_at(start + std::min(parsed.fault_at, data.size())),
                         "expected " + parsed.fault + " in path data");
    }
    return transformed(parsed.paths, Affine{1, 0, 0, -1, 0, 0});
}

void parse_terminal_part(Scanner& scanner, Terminal& terminal, bool& whole) {
    const SourcePlace place = scanner.place();
    const std::string part = scanner.property();
    if (part == "style") {
        terminal.style = scanner.integer("the number of a style");
    } else if (part == "path") {
        const std::vector<Path> paths = parse_outline(scanner);
        terminal.paths.insert(terminal.paths.end(), paths.begin(), paths.end());
    } else if (part == "id") {
        terminal.id = scanner.quoted();
    } else if (part == "box") {
        const double left = scanner.number();
        const double top = scanner.number();
        const double right = scanner.number();
        const double bottom = scanner.number();
        if (right < left || bottom < top)
            throw InputError(place, "expected a box as left top right bottom, found its sides crossed");
        terminal.verbatim_box = {{left, 0 - bottom}, {right, 0 - top}};
    } else if (part == "verbatim") {
        scanner.expect("<<<");
        scanner.name("a name such as SVG that ends the fragment");
        terminal.verbatim = scanner.statement().verbatim;
        whole = true;
    } else {
        throw InputError(place, "expected style, path, id, box or verbatim, found '" + part + "'");
    }
}

void parse_terminal(Scanner& scanner, ParseState& state) {
    Terminal terminal;
    terminal.place = scanner.place();
    terminal.symbol = scanner.name("the symbol of a terminal");
    if (find_turtle_command(terminal.symbol) != nullptr) {
        throw InputError(terminal.place, "expected a symbol of your own, found the command '" + terminal.symbol + "'");
    }
    scanner.expect(":");
    bool whole = false;
    while (!scanner.at_end() && !whole) {
        parse_terminal_part(scanner, terminal, whole);
        if (!whole && !scanner.take(";")) scanner.expect_end("';' before the next part of the terminal");
    }
    scanner.expect_end("the end of the line after <<<");
    terminal.comment = scanner.statement().comment;
    once(state, "terminal " + terminal.symbol, terminal.place);
    state.grammar.terminals.push_back(std::move(terminal));
}

void parse_production_statement(Scanner& scanner, ParseState& state) {
    state.grammar.productions.push_back(parse_production(scanner));
}

void parse_seed(Scanner& scanner, ParseState& state) {
    once(state, "seed", scanner.statement().place);
    state.grammar.seed = scanner.large_integer("a whole number from 0 to 18446744073709551615");
    scanner.expect_end("the end of the line after the seed");
    keep_comment(scanner.statement(), state.grammar);
}

/// use "FILE" | use "FILE" as NAME
void parse_use(Scanner& scanner, ParseState& state) {
    Use use;
    use.place = scanner.place();
    use.file = scanner.quoted();
    if (use.file.empty()) throw InputError(use.place, "expected the name of a grammar's file, found an empty one");
    if (scanner.peek_name() == "as" && scanner.take("as"))
        use.prefix = scanner.name("a name that is put before those of the file, as in 'as vine'");
    scanner.expect_end("'as' and a name, or the end of the line");
    use.comment = scanner.statement().comment;
    state.grammar.uses.push_back(std::move(use));
}

void parse_ignore(Scanner& scanner, ParseState& state) {
    do {
        const SourcePlace place = scanner.place();
        const std::string symbol = scanner.name("a symbol that contexts look past (commands are looked past always)");
        if (find_turtle_command(symbol) != nullptr) {
            throw InputError(place, "expected a symbol of your own, found the command '" + symbol +
                                        "': contexts look past commands always, leave it out");
        }
        once(state, "ignore " + symbol, place);
        state.grammar.ignored.push_back(symbol);
    } while (!scanner.at_end());
    keep_comment(scanner.statement(), state.grammar);
}

struct StatementKind {
    std::string_view word;
    void (*parse)(Scanner&, ParseState&);
};

constexpr std::array kinds{
    StatementKind{"lsystem", parse_version},
    StatementKind{"title", parse_title},
    StatementKind{"canvas", parse_canvas},
    StatementKind{"define", parse_define},
    StatementKind{"axiom", parse_axiom},
    StatementKind{"except", parse_exception},
    StatementKind{"style", parse_numbered_style},
    StatementKind{"terminal", parse_terminal},
    StatementKind{"seed", parse_seed},
    StatementKind{"use", parse_use},
    StatementKind{"ignore", parse_ignore},
};

constexpr auto words_of_kinds() {
    std::array<std::string_view, kinds.size() + 2> words;
    for (std::size_t i = 0; i < kinds.size(); ++i) words[i] = kinds[i].word;
    words[kinds.size()] = decomposition_word;
    words[kinds.size() + 1] = homomorphism_word;
    return words;
}
constexpr std::array words = words_of_kinds();

std::string_view first_name(std::string_view text) {
    const auto end = std::ranges::find_if_not(text, continues_name);
    return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

}  // namespace

std::span<const std::string_view> statement_words() { return words; }

void parse_statement(const Statement& statement, ParseState& state) {
    Scanner scanner(statement);
    const auto kind = std::ranges::find(kinds, first_name(statement.text), &StatementKind::word);
    const bool is_version = kind == kinds.begin();
    if (!state.versioned && !is_version) {
        state.versioned = true;  // said once
        throw InputError(statement.place, "expected 'lsystem 1' as the first statement, found '" +
                                              statement.text.substr(0, statement.text.find('\n')) + "'");
    }
    state.versioned = true;
    if (statement.has_verbatim && (kind == kinds.end() || kind->word != "terminal")) {
        throw InputError(statement.place, "expected a fragment <<< in a terminal only");
    }
    if (kind == kinds.end()) return parse_production_statement(scanner, state);
    scanner.expect(kind->word);
    kind->parse(scanner, state);
}

}  // namespace rinceau

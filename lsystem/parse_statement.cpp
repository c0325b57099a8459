#include "lsystem/parse_statement.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "lsystem/mistakes.h"
#include "lsystem/number_text.h"
#include "lsystem/parse_production.h"
#include "lsystem/scanner.h"
#include "lsystem/similar_name.h"
#include "lsystem/style_text.h"
#include "lsystem/turtle_commands.h"
#include "scene/svg_path_data.h"

namespace rinceau {

namespace {

constexpr std::size_t longest_found = 40;  // enough to recognise it

/// Every name in front of "->".
void add_names(std::string_view text, std::set<std::string>& names) {
    constexpr std::size_t far_enough = 10000;  // a longer statement is no production
    text = text.substr(0, std::min(text.find("->"), far_enough));
    for (std::size_t start = 0; start < text.size();) {
        std::size_t end = start;
        while (end < text.size() && continues_name(text[end])) ++end;
        if (end > start) names.emplace(text.substr(start, end - start));
        start = end + 1;
    }
}

/// Comments before what keeps none of its own go to the top of the grammar.
void keep_comment(const Statement& statement, Grammar& grammar) {
    const std::vector<std::string> lines = comment_lines(statement.comment);
    grammar.comments.insert(grammar.comments.end(), lines.begin(), lines.end());
}

/// False, and a mistake, if it stood before.
bool once(Scanner& scanner, ParseState& state, const std::string& what, const SourcePlace& place) {
    const auto [first, added] = state.first_places.try_emplace(what, place);
    if (added) return true;
    scanner.keep(InputError(place, "expected '" + what + "' once, found it again (the first is in line " +
                                       std::to_string(first->second.line) + "): take one of them away"));
    return false;
}

void parse_version(Scanner& scanner, ParseState& state) {
    once(scanner, state, "lsystem", scanner.statement().place);
    const SourcePlace place = scanner.place();
    const int version = scanner.integer("the version 1 of the format");
    if (version != 1) throw InputError(place, "expected the version 1 of the format, found " + std::to_string(version));
    scanner.expect_end("the end of the line");
    keep_comment(scanner.statement(), state.grammar);
}

void parse_title(Scanner& scanner, ParseState& state) {
    once(scanner, state, "title", scanner.statement().place);
    state.grammar.title = scanner.quoted();
    scanner.expect_end("the end of the line after the title");
    keep_comment(scanner.statement(), state.grammar);
}

/// canvas x y width height | canvas corners left top right bottom | canvas none; then perhaps "unsized".
void parse_canvas(Scanner& scanner, ParseState& state) {
    once(scanner, state, "canvas", scanner.statement().place);
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
    state.spoilt.insert(constant.name);
    scanner.expect("=");
    state.spoilt.erase(constant.name);
    constant.value = scanner.expression_until("");
    constant.comment = scanner.statement().comment;
    if (once(scanner, state, "define " + constant.name, constant.place))
        state.grammar.constants.push_back(std::move(constant));
}

void parse_axiom(Scanner& scanner, ParseState& state) {
    const bool first = once(scanner, state, "axiom", scanner.statement().place);
    scanner.expect(":");
    std::vector<ModuleTemplate> axiom = scanner.modules();
    if (first) state.grammar.axiom = std::move(axiom);
    keep_comment(scanner.statement(), state.grammar);
}

void read_address(Scanner& scanner, std::vector<int>& address) {
    do {
        const SourcePlace place = scanner.place();
        address.push_back(scanner.integer("an address such as 1.2.3"));
        if (address.back() < 1) throw InputError(place, "expected numbers from 1 in an address, found 0");
    } while (scanner.take("."));
    scanner.expect("->");
}

void parse_exception(Scanner& scanner, ParseState& state) {
    Exception exception;
    exception.place = scanner.statement().place;
    try {
        read_address(scanner, exception.address);
    } catch (const InputError& error) {
        scanner.keep(error);
        if (scanner.skip_to("->")) scanner.expect("->");
        scanner.modules();
        return;
    }
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
    if (once(scanner, state, "style " + std::to_string(style.number), style.place))
        state.grammar.styles.push_back(std::move(style));
}

/// The beginning of a text, as far as it says what it is.
std::string shown(std::string_view text) {
    if (text.empty()) return "its end";
    return '\'' + std::string(text.substr(0, std::min(text.find_first_of(" \t\r\n", 1), longest_found))) + '\'';
}

std::vector<Path> parse_outline(Scanner& scanner) {
    std::size_t start = 0;
    const std::string_view data = scanner.raw_quoted(start);
    ParsedPath parsed = parse_path_data(data);
    if (parsed.faulty) {
        const std::size_t at = std::min(parsed.fault_at, data.size());
        const std::string expected =
            parsed.fault.starts_with("expected") ? parsed.fault : "expected numbers up to 1e15 in size";
        throw InputError(scanner.place_at(start + at), expected + " in path data, found " + shown(data.substr(at)));
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
        throw InputError(place, "expected style, path, id, box or verbatim, found '" + part + "'" +
                                    did_you_mean(part, {"style", "path", "id", "box", "verbatim"}));
    }
}

void parse_terminal(Scanner& scanner, ParseState& state) {
    Terminal terminal;
    terminal.place = scanner.place();
    terminal.symbol = scanner.name("the symbol of a terminal");
    if (find_turtle_command(terminal.symbol) != nullptr) {
        throw InputError(terminal.place, "expected a symbol of your own, found the command '" + terminal.symbol + "'");
    }
    const bool first = once(scanner, state, "terminal " + terminal.symbol, terminal.place);
    state.spoilt.insert(terminal.symbol);
    scanner.expect(":");
    bool whole = false;
    while (!scanner.at_end() && !whole) {
        scanner.piece([&] {
            parse_terminal_part(scanner, terminal, whole);
            if (!whole && !scanner.peek(";")) scanner.expect_end("';' before the next part of the terminal");
        });
        scanner.take(";");
    }
    scanner.expect_end("the end of the line after <<<");
    state.spoilt.erase(terminal.symbol);
    terminal.comment = scanner.statement().comment;
    if (first) state.grammar.terminals.push_back(std::move(terminal));
}

void parse_production_statement(Scanner& scanner, ParseState& state) {
    const std::size_t mistakes = scanner.mistakes();
    std::optional<Production> production = parse_production(scanner);
    if (production && scanner.mistakes() != mistakes) state.unsure.insert(production->symbol);
    if (production) {
        state.grammar.productions.push_back(std::move(*production));
    } else {
        add_names(scanner.statement().text, state.spoilt);
    }
}

void parse_seed(Scanner& scanner, ParseState& state) {
    once(scanner, state, "seed", scanner.statement().place);
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
        if (once(scanner, state, "ignore " + symbol, place)) state.grammar.ignored.push_back(symbol);
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

/// A statement of no kind without "->" is no production either, if it looks like something else.
void expect_production(const Statement& statement) {
    if (statement.text.find("->") != std::string::npos) return;
    const std::string word(first_name(statement.text));
    const std::vector<std::string_view> known(words.begin(), words.end());
    const std::size_t behind = statement.text.find_first_not_of(" \t\n", word.size());
    const bool continues =
        behind != std::string::npos && std::string_view("(:<>-").find(statement.text[behind]) != std::string_view::npos;
    if (!word.empty() && continues && similar_name(word, known).empty()) return;
    std::string expected = "expected a statement: a production such as 'A -> B', or one that begins with";
    for (const std::string_view kind : words) expected += ' ' + std::string(kind);
    const std::string first_line = statement.text.substr(0, std::min(statement.text.find('\n'), longest_found));
    throw InputError(statement.place,
                     expected + "; found '" + (word.empty() ? first_line : word) + "'" + did_you_mean(word, known));
}

void read_statement(const Statement& statement, ParseState& state) {
    Scanner scanner(statement, state.mistakes);
    const auto kind = std::ranges::find(kinds, first_name(statement.text), &StatementKind::word);
    const bool is_version = kind == kinds.begin();
    if (!state.versioned && !is_version) {
        scanner.keep(InputError(statement.place, "expected 'lsystem 1' as the first statement, found '" +
                                                     statement.text.substr(0, statement.text.find('\n')) + "'"));
    }
    state.versioned = true;  // said once
    if (statement.has_verbatim && (kind == kinds.end() || kind->word != "terminal")) {
        throw InputError(statement.place, "expected a fragment <<< in a terminal only");
    }
    if (kind == kinds.end()) {
        expect_production(statement);
        return parse_production_statement(scanner, state);
    }
    scanner.expect(kind->word);
    kind->parse(scanner, state);
}

}  // namespace

std::span<const std::string_view> statement_words() { return words; }

void parse_statement(const Statement& statement, ParseState& state) {
    try {
        read_statement(statement, state);
    } catch (const InputError& error) {
        add_mistake(state.mistakes, error);
    }
}

}  // namespace rinceau

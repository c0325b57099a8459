#include <algorithm>
#include <limits>

#include "exports/json_grammar.h"
#include "exports/json_style.h"
#include "lsystem/expression.h"
#include "lsystem/grammar_text.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

constexpr int largest = std::numeric_limits<int>::max();

// ---- names and expressions

bool is_name(const std::string& text) {
    const auto starts = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto goes_on = [&](char c) { return starts(c) || (c >= '0' && c <= '9'); };
    return !text.empty() && starts(text.front()) && std::ranges::all_of(text, goes_on);
}

std::string name_in(const JsonValue& value) {
    std::string name = value.text();
    if (!is_name(name)) value.fail("a name of letters, digits and underscores that does not begin with a digit");
    return name;
}

std::vector<std::string> names_in(const JsonValue& value) {
    std::vector<std::string> names;
    value.each([&](const JsonValue& name) { names.push_back(name_in(name)); });
    return names;
}

/// Of a text, or a number.
Expression expression_in(const JsonValue& value) {
    try {
        return value.json().is_number() ? parse_expression(to_text(number_expression(value.number())))
                                        : parse_expression(value.text());
    } catch (const InputError& error) {
        value.fail(error);
    }
}

ModuleTemplate module_in(const JsonValue& value) {
    value.expect_keys({"symbol", "arguments"});
    ModuleTemplate module;
    module.symbol = value.member("symbol").text();
    if (find_turtle_command(module.symbol) == nullptr) module.symbol = name_in(value.member("symbol"));
    if (value.has("arguments"))
        value.member("arguments").each([&](const JsonValue& argument) {
            module.arguments.push_back(expression_in(argument));
        });
    return module;
}

std::vector<ModuleTemplate> modules_in(const JsonValue& value) {
    std::vector<ModuleTemplate> modules;
    value.each([&](const JsonValue& module) { modules.push_back(module_in(module)); });
    return modules;
}

std::string optional_text(const JsonValue& value, const char* key) { return value.has(key) ? value.member(key).text() : ""; }

// ---- the parts

Box corners_in(const JsonValue& value) {
    value.expect_keys({"left", "top", "right", "bottom"});
    const double left = value.member("left").number();
    const double right = value.member("right").number();
    const double top = value.member("top").number();
    const double bottom = value.member("bottom").number();
    if (right < left) value.member("right").fail("a number that is not below 'left'");
    if (bottom < top) value.member("bottom").fail("a number that is not below 'top'");
    return {{left, -bottom}, {right, -top}};
}

std::vector<ContextModule> context_in(const JsonValue& value) {
    std::vector<ContextModule> context;
    value.each([&](const JsonValue& module) {
        module.expect_keys({"symbol", "parameters"});
        ContextModule read;
        read.symbol = name_in(module.member("symbol"));
        if (module.has("parameters")) read.parameters = names_in(module.member("parameters"));
        context.push_back(std::move(read));
    });
    return context;
}

ProductionKind kind_in(const JsonValue& value) {
    const std::string kind = value.text();
    if (kind == "decomposition") return ProductionKind::decomposition;
    if (kind == "homomorphism") return ProductionKind::homomorphism;
    if (kind != "rewriting") value.fail("rewriting, decomposition or homomorphism");
    return ProductionKind::rewriting;
}

Production production_in(const JsonValue& value) {
    value.expect_keys({"symbol", "kind", "parameters", "left", "right", "condition", "successor", "weight", "comment"});
    Production production;
    production.symbol = name_in(value.member("symbol"));
    if (value.has("kind")) production.kind = kind_in(value.member("kind"));
    if (value.has("parameters")) production.parameters = names_in(value.member("parameters"));
    if (value.has("left")) production.left_context = context_in(value.member("left"));
    if (value.has("right")) production.right_context = context_in(value.member("right"));
    if (value.has("condition")) production.condition = expression_in(value.member("condition"));
    production.successor = modules_in(value.member("successor"));
    if (value.has("weight")) production.weight = expression_in(value.member("weight"));
    production.comment = optional_text(value, "comment");
    return production;
}

Exception exception_in(const JsonValue& value) {
    value.expect_keys({"address", "successor", "comment"});
    Exception exception;
    value.member("address").each([&](const JsonValue& number) { exception.address.push_back(number.whole(1, largest)); });
    if (exception.address.empty()) value.member("address").fail("at least one number");
    exception.successor = modules_in(value.member("successor"));
    exception.comment = optional_text(value, "comment");
    return exception;
}

NumberedStyle style_in(const JsonValue& value) {
    if (!value.json().is_object()) value.fail("an object");
    for (const auto& [key, member] : value.json().items()) {
        if (key != "number" && key != "comment" && !is_style_key(key))
            value.member(key).fail("no such key: it is no property of a style");
    }
    return {value.member("number").whole(1, largest), parse_json_style(value), optional_text(value, "comment"), {}};
}

/// Outlines are read as the language does, which knows what a path may be.
std::vector<Path> paths_in(const JsonValue& value) {
    const std::string data = value.text();
    constexpr std::string_view allowed = "MmZzLlHhVvCcSsQqTtAa0123456789+-.eE, \t\r\n";
    if (data.find_first_not_of(allowed) != std::string::npos) value.fail("SVG path data");
    try {
        std::string line = data;
        std::ranges::replace_if(
            line, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
        return parse_grammar("lsystem 1\nterminal A: path \"" + line + '"').terminals.front().paths;
    } catch (const InputError& error) {
        value.fail(error);
    }
}

Terminal terminal_in(const JsonValue& value) {
    value.expect_keys({"symbol", "style", "path", "id", "box", "verbatim", "comment"});
    Terminal terminal;
    terminal.symbol = name_in(value.member("symbol"));
    if (value.has("style")) terminal.style = value.member("style").whole(0, largest);
    if (value.has("path")) terminal.paths = paths_in(value.member("path"));
    terminal.id = optional_text(value, "id");
    if (value.has("box")) terminal.verbatim_box = corners_in(value.member("box"));
    terminal.verbatim = optional_text(value, "verbatim");
    terminal.comment = optional_text(value, "comment");
    return terminal;
}

void expect_format(const JsonValue& value) {
    value.expect_keys({"format", "version", "title", "comments", "canvas", "sized", "seed", "uses", "ignored", "constants",
                       "axiom", "productions", "exceptions", "styles", "terminals"});
    if (value.member("format").text() != "rinceau-grammar") value.member("format").fail("\"rinceau-grammar\"");
    if (value.member("version").number() != 1) value.member("version").fail("1, the version that is known here");
}

template <class Item>
void read_list(const JsonValue& value, const char* key, std::vector<Item>& items, Item (*read)(const JsonValue&)) {
    if (value.has(key)) value.member(key).each([&](const JsonValue& item) { items.push_back(read(item)); });
}

Grammar grammar_in(const JsonValue& value) {
    expect_format(value);
    Grammar grammar;
    grammar.title = optional_text(value, "title");
    read_list<std::string>(value, "comments", grammar.comments, [](const JsonValue& line) {
        std::string text = line.text();
        if (text.find_first_of("\r\n") != std::string::npos) line.fail("one line of text");
        return text;
    });
    if (value.has("canvas")) grammar.canvas = corners_in(value.member("canvas"));
    if (value.has("sized")) grammar.sized = value.member("sized").truth();
    if (value.has("seed")) {
        const JsonValue seed = value.member("seed");
        if (!seed.json().is_number_unsigned()) seed.fail("a whole number that is not below 0");
        grammar.seed = seed.json().get<std::uint64_t>();
    }
    read_list<Use>(value, "uses", grammar.uses, [](const JsonValue& use) {
        use.expect_keys({"file", "prefix", "comment"});
        return Use{use.member("file").text(),
                   use.has("prefix") ? name_in(use.member("prefix")) : "",
                   optional_text(use, "comment"),
                   {}};
    });
    if (value.has("ignored")) grammar.ignored = names_in(value.member("ignored"));
    read_list<Constant>(value, "constants", grammar.constants, [](const JsonValue& constant) {
        constant.expect_keys({"name", "value", "comment"});
        return Constant{name_in(constant.member("name")),
                        expression_in(constant.member("value")),
                        optional_text(constant, "comment"),
                        {}};
    });
    read_list<ModuleTemplate>(value, "axiom", grammar.axiom, module_in);
    read_list<Production>(value, "productions", grammar.productions, production_in);
    read_list<Exception>(value, "exceptions", grammar.exceptions, exception_in);
    read_list<NumberedStyle>(value, "styles", grammar.styles, style_in);
    read_list<Terminal>(value, "terminals", grammar.terminals, terminal_in);
    return grammar;
}

/// What the parts do not show by themselves: names twice, words of the language as names, .. The language finds it in the
/// text.
Grammar checked(const Grammar& grammar, const std::string& file) {
    const std::string text = to_text(grammar);
    try {
        Grammar parsed = parse_grammar(text, file);
        if (to_text(parsed) == text) return parsed;
        throw InputError({file}, "expected a grammar that its text can say, found one that reads differently");
    } catch (const InputError& error) {
        std::string_view line = text;
        for (int i = 1; i < error.place().line && line.find('\n') != std::string_view::npos; ++i)
            line.remove_prefix(line.find('\n') + 1);
        line = line.substr(0, line.find('\n'));
        const std::string message = error.what();
        const std::size_t at = message.find("expected");
        throw InputError(
            {file}, "as text, '" + std::string(line) + "': " + (at == std::string::npos ? message : message.substr(at)));
    }
}

}  // namespace

bool looks_like_json(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

Grammar parse_json_grammar(std::string_view text, const std::string& file_name) {
    const Json document = parse_json_document(text, file_name);
    return checked(grammar_in(JsonValue(document, file_name)), file_name);
}

}  // namespace rinceau

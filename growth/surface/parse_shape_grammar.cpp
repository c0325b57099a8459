#include "growth/surface/parse_shape_grammar.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "growth/surface/parse_shape_commands.h"
#include "growth/surface/parse_shape_rule.h"
#include "growth/surface/shape_commands.h"
#include "growth/surface/shape_statements.h"
#include "lsystem/mistakes.h"
#include "lsystem/scanner.h"

namespace rinceau {

namespace {

class StatementReader {
  public:
    explicit StatementReader(ParsedShapeGrammar& result) : result_(result), grammar_(result.grammar) {}

    void read(const Statement& statement) {
        Scanner scanner(statement, result_.mistakes);
        try {
            read_kind(scanner);
        } catch (const InputError& error) {
            scanner.keep(error);
        }
    }

    /// A word that names a param is its value.
    void tell_words_from_params() {
        std::set<std::string> params;
        for (const ShapeParam& param : grammar_.params) params.insert(param.name);
        for (auto* sources : {&grammar_.shapes, &grammar_.fields})
            for (ShapeSource& source : *sources) take_params(source, params);
        for (auto& [name, option] : grammar_.options) {
            if (!params.contains(option.text) || !option.kind.empty()) continue;
            option.numbers.emplace("value", name_expression(option.text));
            option.text.clear();
        }
    }

  private:
    ParsedShapeGrammar& result_;
    ShapeGrammar& grammar_;
    std::set<std::string> named_;  // "param u", "shape leaf"

    void read_kind(Scanner& scanner) {
        const std::string_view word = scanner.peek_name();
        if (word == "param") return read_param(scanner);
        if (word == "shape") return read_source(scanner, "shape", grammar_.shapes);
        if (word == "field") return read_source(scanner, "field", grammar_.fields);
        if (word == "option") return read_option(scanner);
        if (word == "axiom") return read_axiom(scanner);
        grammar_.rules.push_back(parse_shape_rule(scanner));
    }

    std::string new_name(Scanner& scanner, const std::string& keyword) {
        const SourcePlace place = scanner.place();
        std::string name = scanner.name("the name of a " + keyword);
        if (!named_.insert(keyword + ' ' + name).second)
            throw InputError(place, "expected another name, found the " + keyword + " '" + name + "' a second time");
        return name;
    }

    void read_param(Scanner& scanner) {
        ShapeParam param{.comment = scanner.statement().comment, .place = scanner.place()};
        scanner.expect("param");
        param.name = new_name(scanner, "param");
        scanner.expect("=");
        param.value = parse_shape_expression(scanner);
        scanner.expect_end("the end of the line");
        grammar_.params.push_back(std::move(param));
    }

    /// NAME = kind ["text"] {key = value}
    void read_source(Scanner& scanner, const std::string& keyword, std::vector<ShapeSource>& sources) {
        ShapeSource source;
        source.place = scanner.place();
        source.comment = scanner.statement().comment;
        scanner.expect(keyword);
        source.name = new_name(scanner, keyword);
        scanner.expect("=");
        source.kind = scanner.name("the kind of " + keyword);
        if (scanner.peek("\"")) source.text = scanner.quoted();
        while (!scanner.at_end()) read_setting(scanner, source);
        sources.push_back(std::move(source));
    }

    /// key = number, word or "text"
    void read_setting(Scanner& scanner, ShapeSource& source) {
        const SourcePlace place = scanner.place();
        const std::string key = scanner.name("a setting such as height = 0.3");
        scanner.expect("=");
        if (source.numbers.contains(key) || source.words.contains(key))
            throw InputError(place, "expected every setting once, found '" + key + "' a second time");
        if (scanner.peek("\"")) {
            source.words.emplace(key, scanner.quoted());
            return;
        }
        Expression value = parse_shape_expression(scanner);
        if (is_word(value)) {
            source.words.emplace(key, value.postfix.front().name);
        } else {
            source.numbers.emplace(key, std::move(value));
        }
    }

    static bool is_word(const Expression& value) {
        return value.postfix.size() == 1 && value.postfix.front().op == Expression::Op::name;
    }

    static void take_params(ShapeSource& source, const std::set<std::string>& params) {
        for (auto word = source.words.begin(); word != source.words.end();) {
            const bool is_param = params.contains(word->second);
            if (is_param) source.numbers.emplace(word->first, name_expression(word->second));
            word = is_param ? source.words.erase(word) : std::next(word);
        }
    }

    void read_option(Scanner& scanner) {
        ShapeSource option;
        option.place = scanner.place();
        option.comment = scanner.statement().comment;
        scanner.expect("option");
        option.name = new_name(scanner, "option");
        scanner.expect("=");
        if (scanner.peek("\"")) {
            option.text = scanner.quoted();
        } else {
            Expression value = parse_shape_expression(scanner);
            if (is_word(value)) {
                option.text = value.postfix.front().name;
            } else {
                option.numbers.emplace("value", std::move(value));
            }
        }
        while (!scanner.at_end()) read_setting(scanner, option);
        grammar_.options.emplace(option.name, std::move(option));
    }

    void read_axiom(Scanner& scanner) {
        ShapeAxiom axiom;
        axiom.place = scanner.place();
        axiom.comment = scanner.statement().comment;
        scanner.expect("axiom");
        read_where(scanner, axiom);
        axiom.commands = parse_shape_commands(scanner, {});
        if (axiom.commands.empty()) scanner.fail("the symbols or commands that begin there");
        grammar_.axioms.push_back(std::move(axiom));
    }

    static void read_where(Scanner& scanner, ShapeAxiom& axiom) {
        const SourcePlace place = scanner.place();
        const std::string word = scanner.name("a place: vertex N, nearest X Y Z, scatter N or each FIELD");
        std::size_t numbers = 1;
        if (word == "nearest") {
            axiom.where = ShapeAxiom::Where::nearest;
            numbers = 3;
        } else if (word == "scatter") {
            axiom.where = ShapeAxiom::Where::scatter;
        } else if (word == "each") {
            axiom.where = ShapeAxiom::Where::each;
            axiom.field = scanner.name("the name of a field");
            return;
        } else if (word != "vertex") {
            throw InputError(place,
                             "expected a place: vertex N, nearest X Y Z, scatter N or each FIELD, found '" + word + "'");
        }
        while (axiom.numbers.size() < numbers)
            axiom.numbers.push_back(scanner.expression_here({.queries = true, .operand = true}));
    }
};

void sort_by_place(std::vector<Warning>& mistakes) {
    std::ranges::stable_sort(mistakes, {},
                             [](const Warning& mistake) { return std::tuple(mistake.place.line, mistake.place.column); });
}

}  // namespace

ParsedShapeGrammar read_shape_grammar(std::string_view text, const std::string& file_name) {
    ParsedShapeGrammar result;
    result.grammar.file_name = file_name;
    StatementList list = split_shape_statements(text, file_name);
    result.grammar.comments = std::move(list.comments);
    StatementReader reader(result);
    for (const Statement& statement : list.statements) {
        if (result.mistakes.size() >= max_mistakes) break;
        reader.read(statement);
    }
    reader.tell_words_from_params();
    result.mistakes.insert(result.mistakes.end(), list.faults.begin(), list.faults.end());
    sort_by_place(result.mistakes);
    return result;
}

ShapeGrammar parse_shape_grammar(std::string_view text, const std::string& file_name) {
    ParsedShapeGrammar result = read_shape_grammar(text, file_name);
    if (result.mistakes.empty()) return std::move(result.grammar);
    throw InputError(result.mistakes.front().place, result.mistakes.front().message);
}

bool looks_like_shape_grammar(std::string_view text) {
    const StatementList list = split_shape_statements(text, {});
    if (list.statements.empty()) return false;
    const std::string_view first = list.statements.front().text;
    const std::size_t start = first.find_first_not_of(" \t");
    const std::size_t end = first.find_first_of(" \t", start);
    return is_statement_word(first.substr(start, end - start)) || first.find(rule_sign) != std::string_view::npos ||
           first.find(rule_arrow) != std::string_view::npos;
}

}  // namespace rinceau

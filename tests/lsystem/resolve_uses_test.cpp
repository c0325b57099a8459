// Grammars that use other files.

#include <catch2/catch.hpp>

#include <map>

#include "lsystem/derive.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/resolve_uses.h"

using namespace rinceau;

using Files = std::map<std::string, std::string>;

static GrammarLoader loader(const Files& files) {
    return [&files](const std::string& file) {
        const auto found = files.find(file);
        if (found == files.end()) throw InputError({file}, "cannot be read: there is none");
        return "lsystem 1\n" + found->second;
    };
}

static Grammar resolved(const Files& files, const std::string& main = "main.lsys") {
    return resolve_uses(parse_grammar("lsystem 1\n" + files.at(main), main), loader(files));
}
static std::vector<Warning> mistakes(const Files& files, const std::string& main = "main.lsys") {
    return check_grammar("lsystem 1\n" + files.at(main), main, loader(files));
}
static std::string derived(const Files& files) { return to_text(derive(resolved(files))); }

/// The only mistake.
static std::string mistake(const Files& files) {
    const std::vector<Warning> found = mistakes(files);
    REQUIRE(found.size() == 1);
    CHECK_THROWS_AS(resolved(files), InputError);
    return located(found[0].place, found[0].message);
}

TEST_CASE("a grammar has the productions, terminals, styles and constants of the files it uses") {
    const Files files{{"main.lsys", "use \"row.lsys\"\naxiom: Row(count+1)\n"},
                      {"row.lsys",
                       "define count = 2\naxiom: Other\ntitle \"row\"\nseed 4\nexcept 1 ->\ncanvas 0 0 1 1\n"
                       "Row(m) : m > 0 -> [A] f(13) Row(m-1)\nterminal A: style 1; path \"M0 0V-1\"\nstyle 1: fill red\n"}};
    CHECK(derived(files) == "[ A ] f(13) [ A ] f(13) [ A ] f(13) Row(0)");
    CHECK(mistakes(files).empty());
    const Grammar grammar = resolved(files);
    CHECK(grammar.uses.empty());
    CHECK(grammar.title.empty());
    CHECK(grammar.exceptions.empty());
    CHECK_FALSE(grammar.seed);
    CHECK(is_empty(grammar.canvas));
    REQUIRE(grammar.styles.size() == 1);
    CHECK(grammar.terminals.at(0).style == grammar.styles[0].number);
}

TEST_CASE("a prefix stands before symbols and constants, and not before commands, parameters, functions, pi and e") {
    const Files files{
        {"main.lsys", "use \"a.lsys\" as v\ndefine size = 10\naxiom: v_Row(2) Row\nRow -> +(size)\nignore Row\n"},
        {"a.lsys",
         "define size = 3\nignore Dot\naxiom: Row(1)\n"
         "Dot < Row(m) > Dot(size) : m > size -> Row(size) fill(m, sin(pi), e) f(size*m) : size\n"
         "Row(size) : size > 0 -> [Dot(size) z(1)] Row(size-1)\nRow(m) -> f(size)\nterminal Dot: path \"M0 0V-1\"\n"}};
    const Grammar grammar = resolved(files);
    CHECK(to_text(grammar) ==
          "lsystem 1\n\ndefine v_size = 3\ndefine size = 10\n\naxiom: v_Row(2) Row\n\nignore Row v_Dot\n\nRow -> +(size)\n"
          "v_Dot < v_Row(m) > v_Dot(size) : m > size -> v_Row(size) fill(m, sin(pi), e) f(size*m) : size\n"
          "v_Row(size) : size > 0 -> [v_Dot(size) z(1)] v_Row(size-1)\nv_Row(m) -> f(v_size)\n\n"
          "terminal v_Dot: path \"M0 0L0-1\"\n");
}

TEST_CASE("styles of used files keep apart, named by numbers or by expressions") {
    const std::string used =
        "axiom: A\nRow(m) : m >= 0 -> ;(m) A Row(m-1)\nCol -> ;(2) A ;(0) A ;(round(uniform(2, 2))) A\n"
        "terminal A: style 2; path \"M0 0V-1\"\nstyle 1: fill red\nstyle 2: fill blue\n";
    const std::string direct = "axiom: Row(2) Col\n" + used.substr(used.find('\n') + 1);
    const Files files{{"main.lsys",
                       "use \"a.lsys\" as a\nuse \"a.lsys\" as b\naxiom: a_Row(2) a_Col b_Row(2) b_Col ;(7) D\n"
                       "style 7: fill lime\nstyle 3: fill white\nterminal D: style 3; path \"M0 0\"\n"},
                      {"a.lsys", used}};
    const Grammar alone = parse_grammar("lsystem 1\n" + direct);
    const Grammar grammar = resolved(files);
    const auto fills = [](const Grammar& from) {
        std::vector<Paint> paints;
        for (const Placement& placement : interpret(from)) {
            const int own = from.terminals[static_cast<std::size_t>(placement.terminal)].style;
            const int number = placement.style == 0 ? own : placement.style;
            for (const NumberedStyle& style : from.styles) {
                if (style.number == number) paints.push_back(style.style.fill);
            }
        }
        return paints;
    };
    const std::vector<Paint> once = fills(alone);
    REQUIRE(once.size() == 6);
    std::vector<Paint> expected = once;
    expected.insert(expected.end(), once.begin(), once.end());
    expected.push_back(Paint(Color{0, 255, 0}));
    CHECK(fills(grammar) == expected);
}

TEST_CASE("an unknown number of a style stays unknown where the grammar is used") {
    for (const char* number : {"3", "2.5", "-1", "0-1", "1+1.5", "2+2"}) {
        const Files files{
            {"main.lsys", "use \"a.lsys\"\naxiom: P(0)\nstyle 1: fill red\nstyle 2: fill red\nstyle 4: fill red\n"},
            {"a.lsys", "P(m) -> ;(m+" + std::string(number) + ") A\nterminal A: path \"M0 0\"\nstyle 1: fill red\n"}};
        INFO(number);
        CHECK_THROWS_AS(interpret(resolved(files)), InputError);
    }
}

TEST_CASE("names of files are taken from the folder of the file that says so") {
    const Files files{{"x/main.lsys", "use \"sub/a.lsys\" as a\naxiom: a_b_B\n"},
                      {"x/sub/a.lsys", "use \"../../y/b.lsys\" as b\n"},
                      {"y/b.lsys", "B -> f(1)\n"}};
    CHECK(to_text(derive(resolved(files, "x/main.lsys"))) == "f(1)");
}

TEST_CASE("what comes along twice is there once") {
    const Files files{{"main.lsys", "use \"a.lsys\"\nuse \"b.lsys\"\nuse \"./c.lsys\"\naxiom: A B C(n)\n"},
                      {"a.lsys", "use \"c.lsys\"\nA -> C(1) C(2)\n"},
                      {"b.lsys", "use \"c.lsys\"\nB -> C(3)\n"},
                      {"c.lsys", "define n = 5\nC(m) : m > 4 -> f(m)\nC(m) -> D\nterminal D: path \"M0 0\"\n"}};
    CHECK(derived(files) == "D D D f(5)");
    CHECK(resolved(files).productions.size() == 4);
    CHECK(mistakes(files).empty());
}

TEST_CASE("names that two files give are mistakes, each with its cure") {
    const Files files{{"main.lsys", "use \"leaf 2.lsys\"\naxiom: A\ndefine n = 1\nA -> f(n)\nterminal T: path \"M0 0\"\n"},
                      {"leaf 2.lsys", "define n = 1\nA -> f(n)\nA(m) -> f(m)\nterminal T: path \"M0 0\"\n"}};
    const std::vector<Warning> found = mistakes(files);
    REQUIRE(found.size() == 3);
    for (const Warning& warning : found) {
        CHECK(warning.place.line == 2);
        CHECK(warning.message.find("'use \"leaf 2.lsys\" as leaf_2'") != std::string::npos);
    }
    CHECK(found[0].message.find("'define n' of line 2, which is in main.lsys, line 4") != std::string::npos);
}

TEST_CASE("files that cannot be read, use themselves or are too many are mistakes where they are used") {
    CHECK(mistake({{"main.lsys", "use \"b.lsys\"\naxiom: A\n"}}) ==
          "main.lsys:2:5: expected the grammar b.lsys, found that it cannot be read: there is none");
    CHECK(mistake({{"main.lsys", "use \"main.lsys\"\naxiom: A\n"}}) ==
          "main.lsys:2:5: expected files that do not use themselves, found that main.lsys uses main.lsys: "
          "take one 'use' away");
    CHECK(mistake({{"main.lsys", "use \"b.lsys\"\naxiom: A\n"}, {"b.lsys", "use \"x/../main.lsys\"\n"}}) ==
          "b.lsys:2:5: expected files that do not use themselves, found that main.lsys uses b.lsys uses main.lsys: "
          "take one 'use' away");
    Files chain{{"main.lsys", "use \"1\"\naxiom: A\n"}};
    for (int i = 1; i <= 20; ++i) chain[std::to_string(i)] = "use \"" + std::to_string(i + 1) + "\"\n";
    CHECK(mistake(chain).find("16:2:5: expected at most 16 files that use one another") == 0);
    Files wide{{"main.lsys", "use \"1\" as a\nuse \"1\" as b\naxiom: A\n"}};
    for (int i = 1; i <= 15; ++i) {
        const std::string next = "use \"" + std::to_string(i + 1) + "\" as ";
        wide[std::to_string(i)] = next + "a\n" + next + "b\n";
    }
    wide["16"] = "A -> f(1)\n";
    CHECK(mistake(wide).find("expected at most 10000 files and 16 MiB of text") != std::string::npos);
}

TEST_CASE("mistakes of used files are named with their own file and place, beside those of the grammar") {
    const Files files{{"main.lsys", "use \"b.lsys\" as b\naxiom: b_Row(1) $\nb_Extra -> Nothing\n"},
                      {"b.lsys", "Row(m) -> [Dot f(1, 2)\nterminal Dot: styl 1; path \"M0\"\nRow(m -> A\n"}};
    std::vector<std::string> places;
    for (const Warning& warning : mistakes(files)) {
        places.push_back(warning.place.file + ' ' + std::to_string(warning.place.line) + ':' +
                         std::to_string(warning.place.column));
    }
    CHECK(places == std::vector<std::string>{"main.lsys 3:17", "b.lsys 2:11", "b.lsys 2:16", "b.lsys 3:15", "b.lsys 3:31",
                                             "b.lsys 4:7"});
}

TEST_CASE("a use is kept where a grammar is written again, and is a mistake where no file can be read") {
    const std::string text = "lsystem 1\n\n# leaves\nuse \"leaf \\\"1\\\".lsys\" as leaf\n\naxiom: leaf_A\n";
    CHECK(to_text(parse_grammar(text)) == text);
    REQUIRE(check_grammar(text).size() == 1);
    CHECK(check_grammar(text)[0].place.line == 4);
}

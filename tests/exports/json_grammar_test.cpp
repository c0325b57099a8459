#include "exports/json_grammar.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "lsystem/grammar_text.h"
#include "tests/lsystem/random_grammar.h"

using namespace rinceau;

static void check_round_trip(const std::string& text) {
    const Grammar grammar = parse_grammar(text);
    const std::string json = to_json(grammar).bytes;
    CAPTURE(json);
    CHECK(to_text(parse_json_grammar(json)) == to_text(grammar));
    CHECK(to_json(parse_json_grammar(json)).bytes == json);
}

static std::string mistake(const std::string& json) {
    try {
        parse_json_grammar(json, "x.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

/// A document with this member, and a path to where its mistake is said to be.
static std::string mistake_in(const std::string& member) {
    return mistake("{\"format\": \"rinceau-grammar\", \"version\": 1, " + member + "}");
}

TEST_CASE("a grammar comes back from JSON byte for byte") {
    check_round_trip(
        "lsystem 1\ntitle \"A \\\"row\\\"\"\n\n# on top\n\ncanvas corners 0.1 0.2 30.3 40 unsized\nseed "
        "18446744073709551615\n"
        "use \"vine.lsys\" as vine\nignore X Y\n# a number\ndefine step = 2^3 - -1\n\naxiom: P(3) [+(step/7) A] | ;(2) "
        "fill(1, 2, 3) A fill\n\n"
        "P(m) : m > 0 -> A f(0.1) P(m-1) : 2\nX < P(m) > Y(k) : m == k -> A\ndecomposition Q -> A A\nhomomorphism A(x) -> "
        "f(x)\n"
        "# lost\nexcept 1.2.3 ->\n\nstyle 2: fill radial-gradient(matrix(1 0 0.1 1 5 6), spread reflect, focus 0.1 0.2, "
        "focal-radius 0.3, "
        "0 white, 1 #010203 opacity 0.4); stroke red; stroke-width 2 fixed; stroke-dasharray 1 2; pen 1 0 0 1; paint-order "
        "stroke\n"
        "terminal A: style 2; path \"M0.1 -0.2C1e-9 2 3 4 5 6Z\"; id \"x\"\n"
        "terminal V: box -1 -2 3 4; verbatim <<<SVG\n<text>\xff\xe9 hello</text>\nSVG\n");
}

TEST_CASE("every grammar comes back from JSON") {
    Random random(11);
    for (int i = 0; i < 400; ++i) {
        const Grammar grammar = random_grammar(random);
        const std::string json = to_json(grammar).bytes;
        CAPTURE(json);
        const Grammar back = parse_json_grammar(json);
        REQUIRE(to_text(back) == to_text(grammar));
        REQUIRE(same_grammar(back, parse_grammar(to_text(grammar))));
    }
}

TEST_CASE("a small document is a grammar") {
    const Grammar grammar = parse_json_grammar(R"j( {"format": "rinceau-grammar", "version": 1,
        "axiom": [{"symbol": "+", "arguments": [30]}, {"symbol": "P", "arguments": ["2*3"]}],
        "productions": [{"symbol": "P", "parameters": ["m"], "condition": "m > 0", "successor": []}],
        "styles": [{"number": 1, "fill": "gold", "stroke-dasharray": [1]}], "terminals": [{"symbol": "A", "style": 1, "path": "m1,1 h2"}]})j");
    CHECK(to_text(grammar).find("axiom: +(30) P(2*3)") != std::string::npos);
    CHECK(to_text(grammar).find("fill #ffd700; stroke-dasharray 1 1") != std::string::npos);
}

TEST_CASE("a mistake in JSON is named with its place") {
    CHECK(mistake("{\n \"format\": 1 2}").starts_with("x.json:2:14: expected JSON, found"));
    CHECK(mistake("[]") == "x.json: the document: expected an object, found a list");
    CHECK(mistake(R"j({"format": "other", "version": 1})j") ==
          "x.json: format: expected \"rinceau-grammar\", found \"other\"");
    CHECK(mistake(R"j({"format": "rinceau-grammar", "version": 2})j") ==
          "x.json: version: expected 1, the version that is known here, found 2");
    CHECK(mistake_in(R"j("axioms": [])j").find("expected one of the keys") != std::string::npos);
    CHECK(mistake_in(R"j("axiom": [{"symbol": "A"}, {"symbol": "A f(1)"}])j")
              .starts_with("x.json: axiom[1].symbol: expected a name"));
    CHECK(mistake_in(R"j("axiom": [{"symbol": "f", "arguments": ["2*"]}])j")
              .starts_with("x.json: axiom[0].arguments[0]: expected"));
    CHECK(mistake_in(R"j("productions": [{"symbol": "A", "successor": [], "kind": 3}])j")
              .starts_with("x.json: productions[0].kind: expected a string"));
    CHECK(mistake_in(R"j("exceptions": [{"address": [1, 0], "successor": []}])j")
              .starts_with("x.json: exceptions[0].address[1]: expected a whole number from 1"));
    CHECK(mistake_in(R"j("styles": [{"number": 1, "fill": "red; stroke blue"}])j")
              .starts_with("x.json: styles[0].fill: expected"));
    CHECK(mistake_in(R"j("styles": [{"number": 1, "opacity": 7}])j")
              .starts_with("x.json: styles[0].opacity: expected a number from 0 to 1"));
    CHECK(mistake_in(R"j("terminals": [{"symbol": "A", "path": "M0 0 Q"}])j")
              .starts_with("x.json: terminals[0].path: expected"));
    CHECK(mistake_in(R"j("terminals": [{"symbol": "A", "path": "M0 0\"; id \"b"}])j")
              .starts_with("x.json: terminals[0].path: expected"));
    CHECK(mistake_in(R"j("comments": ["a\nterminal B:"])j").starts_with("x.json: comments[0]: expected one line"));
    CHECK(mistake_in(R"j("seed": -1)j").starts_with("x.json: seed: expected a whole number"));
}

TEST_CASE("what the parts do not show is found in the whole") {
    const std::string twice = mistake_in(R"j("terminals": [{"symbol": "A"}, {"symbol": "A"}])j");
    CHECK(twice.starts_with("x.json: as text, 'terminal A:"));
    CHECK(
        mistake_in(R"j("productions": [{"symbol": "axiom", "successor": []}])j").starts_with("x.json: as text, 'axiom ->"));
}

TEST_CASE("hostile JSON is refused in bounded time") {
    CHECK(mistake(std::string(2'000'000, '[')).find("nested deeper") != std::string::npos);
    CHECK(mistake("{\"format\": \"rinceau-grammar\", \"version\": 1, \"axiom\": [{\"symbol\": \"f\", \"arguments\": [\"" +
                  std::string(500'000, '(') + "\"]}]}")
              .starts_with("x.json: axiom[0].arguments[0]"));
    CHECK(mistake("{\"format\": \"rinceau-grammar\", \"version\": 1e400}").find("overflow") != std::string::npos);
    CHECK(mistake("{\"title\": \"\xff\"}").find("expected JSON") != std::string::npos);
    CHECK(mistake("") != "none");
}

TEST_CASE("half a document, and one with a byte changed, is a mistake or a grammar, never anything else") {
    Random random(3);
    const std::string json = to_json(random_grammar(random)).bytes;
    for (int i = 0; i < 2000; ++i) {
        std::string damaged = json;
        damaged[random.below(static_cast<std::uint32_t>(json.size()))] = static_cast<char>(random.below(256));
        if (random.below(4) == 0) damaged.resize(random.below(static_cast<std::uint32_t>(json.size())));
        try {
            const Grammar read = parse_json_grammar(damaged);
            CHECK(to_json(parse_json_grammar(to_json(read).bytes)).bytes == to_json(read).bytes);
        } catch (const InputError&) {
        }
    }
}

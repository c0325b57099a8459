// rinceau grow and field on bad input of every sort: one message with its place, status 1, 2, 3 or 4, quickly, in a
// gigabyte, and no output harmed.

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {

#ifdef RINCEAU_SANITIZED
constexpr double longest_seconds = 120;  // sanitizers slow the program down
#else
constexpr double longest_seconds = 10;
#endif

constexpr auto box = "shape b = box\n";
constexpr auto square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

/// Bytes of a file, and what the message about them says.
struct Refused {
    std::string bytes;
    std::string message;
    int status = 1;
};

struct BadInputFolder {
    ScratchFolder scratch;

    BadInputFolder() {
        put("good.fgsg", std::string(box) + "axiom nearest 0 0 0 S(0.1) I(\"b\")\n");
        put("square.obj", square);
    }
    void put(const std::string& name, const std::string& bytes) const { write_file(scratch.file(name), bytes); }

    /// Runs the words with -o, over a file that must stay as it is.
    void check(std::vector<std::string> words, const Refused& expected) const {
        const auto before = scratch.names().size();
        const std::string output = words.front() == "field" ? "out.json" : "out.glb";
        put(output, "old");
        words.insert(words.end(), {"-o", output});
        const ProgramRun run = run_rinceau(words, {.folder = scratch.path()});
        CAPTURE(words, expected.bytes.substr(0, 200), run.err.substr(0, 500), run.seconds, run.signal);
        CHECK(run.status == expected.status);
        CHECK(run.err.find(expected.message) != std::string::npos);
        CHECK(run.out.empty());
        CHECK(run.seconds < longest_seconds);
        CHECK(read_file(scratch.file(output)) == "old");
        std::filesystem::remove(scratch.file(output));
        CHECK(scratch.names().size() == before);
    }
    void check_grammar(const Refused& bad) const {
        put("bad.fgsg", bad.bytes);
        check({"grow", "bad.fgsg"}, bad);
    }
};

}  // namespace

TEST_CASE("Shape grammars that cannot be read are refused with the place") {
    const BadInputFolder folder;
    const std::string start = std::string(box) + "axiom vertex 0 ";
    const std::vector<Refused> grammars{
        {"", "bad.fgsg:1:1: expected an axiom"},
        {"# nothing\n", "bad.fgsg:1:1: expected an axiom"},
        {std::string(box) + "A ~ I(\"b\")\n", "bad.fgsg:1:1: expected an axiom"},
        {std::string("\x7f"
                     "ELF\0\1",
                     6),
         "bad.fgsg:1:1: expected a statement"},
        {"axiom vertex 0 A\nA ~ Bc\n", "bad.fgsg:2:5: expected a symbol that has a rule, found 'Bc'"},
        {start + "I(\"c\")\n", "bad.fgsg:2:16: expected a shape of this grammar, found 'c'"},
        {start + "Rz(F1.Xangle1)\n", "bad.fgsg:2:16: expected a field of this grammar"},
        {"field F = constant\naxiom vertex 0 Rz(F.Xangel1)\n", "found 'F.Xangel1': did you mean 'Xangle1'?"},
        {"field F = constant angel = 3\naxiom vertex 0 Rz(1)\n", "bad.fgsg:1:1: a field of the kind constant has no angel"},
        {"field F = image\naxiom vertex 0 Rz(1)\n", "bad.fgsg:1:1: expected the name of a file"},
        {"axiom vertex 0 A(1)\nA(a, b) ~ Rz(a)\n", "bad.fgsg:1:16: expected 2 argument(s) of A"},
        {"axiom vertex 0 Rz(1, 2)\n", "bad.fgsg:1:16: expected 1 number for Rz(degrees), found 2"},
        {"axiom scatter 1e12 A\nA ~ Rz(1)\n", "expected a number of places from 0 to 1"},
        {"axiom scatter (0/0) A\nA ~ Rz(1)\n", "bad.fgsg:1:1: expected a finite number"},
        {"option culls = rule\naxiom vertex 0 Rz(1)\n", "found 'culls': did you mean 'cull'?"},
        {"option plane = 1 cells = 1e9\naxiom vertex 0 Rz(1)\n",
         "the option 'plane': expected a whole number from 1 to 2000"},
        {start + repeated("[", 5000) + repeated("]", 5000) + "\n", "bad.fgsg:2:117: expected at most 100 brackets"},
        {start + "Rz(" + repeated("(", 5000) + "1" + repeated(")", 5000) + ")\n", "at most 200 nested parts"},
        {start + repeated("Lock{", 5000) + repeated("}", 5000) + "\n", "at most 100 braces in each other"},
        {start + repeated("Rz(1) ", 170'000) + "I(\"c\")\n", "expected a shape of this grammar, found 'c'"},
        {"axiom vertex 0 A(1)\nA(n) : n" + repeated("&&n", 40'000) + " ~ I(\"c\")\n", "expected a shape"},
        {"axiom vertex 0 A(1)\nA(n) : n" + repeated("&&n", 100'000) + " ~ I(\"c\")\n",
         "expected at most 100000 numbers, names"},
    };
    for (const Refused& bad : grammars) folder.check_grammar(bad);
}

TEST_CASE("Numbers that make no sense while it grows are errors with the rule and the place") {
    const BadInputFolder folder;
    const std::string start = std::string(box) + "axiom nearest 0 0 0 ";
    const std::vector<Refused> grammars{
        {start + "A(0)\nA(n) ~ S(n) I(\"b\")\n", "bad.fgsg:3:8: in rule 'A': expected sizes above 0"},
        {start + "A(1)\nA(n) ~ S(n, -n, n) I(\"b\")\n", "found 1, -1, 1"},
        {start + "A(0)\nA(n) ~ S(n/n) I(\"b\")\n", "bad.fgsg:3:8: expected a finite number, found that 'n/n' has no value"},
        {start + "S(1e300) I(\"b\")\n", "up to 1e9 diagonals of the surface, found 1e+300"},
        {start + "S(0.1) IM(\"b\", -1)\n", "bad.fgsg:2:28: in an axiom: expected a distance of at least 0, found -1"},
        {start + "Line(1) LineSeg(0.1, 0)\n",
         "bad.fgsg:2:29: in an axiom: expected a length of at least 0 and a width above"},
        {start + "A(0)\nA(n) : n/n ~ Rz(1)\n", "bad.fgsg:3:1: expected a condition that is true or false"},
        {start + "A(-1)\nA(n) ~ Rz(1) : n\n", "bad.fgsg:3:1: expected a probability of at least 0"},
        {"axiom vertex 1000000 A\nA ~ Rz(1)\n", "bad.fgsg:1:1: expected a vertex of the surface, from 0 to"},
    };
    for (const Refused& bad : grammars) folder.check_grammar(bad);
}

TEST_CASE("Rules that lead on for ever are ended: status 3, with the rule and what to do") {
    const BadInputFolder folder;
    const std::string cure = "give it a condition that ends it, or allow more";
    folder.check_grammar({"axiom vertex 0 A\nA ~ B B\nB ~ A A\n", cure, 3});
    folder.check_grammar({std::string(box) + "axiom vertex 0 A\nA ~ S(0.01) I(\"b\") [T(0.01) A] A\n", "--keep-partial", 3});
    folder.check_grammar(
        {"option max_rules = 10000\naxiom vertex 0 A\nA ~ Rz(1) A\n", "rule 'A' of line 3 was applied most", 3});
    folder.check_grammar({"axiom vertex 0 A\nA ~ Lock{A | A}\n", "keep endless growth out of Lock", 3});
    folder.check_grammar({"axiom vertex 0 A\nA ~ Lock{B B}\nB ~ Rz(1) B\n", "keep endless growth out of Lock", 3});
    folder.check_grammar(
        {std::string(box) +
             "axiom nearest 0 0 0 Ring(0)\nRing(i) : i < 1e9 ~ [Rz(i*137) T(0.2) S(0.001) I(\"b\")] Ring(i+1)\n",
         "1000000 shapes and waiting symbols", 3});
}

TEST_CASE("Meshes that are no surface are refused with the reason and the place") {
    const BadInputFolder folder;
    const std::string ply =
        "\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
        "property list uchar int vertex_indices\nend_header\n";
    const std::vector<Refused> meshes{
        {"", "expected a mesh with vertices"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "expected a mesh with faces"},
        {"v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n", "bad.obj:3: expected three numbers"},
        {"v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", "bad.obj:3: expected three numbers"},
        {"v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nf 1 2 3\n", "bad.obj: expected coordinates up to 1e100, vertex 1"},
        {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "expected a mesh with faces that have an area, found none"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "bad.obj:4: the face has vertex 9"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
         "1 edge of three or more faces. The first: edge 0-1 of faces 0, 1, 2 at (0.5, 0, 0). With --repair"},
        {"OFF\n4 2 0\n0 0 0\n1 0 0\n", "bad.obj:4: expected vertex 2, found the end of the file"},
        {"OFF\n4000000000 2 0\n0 0 0\n", "more than 10000000 vertices", 3},
        {"ply\nformat ascii 1.0" + ply + "0 0 0\n1 0 0\n1 1", "the file ends before all that its header promises"},
        {"ply\nformat binary_little_endian 1.0" + ply + std::string(40, '\0'), "the file ends before all that its header"},
        {"<svg/>", "expected a mesh with vertices"},
    };
    for (const Refused& bad : meshes) {
        folder.put("bad.obj", bad.bytes);
        folder.check({"grow", "good.fgsg", "--on", "bad.obj"}, bad);
    }
    folder.check({"field", "bad.obj", "--curvature"}, {"", "bad.obj: expected a mesh with vertices"});
    folder.check({"field", "good.fgsg", "--curvature"}, {"", "good.fgsg: expected a mesh as .obj, .off or .ply"});
}

TEST_CASE("Meshes of quads, with borders or in two pieces are grown on") {
    const BadInputFolder folder;
    for (const std::string mesh :
         {"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 4 5\n",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n",
          "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}) {
        folder.put("mesh.obj", mesh);
        const ProgramRun run = run_rinceau({"grow", "good.fgsg", "--on", "mesh.obj"}, {.folder = folder.scratch.path()});
        CAPTURE(mesh, run.err);
        CHECK(run.status == 0);
        CHECK(run.err.find("1 shape placed") != std::string::npos);
    }
}

TEST_CASE("Fields that do not fit are refused with the place in the document") {
    const BadInputFolder folder;
    const std::string x = "[1, 0, 0]";
    const std::vector<Refused> fields{
        {R"({"n": 2, "vectors": [[1, 0, 0]]})", "bad.json: vectors: the list has 1 values but the surface has 4 vertices"},
        {R"({"n": 3, "vectors": []})", "bad.json: n: expected 1 (vectors), 2"},
        {"{\"vectors\": [" + x + ", " + x + ", [NaN, 0, 0], " + x + "]}", "bad.json:1:"},
        {"{\"vectors\": [" + x + ", " + x + ", [null, 0, 0], " + x + "]}", "vectors[2][0]: expected a number, found null"},
        {"{\"vectors\": [" + x + ", " + x + ", [1e400, 0, 0], " + x + "]}", "bad.json: a number"},
        {"{\"vectors\": [" + x, "bad.json:1:"},
        {repeated("[", 100'000), "nested deeper than any field"},
        {"", "bad.json:1:1: expected JSON"},
        {R"({"n": 2})", "expected \"vectors\", \"z\" or \"scalar\""},
    };
    const std::vector<Refused> designs{
        {R"({"elements": []})", "bad.json"},
        {R"([{"type": "wegde", "vertex": 0}])", "[0].type: expected one of regular"},
        {R"([{"type": "wedge", "vertex": 99}])", "[0].vertex: expected a whole number from 0 to 3, found 99"},
        {R"({"n": 1, "elements": [{"type": "wedge", "vertex": 0}]})", "bad.json"},
        {R"([{"type": "wedge", "vertex": 0, "weight": -1}])", "bad.json"},
        {R"([{"type": "wedge", "vertex": 0, "at": [0, 0, 0]}])", "either \"vertex\" or \"at\""},
        {R"({"elements": [{"type": "regular", "vertex": 0}], "smooth": -1})", "bad.json"},
    };
    for (const Refused& bad : fields) {
        folder.put("bad.json", bad.bytes);
        folder.check({"field", "square.obj", "--field", "bad.json"}, bad);
    }
    for (const Refused& bad : designs) {
        folder.put("bad.json", bad.bytes);
        folder.check({"field", "square.obj", "--elements", "bad.json"}, bad);
    }
    folder.put("no.png", "no picture");
    folder.check({"field", "square.obj", "--image", "no.png"}, {"", "no.png: expected a PNG picture"});
    folder.check({"field", "square.obj", "--element", "wedge,9"}, {"", "--element"});
    folder.check({"field", "square.obj", "--curvature", "--smooth-at", "9,0.1,3"}, {"", "no vertex 9; expected 0 to 3"});
    folder.check({"grow", "good.fgsg", "--on", "square.obj", "--field", "none.json"}, {"", "none.json: cannot be read"});
    folder.check({"grow", "good.fgsg", "--on", "square.obj", "--field", "wavy"}, {"", "kind of a field, found 'wavy'"});
}

TEST_CASE("Outputs that cannot or should not be written are named before any work") {
    const BadInputFolder folder;
    const auto status = [&](const std::vector<std::string>& words, const std::string& message) {
        const ProgramRun run = run_rinceau(words, {.folder = folder.scratch.path()});
        CAPTURE(words, run.err);
        CHECK(run.err.find(message) != std::string::npos);
        return run.status;
    };
    const auto files = folder.scratch.names();
    CHECK(status({"grow", "good.fgsg", "-o", "none/a.glb"}, "none/a.glb") == 4);
    CHECK(status({"grow", "good.fgsg", "-o", "a.stl"}, "ends in .obj, .ply, .glb, .png or .svg, found 'a.stl'") == 2);
    CHECK(status({"grow", "good.fgsg", "--on", "square.obj", "-o", "./square.obj"}, "is the input 'square.obj'") == 2);
    CHECK(status({"grow", "good.fgsg", "-o", "a.glb", "--report", "good.fgsg"}, "--report") == 2);
    CHECK(status({"field", "square.obj", "--curvature", "-o", "square.obj"}, "is the input 'square.obj'") == 2);
    CHECK(status({"field", "square.obj", "--curvature", "-o", "a.json", "--report", "a.json"}, "another file") == 2);
    CHECK(status({"field", "square.obj", "--curvature", "-o", "a.stl"}, "found 'a.stl'") == 2);
    CHECK(folder.scratch.names() == files);
    CHECK(read_file(folder.scratch.file("square.obj")) == square);
}

// rinceau grow: what it writes, what it refuses, when it stops.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {

constexpr auto discs = R"(shape disc = disc collide = disc
param size = 0.1
axiom scatter 100 Disc
Disc ~ S(size, size, 0.01) IC("disc")
)";
constexpr auto endless = R"(shape rod = cylinder
axiom nearest 0 0 0 A
A ~ T(0.01) S(0.01) I("rod") A A
)";
/// A square of two faces.
constexpr auto square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

struct GrowFolder {
    ScratchFolder scratch;

    GrowFolder() {
        put("discs.fgsg", discs);
        put("endless.fgsg", endless);
        put("square.obj", square);
    }
    void put(const std::string& name, const std::string& text) const { write_file(scratch.file(name), text); }
    ProgramRun run(std::vector<std::string> words) const { return run_rinceau(words, {.folder = scratch.path()}); }
    std::string text(const std::string& name) const { return read_file(scratch.file(name)); }
    bool has(const std::string& name) const { return std::filesystem::exists(scratch.file(name)); }
    /// The message of a run that fails with that status and writes nothing.
    std::string refused(std::vector<std::string> words, int status) const {
        words.insert(words.end(), {"-o", "out.obj"});
        const ProgramRun failed = run(words);
        CAPTURE(failed.err);
        CHECK(failed.status == status);
        CHECK(failed.seconds < 10);
        CHECK(!has("out.obj"));
        return failed.err;
    }
};

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("growing writes by the ending of the name, the same bytes every time") {
    const GrowFolder folder;
    for (const std::string name : {"a.obj", "a.ply", "a.glb", "a.svg"}) {
        CAPTURE(name);
        CHECK(folder.run({"grow", "discs.fgsg", "-o", name}).status == 0);
        const std::string bytes = folder.text(name);
        CHECK(folder.run({"grow", "discs.fgsg", "-o", name}).status == 0);
        CHECK(folder.text(name) == bytes);
        CHECK(folder.run({"grow", "discs.fgsg", "-o", name, "--seed", "2"}).status == 0);
        CHECK(folder.text(name) != bytes);
    }
    CHECK(folder.text("a.glb").starts_with("glTF"));
    CHECK(folder.run({"grow", "discs.fgsg"}).out.starts_with("<svg"));
    CHECK(folder.run({"grow", "discs.fgsg", "--on", "square.obj"}).out.find("\nf ") != std::string::npos);
}

TEST_CASE("a picture of a pattern is a PNG of the width that is asked for") {
    const GrowFolder folder;
    CHECK(folder.run({"grow", "discs.fgsg", "--on", "square.obj", "-o", "a.png", "--width", "120", "--view", "10,50"})
              .status == 0);
    const std::string png = folder.text("a.png");
    REQUIRE(png.size() > 24);
    CHECK(png.substr(1, 3) == "PNG");
    CHECK(static_cast<unsigned char>(png[19]) == 120);
}

TEST_CASE("params are set on the command line, and the plane's piece is as large as asked for") {
    const GrowFolder folder;
    const auto shapes = [&](std::vector<std::string> words) {
        words.insert(words.end(), {"-o", "a.obj", "--report", "r.json"});
        const ProgramRun grown = folder.run(words);
        CAPTURE(grown.err);
        REQUIRE(grown.status == 0);
        return nlohmann::json::parse(folder.text("r.json"))["shapes"].get<int>();
    };
    const int usual = shapes({"grow", "discs.fgsg"});
    CHECK((usual > 20 && usual < 100));
    CHECK(shapes({"grow", "discs.fgsg", "--set", "size=0.01"}) > usual);
    CHECK(shapes({"grow", "discs.fgsg", "--set", "size=diagonal"}) == 1);
    CHECK(shapes({"grow", "discs.fgsg", "--set", "size=right-left + 0.2*(top-bottom)"}) == 1);
    CHECK(shapes({"grow", "discs.fgsg", "--size", "4,2"}) > usual);
    CHECK(holds(folder.refused({"grow", "discs.fgsg", "--set", "sice=2"}, 1), "'sice': did you mean 'size'?"));
    CHECK(holds(folder.refused({"grow", "discs.fgsg", "--set", "size=2+"}, 1), "--set size: expected a number"));
    CHECK(holds(folder.refused({"grow", "discs.fgsg", "--set", "size"}, 2), "expected NAME=VALUE"));
}

TEST_CASE("rules without an end stop at a limit: status 3, and what stands is written only if that is asked for") {
    const GrowFolder folder;
    const std::string message = folder.refused({"grow", "endless.fgsg", "--max-shapes", "2000"}, 3);
    CHECK(holds(message, "--keep-partial"));
    folder.refused({"grow", "endless.fgsg", "--seconds", "0.05"}, 3);
    const ProgramRun kept = folder.run(
        {"grow", "endless.fgsg", "--max-shapes", "2000", "--keep-partial", "-o", "part.glb", "--report", "part.json"});
    CHECK(kept.status == 3);
    CHECK(folder.text("part.glb").starts_with("glTF"));
    CHECK(nlohmann::json::parse(folder.text("part.json"))["complete"] == false);
}

TEST_CASE("Ctrl-C leaves no file behind") {
    const GrowFolder folder;
    const auto before = folder.scratch.names();
    const ProgramRun stopped = run_rinceau({"grow", "endless.fgsg", "--max-shapes", "50000000", "-o", "a.obj"},
                                           {.folder = folder.scratch.path(), .interrupt_after_ms = 300});
    CHECK(stopped.signal != 0);
    CHECK(folder.scratch.names() == before);
}

TEST_CASE("grammars with mistakes are refused with the place before anything is read or grown") {
    const GrowFolder folder;
    const auto message = [&](const std::string& text) {
        folder.put("bad.fgsg", text);
        const std::string grown = folder.refused({"grow", "bad.fgsg"}, 1);
        const ProgramRun checked = folder.run({"check", "bad.fgsg"});
        CHECK(checked.status == 1);
        CHECK(holds(grown, "bad.fgsg"));
        CHECK(holds(checked.err, "bad.fgsg"));
        return grown;
    };
    CHECK(holds(message("axiom vertex 0 Stm\nStem ~ Rz(1)\n"), "bad.fgsg:1:16: expected a symbol that has a rule"));
    CHECK(holds(message("axiom vertex 0 Rz(\n"), "bad.fgsg:1:18: expected a ')'"));
    CHECK(holds(message("shape a = boks\naxiom vertex 0 I(\"a\")\n"), "'boks'"));
    CHECK(holds(message("field F1 = curvture\naxiom vertex 0 Rz(1)\n"), "'curvture'"));
    CHECK(holds(message("shape a = mesh \"none.obj\"\naxiom vertex 0 I(\"a\")\n"), "none.obj: cannot be read"));
    CHECK(holds(message("field F = file \"none.json\"\naxiom vertex 0 Rz(1)\n"), "none.json: cannot be read"));
    CHECK(holds(message("option cull = all\naxiom vertex 0 Rz(1)\n"), "expected bracket, rule or none"));
    CHECK(holds(message("option plane = -1\naxiom vertex 0 Rz(1)\n"), "plane"));
}

TEST_CASE("what only shows when it is grown is an error with its place, too") {
    const GrowFolder folder;
    folder.put("negative.fgsg", "shape a = box\naxiom vertex 0 S(0-1) I(\"a\")\n");
    CHECK(holds(folder.refused({"grow", "negative.fgsg"}, 1), "negative.fgsg:2:"));
    folder.put("infinite.fgsg", "shape a = box\naxiom vertex 0 A(0)\nA(n) ~ S(1/n) I(\"a\")\n");
    CHECK(holds(folder.refused({"grow", "infinite.fgsg"}, 1), "infinite.fgsg:3:8: expected a finite number"));
    folder.put("far.fgsg", "axiom vertex 99 A\nA ~ Rz(1)\n");
    CHECK(holds(folder.refused({"grow", "far.fgsg", "--on", "square.obj"}, 1), "99"));
}

TEST_CASE("surfaces and fields that do not fit are refused with the reason") {
    const GrowFolder folder;
    const auto message = [&](const std::string& mesh) {
        folder.put("bad.obj", mesh);
        return folder.refused({"grow", "discs.fgsg", "--on", "bad.obj"}, 1);
    };
    CHECK(holds(message(""), "bad.obj"));
    CHECK(holds(message("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "bad.obj"));  // no area
    CHECK(holds(message("v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"), "bad.obj"));
    const std::string fin =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";  // three faces at an edge
    CHECK(holds(message(fin), "bad.obj"));
    CHECK(folder.run({"grow", "discs.fgsg", "--on", "bad.obj", "--repair", "-o", "fin.obj"}).status == 0);
    folder.put("short.json", "{\"n\": 2, \"vectors\": [[1, 0, 0], [1, 0, 0]]}");
    CHECK(holds(folder.refused({"grow", "discs.fgsg", "--on", "square.obj", "--field", "short.json"}, 1), "short.json"));
    CHECK(holds(folder.refused({"grow", "discs.fgsg", "--on", "none.obj"}, 1), "none.obj: cannot be read"));
}

TEST_CASE("options that do not go together are the command line's fault") {
    const GrowFolder folder;
    folder.refused({"grow", "discs.fgsg", "--repair"}, 2);
    folder.refused({"grow", "discs.fgsg", "--on", "square.obj", "--size", "1,1"}, 2);
    folder.refused({"grow", "discs.fgsg", "--follow", "0.5"}, 2);
    folder.refused({"grow", "discs.fgsg", "--vertex", "1", "--at", "0,0,0"}, 2);
    CHECK(folder.run({"grow", "discs.fgsg", "--on", "square.obj", "-o", "a.svg"}).status == 2);
    CHECK(folder.run({"grow", "discs.fgsg", "-o", "a.lsys"}).status == 2);
    CHECK(run_rinceau({"grow", sample("rosette.lsys"), "--set", "a=1"}).status == 2);
}

TEST_CASE("verbs for drawings say what to use for a shape grammar instead") {
    const GrowFolder folder;
    for (const std::string verb : {"derive", "render", "analyze", "set"}) {
        CAPTURE(verb);
        const ProgramRun run = folder.run({verb, "discs.fgsg"});
        CHECK(run.status == 1);
        CHECK(holds(run.err, "'rinceau grow'"));
    }
}

TEST_CASE("a good shape grammar is checked as good, with hints for what is perhaps not meant") {
    const GrowFolder folder;
    const ProgramRun good = folder.run({"check", "discs.fgsg"});
    CHECK(good.status == 0);
    CHECK(good.err.empty());
    const ProgramRun endless_run = folder.run({"check", "endless.fgsg"});
    CHECK(endless_run.status == 0);
    CHECK(holds(endless_run.err, "hint: the symbol 'A' goes on for ever"));
    folder.put("odd.fgsg", "param u = 1\nshape a = box\naxiom vertex 0 Rz(1)\nB ~ Rz(2)\n");
    const ProgramRun odd = folder.run({"check", "odd.fgsg"});
    CHECK(odd.status == 0);
    CHECK(holds(odd.err, "the param 'u' is never used"));
    CHECK(holds(odd.err, "the shape 'a' is never placed"));
    CHECK(holds(odd.err, "no axiom leads to the symbol 'B'"));
}

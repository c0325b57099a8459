// rinceau field: designs, smoothing with the count of singular points, saving and reading back, pictures.

#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace rinceau::test;
using Json = nlohmann::json;

namespace {

struct FieldFolder {
    ScratchFolder scratch;

    FieldFolder() { std::filesystem::create_directory_symlink(sample(""), scratch.path() / "samples"); }
    ProgramRun run(std::vector<std::string> words) const {
        words.insert(words.begin(), "field");
        const ProgramRun run = run_rinceau(words, {.folder = scratch.path()});
        CAPTURE(words, run.err);
        REQUIRE(run.status == 0);
        return run;
    }
    std::string text(const std::string& name) const { return read_file(scratch.file(name)); }
    Json json(const std::string& name) const { return Json::parse(text(name)); }
};

const std::string sphere = "samples/surface/sphere.obj", vase = "samples/surface/vase.obj";

/// The text of the blocks of a page that open with ```kind.
std::vector<std::string> blocks_of(const std::string& page, const std::string& kind) {
    std::vector<std::string> blocks;
    const std::string open = "\n```" + kind + "\n", close = "\n```\n";
    for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
        at += open.size();
        blocks.push_back(page.substr(at, page.find(close, at) + 1 - at));
    }
    return blocks;
}

}  // namespace

TEST_CASE("A field says its singular points before and after smoothing, and their sum is the Euler characteristic") {
    const FieldFolder folder;
    const ProgramRun smoothed = folder.run({sphere, "--curvature", "--smooth", "1", "-o", "a.json", "--report", "r.json"});
    const Json points = folder.json("r.json")["singularities"];
    CHECK(points["before"] > points["after"]);
    CHECK(points["sum"] == 2);
    CHECK(points["euler"] == 2);
    CHECK(smoothed.err.find("after smoothing; their indices sum to 4/2, Euler characteristic 2") != std::string::npos);
    folder.run({sphere, "--smoothest", "-o", "a.json", "--report", "r.json"});
    // the least that a line field on a sphere can have
    CHECK(folder.json("r.json")["singularities"]["by_index"] == Json::parse(R"([{"index": 0.5, "count": 4}])"));
}

TEST_CASE("A saved field reads back: to the bit by edges, and to rounding in space") {
    const FieldFolder folder;
    folder.run({sphere, "--element", "wedge,100", "--element", "trisector,500,30", "-o", "edge.json", "--frame", "edge"});
    folder.run({sphere, "--field", "edge.json", "-o", "again.json", "--frame", "edge", "-o", "space.json"});
    CHECK(folder.text("again.json") == folder.text("edge.json"));
    folder.run({sphere, "--field", "space.json", "-o", "back.json", "--frame", "edge"});
    const Json there = folder.json("edge.json")["z"], back = folder.json("back.json")["z"];
    REQUIRE(there.size() == back.size());
    double worst = 0;
    for (std::size_t v = 0; v < there.size(); ++v)
        for (std::size_t part = 0; part < 2; ++part)
            worst = std::max(worst, std::abs(there[v][part].get<double>() - back[v][part].get<double>()));
    CHECK(worst < 1e-9);
}

TEST_CASE("One run writes values, a picture and lines, the same bytes every time") {
    const FieldFolder folder;
    const std::vector<std::string> names{"a.json", "a.png", "a.glb", "a.ply", "a.obj"};
    std::vector<std::string> words{vase, "--elements", "samples/surface/design.json", "--lines", "0.05", "--width", "90"};
    for (const std::string& name : names) words.insert(words.end(), {"-o", name});
    folder.run(words);
    std::vector<std::string> first;
    for (const std::string& name : names) first.push_back(folder.text(name));
    folder.run(words);
    for (std::size_t i = 0; i < names.size(); ++i) {
        CAPTURE(names[i]);
        CHECK(folder.text(names[i]) == first[i]);
    }
    CHECK(first[1].substr(1, 3) == "PNG");
    CHECK(static_cast<unsigned char>(first[1][19]) == 90);
    CHECK(first[2].starts_with("glTF"));
    folder.run({"--size", "2,1", "--source", "vortex x=0.2", "-o", "a.svg"});
    CHECK(folder.text("a.svg").starts_with("<svg"));
}

TEST_CASE("The examples of the fields' page work") {
    const FieldFolder folder;
    const std::string page = read_file(std::string(RINCEAU_SOURCE_DIR) + "/docs/fields.md");
    const auto commands = page_commands("docs/fields.md");
    CHECK(commands.size() >= 4);
    for (const std::vector<std::string>& command : commands) {
        CAPTURE(command);
        CHECK(run_rinceau(command, {.folder = folder.scratch.path()}).status == 0);
    }
    const auto examples = blocks_of(page, "json");
    REQUIRE(examples.size() == 2);
    write_file(folder.scratch.file("design.json"), examples[0]);
    folder.run({vase, "--elements", "design.json", "-o", "a.json"});
    write_file(folder.scratch.file("saved.json"), examples[1]);
    write_file(folder.scratch.file("face.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.run({"face.obj", "--field", "saved.json", "-o", "b.json"});
}

// rinceau pack as a user types it: what it writes, and what it says of bad input.

#include <algorithm>
#include <regex>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

std::string growth_sample(const std::string& name) { return sample("growth/" + name); }

std::string svg(const std::string& inside) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\">\n" + inside + "\n</svg>\n";
}

ProgramRun pack(const Words& words) {
    Words all{"pack"};
    all.insert(all.end(), words.begin(), words.end());
    return run_rinceau(all);
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace

TEST_CASE("Trees are packed into a picture, a grammar that draws the same, placements and a report that agree") {
    const ScratchFolder scratch;
    const auto into = [&](const std::string& name) {
        return Words{
            growth_sample("trees.svg"),  "--size", "300,200", "--scale", "0.2,0.6", "-o", scratch.file(name), "--report",
            scratch.file("report.json"), "--seed", "4"};
    };
    REQUIRE(pack(into("out.svg")).status == 0);
    const Json report = Json::parse(read_file(scratch.file("report.json")));
    REQUIRE(pack(into("out.json")).status == 0);
    REQUIRE(pack(into("out.lsys")).status == 0);
    CHECK(report["overlaps"] == 0);
    CHECK(report["complete"] == true);
    CHECK(report["coverage"] > 0.4);
    CHECK(report["autocorrelation"] < 0.3);
    const Json placements = Json::parse(read_file(scratch.file("out.json")));
    CHECK(placements["placements"].size() == report["placed"]);
    CHECK(placements["shapes"].size() == 2);
    double covered = 0;
    for (const Json& placed : placements["placements"]) {
        CHECK((placed["scale"] >= 0.2 && placed["scale"] <= 0.6));
        CHECK((placed["x"] > 0 && placed["x"] < 300 && placed["y"] > 0 && placed["y"] < 200));
        const double scale = placed["scale"];
        covered += scale * scale * placements["shapes"][placed["shape"].get<std::size_t>()]["area"].get<double>();
    }
    CHECK(covered / (300 * 200) == Approx(report["coverage"].get<double>()).epsilon(1e-6));
    // The grammar draws what the picture shows.
    const ProgramRun rendered = run_rinceau({"render", scratch.file("out.lsys")});
    CHECK(rendered.status == 0);
    const auto uses = [](const std::string& text) { return count_of(text, "<use "); };
    CHECK(uses(rendered.out) == uses(read_file(scratch.file("out.svg"))));
    CHECK(uses(rendered.out) >= report["placed"].get<std::size_t>());
}

TEST_CASE("The same command packs the same bytes, at any number of threads, and another seed packs others") {
    const Words words{growth_sample("leather.svg"), "--size", "120,90", "--scale", "0.3,0.5", "--tile"};
    const auto with = [&](Words more) {
        more.insert(more.begin(), words.begin(), words.end());
        return pack(more).out;
    };
    const std::string once = with({"--threads", "1"});
    CHECK(once.starts_with("<svg"));
    CHECK(once == with({"--threads", "3"}));
    CHECK(once != with({"--seed", "2"}));
}

TEST_CASE("Several drawings are a shape each, with their own paint and names") {
    const ScratchFolder scratch;
    const ProgramRun run =
        pack({growth_sample("toy_plane.svg"), growth_sample("toy_dinosaur.svg"), "--size", "400,300", "--scale", "0.5",
              "--shares", "toy_plane=3", "--share-tolerance", "0", "--report", scratch.file("r.json")});
    REQUIRE(run.status == 0);
    CHECK(run.out.find("#d9573f") != std::string::npos);
    CHECK(run.out.find("#5c9e6e") != std::string::npos);
    const Json shapes = Json::parse(read_file(scratch.file("r.json")))["shapes"];
    CHECK(shapes[0]["symbol"] == "toy_plane");
    CHECK(shapes[0]["placed"].get<double>() == Approx(3 * shapes[1]["placed"].get<double>()).margin(3));
    const ProgramRun unknown = pack({growth_sample("toy_plane.svg"), "--size", "400,300", "--shares", "Boat=2"});
    CHECK(unknown.status == 1);
    CHECK(unknown.err.find("no shape is called 'Boat'") != std::string::npos);
}

TEST_CASE("Meshes are packed on the ground, as one mesh or as instances") {
    const ScratchFolder scratch;
    const Words words{growth_sample("brick.obj"), growth_sample("jack.obj"), "--size", "8,6", "-o"};
    const auto into = [&](const std::string& name) {
        Words all = words;
        all.push_back(scratch.file(name));
        return pack(all);
    };
    REQUIRE(into("pile.obj").status == 0);
    REQUIRE(into("pile.glb").status == 0);
    REQUIRE(into("pile.svg").status == 0);
    const std::string obj = read_file(scratch.file("pile.obj")), glb = read_file(scratch.file("pile.glb"));
    CHECK(glb.starts_with("glTF"));
    CHECK(count_of(glb, "\"translation\"") == count_of(obj, "\ng ") + 1);
    CHECK(count_of(glb, "\"primitives\"") == 2);
    CHECK(glb.size() < obj.size());
    std::smatch vertex;
    double low = 1e9, far = 0;
    for (std::string rest = obj.substr(0, 20000); std::regex_search(rest, vertex, std::regex("v (\\S+) (\\S+) (\\S+)\n"));
         rest = vertex.suffix()) {
        low = std::min(low, std::stod(vertex[2]));
        far = std::max(far, std::abs(std::stod(vertex[1])));
    }
    CHECK(low == Approx(0).margin(1e-9));  // y is up: all stand on the ground
    CHECK(far <= 4);
}

TEST_CASE("Aggregates keep to regions with holes, to circles about shapes, and to reliefs") {
    const ScratchFolder scratch;
    const ProgramRun pond = pack({growth_sample("leather.svg"), "--region", growth_sample("pond.svg"), "--scale", "0.7",
                                  "-o", scratch.file("pond.json"), "--height-map", scratch.file("h.png"), "--shaded",
                                  scratch.file("s.png"), "--width", "200"});
    REQUIRE(pond.status == 0);
    const Json placements = Json::parse(read_file(scratch.file("pond.json")));
    for (const Json& placed : placements["placements"]) {
        const double x = placed["x"], y = placed["y"];
        CHECK(std::hypot(x - 370, y - 240) > 78);
    }
    CHECK(read_file(scratch.file("h.png")).substr(1, 3) == "PNG");
    CHECK(read_file(scratch.file("s.png")).substr(1, 3) == "PNG");
    const auto placed = [&](const Words& more) {
        Words all{growth_sample("toy_plane.svg"), "--size", "500,400", "--scale", "0.5", "-o", scratch.file("c.json")};
        all.insert(all.end(), more.begin(), more.end());
        REQUIRE(pack(all).status == 0);
        return Json::parse(read_file(scratch.file("c.json")))["placements"].size();
    };
    CHECK(static_cast<double>(placed({})) > 1.3 * static_cast<double>(placed({"--regions", "circle"})));
    CHECK(placed({}) > placed({"--margin", "10"}));
}

TEST_CASE("pack --seconds writes what stands by then, with status 3") {
    const ScratchFolder scratch;
    const ProgramRun run = pack({growth_sample("leather.svg"), "--size", "4000,4000", "--scale", "0.2", "--method", "naive",
                                 "--stop", "1000000000", "--seconds", "0.2", "-o", scratch.file("part.json")});
    CHECK(run.status == 3);
    CHECK(run.err.find("--seconds") != std::string::npos);
    CHECK(Json::parse(read_file(scratch.file("part.json")))["placements"].size() > 10);
}

TEST_CASE("Bad input of pack: one clear message, the right status, nothing written") {
    const ScratchFolder scratch;
    const auto file = [&](const std::string& name, const std::string& bytes) {
        write_file(scratch.file(name), bytes);
        return scratch.file(name);
    };
    const std::string square = file("square.svg", svg("<rect width=\"40\" height=\"40\"/>"));
    const std::string line = file("line.svg", svg("<path d=\"M0 0L50 50\" fill=\"none\" stroke=\"none\"/>"));
    const std::string crossing = file("crossing.svg", svg("<path d=\"M0 0L100 100L100 0L0 100Z\"/>"));
    const std::string tiny = file("tiny.svg", svg("<rect width=\"10\" height=\"10\"/>"));
    const std::string apart = file("apart.svg", svg("<rect x=\"70\" y=\"70\" width=\"20\" height=\"20\"/>"));
    const std::string flat = file("flat.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    const std::string output = scratch.file("out.svg");
    struct Bad {
        Words words;
        int status;
        std::string message;
    };
    const std::vector<Bad> bad = {
        {{line, "--size", "100,100"}, 1, "line.svg"},
        {{square, "--region", tiny}, 1, "tiny.svg"},
        {{square, "--region", crossing}, 1, "crossing.svg"},
        {{square, "--size", "100,100", "--margin", "-30"}, 1, "square.svg"},
        {{square, "--size", "100,100", "--regions", apart}, 1, "apart.svg: --regions: outline 1 is not drawn over"},
        {{square, "--size", "20,20"}, 1, "square.svg"},
        {{square, "--size", "100,100", "--density", square}, 1, "square.svg: expected a PNG picture"},
        {{square, "--size", "100,100", "--flow", tiny + ".not"}, 1, "cannot be read"},
        {{flat, "--size", "9,9"}, 1, "flat.obj: seen from above, the mesh has no area"},
        {{square, "--size", "100,100", "--tile"}, 1, "square.svg"},
        {{square}, 2, "expected either --size W,H or --region FILE"},
        {{square, "--size", "100"}, 2, "--size"},
        {{square, "--size", "100,nan"}, 2, "--size"},
        {{square, "--region", tiny, "--tile"}, 2, "--tile"},
        {{square, "--size", "100,100", "--scale", "2,1"}, 2, "--scale"},
        {{square, "--size", "100,100", "--angles", "90..0"}, 2, "--angles"},
        {{square, "--size", "100,100", "--method", "magic"}, 2, "--method"},
        {{square, flat, "--size", "100,100"}, 2, "found both"},
    };
    for (const Bad& each : bad) {
        Words words = each.words;
        words.insert(words.end(), {"-o", output});
        const ProgramRun run = pack(words);
        CAPTURE(words, run.err);
        CHECK(run.status == each.status);
        CHECK(run.err.find(each.message) != std::string::npos);
        CHECK(run.out.empty());
        CHECK_FALSE(std::filesystem::exists(output));
    }
    const ProgramRun meshes =
        pack({square, "--size", "100,100", "--meshes", flat + "," + flat, "-o", scratch.file("o.glb")});
    CHECK(meshes.status == 1);
    CHECK(meshes.err.find("expected a mesh for each of the 1 shapes, found 2") != std::string::npos);
    CHECK(pack({square, "--size", "100,100", "-o", scratch.file("o.glb")}).status == 2);
}

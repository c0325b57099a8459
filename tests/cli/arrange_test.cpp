// rinceau arrange: what it writes, and what it refuses.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "program.h"

using namespace rinceau::test;

namespace {

const std::string dots = sample("growth/dots.svg");

std::string svg(const std::string& shapes) {
    return "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='160'>" + shapes + "</svg>";
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// Runs arrange on a guide with these shapes, named in the place of GUIDE.
ProgramRun run_with_guide(const std::string& shapes, std::vector<std::string> words) {
    const ScratchFolder scratch;
    write_file(scratch.file("guide.svg"), svg(shapes));
    for (std::string& word : words) word = std::regex_replace(word, std::regex("GUIDE"), scratch.file("guide.svg"));
    words.insert(words.begin(), "arrange");
    return run_rinceau(words);
}

}  // namespace

TEST_CASE("arrange draws as many elements as it is asked for, again with the same bytes, and says how like they are") {
    const ScratchFolder scratch;
    const std::string report = scratch.file("report.json");
    const ProgramRun run = run_rinceau({"arrange", dots, "--count", "80", "--report", report});
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    CHECK(occurrences(run.out, "<use") == 80);
    CHECK(run_rinceau({"arrange", dots, "--count", "80", "--threads", "1"}).out == run.out);
    const auto json = nlohmann::json::parse(read_file(report));
    CHECK(json["elements"] == 80);
    CHECK(json["overlaps"] == 0);
    CHECK(json["complete"] == true);
}

TEST_CASE("arrange writes a grammar that draws the same picture") {
    const ScratchFolder scratch;
    const std::string rules = scratch.file("more.lsys");
    REQUIRE(run_rinceau({"arrange", dots, "--count", "30", "--jitter", "angle=20,color=0.2", "-o", rules}).status == 0);
    const ProgramRun drawn = run_rinceau({"render", rules});
    CAPTURE(drawn.err);
    CHECK(drawn.status == 0);
    CHECK(occurrences(drawn.out, "<use") == 30);
    CHECK(run_rinceau({"arrange", rules, "--count", "30"}).status == 0);  // and is an exemplar itself
}

TEST_CASE("arrange fills a canvas to its edges, and a region without crossing its outline") {
    const ProgramRun canvas = run_rinceau({"arrange", dots, "--size", "150,100"});
    CHECK(canvas.status == 0);
    CHECK(canvas.out.find("width=\"150\" height=\"100\"") != std::string::npos);
    CHECK(occurrences(canvas.out, "<use") > 24);  // 150 x 100 at a spacing of 24

    const ScratchFolder scratch;
    const std::string report = scratch.file("report.json");
    const ProgramRun region =
        run_with_guide("<rect x='10' y='10' width='180' height='140'/><circle cx='100' cy='80' r='30'/>",
                       {dots, "--region", "GUIDE", "--report", report});
    CAPTURE(region.err);
    CHECK(region.status == 0);
    const auto json = nlohmann::json::parse(read_file(report));
    CHECK(json["over_boundary"] == 0);
    CHECK(json["elements"] > 15);
}

TEST_CASE("arrange grows along a flow, under a brush and beside lines") {
    const std::string line = "<path fill='none' stroke='red' d='M20 80 Q100 20 180 80'/>";
    CHECK(run_with_guide(line, {dots, "--flow", "GUIDE", "--undirected", "--count", "30"}).status == 0);
    CHECK(run_with_guide(line, {dots, "--spray", "GUIDE,30"}).status == 0);
    const ProgramRun beside = run_with_guide(line, {dots, "--boundary", "GUIDE", "--mode", "rotate"});
    CHECK(beside.status == 0);
    CHECK(occurrences(beside.out, "<use") > 20);
}

TEST_CASE("arrange that runs out of time writes what it has") {
    const ProgramRun run = run_rinceau({"arrange", dots, "--count", "1000000", "--seconds", "0.05"});
    CHECK(run.status == 3);
    CHECK(run.err.find("--seconds reached after") != std::string::npos);
    CHECK(run.out.find("</svg>") != std::string::npos);
}

TEST_CASE("arrange draws who is whose neighbour") {
    const ScratchFolder scratch;
    const std::string edges = scratch.file("edges.svg"), numbers = scratch.file("numbers.svg");
    REQUIRE(run_rinceau({"arrange", dots, "--count", "20", "--connectivity", edges, "--numbering", numbers}).status == 0);
    CHECK(occurrences(read_file(edges), "<use") == 20);
    CHECK(occurrences(read_file(numbers), "<path") > 56);  // outlines, edges and numbers
}

TEST_CASE("arrange says what is wrong with its inputs, and writes nothing") {
    const auto refused = [](const ProgramRun& run, int status, const std::string& message) {
        CAPTURE(run.err, message);
        CHECK(run.status == status);
        CHECK(run.err.find(message) != std::string::npos);
        CHECK(run.out.empty());
    };
    refused(run_rinceau({"arrange", "-"}, {.input = svg("<rect width='9' height='9'/><rect x='20' width='9' height='9'/>")}),
            1, "<stdin>: ");
    refused(run_rinceau({"arrange", "-"},
                        {.input = svg("<rect width='9' height='9'/><rect x='20' width='9' height='9'/>"
                                      "<rect y='20' width='9' height='9'/><rect x='20' y='20' width='9' height='9'/>")}),
            1, "neighbours on all sides");
    refused(run_with_guide("<rect width='9' height='9'/>", {dots, "--region", "GUIDE"}), 1, "no element of");
    refused(run_with_guide("<path d='M0 0L90 90L90 0L0 90Z'/>", {dots, "--region", "GUIDE"}), 1,
            "crosses itself near (45, 45)");
    refused(run_with_guide("", {dots, "--flow", "GUIDE"}), 1, "strokes that show the flow");
    refused(run_with_guide("", {dots, "--spray", "GUIDE,20"}), 1, "lines for the brush");
    refused(run_with_guide("", {dots, "--boundary", "GUIDE"}), 1, "boundary lines");
    refused(run_rinceau({"arrange", dots, "--element", "Nobody"}), 1, "Nobody");
    refused(run_rinceau({"arrange", dots, "--flip-edges", "1-50"}), 1, "1");
    refused(run_rinceau({"arrange", dots, "--priority", "Nobody=2"}), 2, "expected a symbol of the exemplar (");
    refused(run_rinceau({"arrange", dots, "--mode", "flow"}), 2, "--flow");
    refused(run_rinceau({"arrange", dots, "--jitter", "angle=200"}), 2, "0 to 180");
    refused(run_rinceau({"arrange", dots, "--jitter", "scale=2"}), 2, "scale from 0 to 1");
    refused(run_rinceau({"arrange", dots, "--spray", "20"}), 2, "PATH.svg,RADIUS");
    refused(run_rinceau({"arrange", dots, "--size", "20"}), 2, "W,H");
    refused(run_rinceau({"arrange", dots, "-o", "more.txt"}), 2, ".lsys");
    refused(run_rinceau({"arrange", dots, "-o", "nowhere/more.svg"}), 4, "nowhere/more.svg");
}

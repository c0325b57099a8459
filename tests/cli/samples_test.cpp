// The committed samples: what their grammars draw, and what is found in their drawings.

#include <cstdlib>
#include <map>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace rinceau::test;
using Json = nlohmann::json;

namespace {

std::string with_ending(const std::string& name, const std::string& ending) {
    return std::filesystem::path(name).replace_extension(ending).string();
}

Json report_of(const std::string& drawing) {
    const ScratchFolder scratch;
    const std::string report = scratch.file("report.json");
    const ProgramRun run = run_rinceau({"analyze", drawing, "--report", report});
    INFO(run.err);
    REQUIRE(run.status == 0);
    return Json::parse(read_file(report));
}

// "ring 12" -> how often, over all productions and all their lengths in use.
std::map<std::string, int> rules_of(const Json& report) {
    std::map<std::string, int> rules;
    for (const Json& production : report["productions"])
        for (const Json& length : production["lengths"])
            ++rules[production["kind"].get<std::string>() + " " + std::to_string(length.get<int>())];
    return rules;
}

}  // namespace

TEST_CASE("Every sample's drawing is what its grammar draws, byte for byte") {
    const std::vector<std::string> grammars = all_samples(".lsys");
    CHECK(grammars.size() >= 16);
    CHECK(grammars.size() == all_samples(".svg").size());
    for (const std::string& grammar : grammars) {
        CAPTURE(grammar);
        const ProgramRun run = run_rinceau({"render", grammar});
        REQUIRE(run.status == 0);
        const std::string drawing = with_ending(grammar, ".svg");
        if (std::getenv("RINCEAU_UPDATE_GOLDEN") != nullptr) write_file(drawing, run.out);
        const bool same_bytes = run.out == read_file(drawing);
        CHECK(same_bytes);
        CHECK(run.out.size() < 200'000);
    }
}

TEST_CASE("The plants have no mistake and can be drawn") {
    for (const std::string& grammar : all_samples_in("plants", ".lsys")) {
        CAPTURE(grammar);
        const ProgramRun check = run_rinceau({"check", grammar});
        CHECK(check.err == "");
        CHECK(check.status == 0);
        const ProgramRun run = run_rinceau({"render", grammar});
        CHECK(run.status == 0);
        CHECK(run.out.find("<use ") != std::string::npos);
    }
}

TEST_CASE("No sample's grammar has a mistake") {
    for (const std::string& grammar : all_samples(".lsys")) {
        const ProgramRun run = run_rinceau({"check", grammar});
        CHECK(run.err == "");
        CHECK(run.status == 0);
    }
}

TEST_CASE("In every sample the rules that a person sees are found") {
    const Json expected = Json::parse(read_file(sample("expected.json")));
    CHECK(expected.size() == all_samples(".svg").size());
    for (const Json& row : expected) {
        CAPTURE(row["file"]);
        if (row.contains("chance")) continue;
        const Json report = report_of(sample(row["file"]));
        CHECK(report["elements"] == row["elements"]);
        CHECK(report["terminals"].size() == row["terminals"]);
        const std::map<std::string, int> found = rules_of(report);
        for (const Json& rule : row["rules"]) {
            CAPTURE(rule, report["productions"].dump(1), report["axiom"]);
            CHECK(found.count(rule.get<std::string>()) == 1);
        }
        if (row.contains("productions")) CHECK(report["productions"].size() == row["productions"]);
    }
}

TEST_CASE("The same drawing gives the same grammar at any number of threads") {
    for (const std::string name : {"mandala.svg", "keyboard.svg", "fig08_clutter.svg"}) {
        CAPTURE(name);
        const ProgramRun one = run_rinceau({"analyze", sample(name), "-o", "-", "--threads", "1"});
        const ProgramRun two = run_rinceau({"analyze", sample(name), "-o", "-", "--threads", "2"});
        REQUIRE(one.status == 0);
        CHECK(one.out == two.out);
        CHECK_FALSE(one.out.empty());
    }
}

// Long outputs are written while they are derived.

#include <csignal>

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;

namespace {

constexpr long mebibyte = 1024;  // in KiB

/// Koch's curve of 4^steps lines.
std::string koch(int steps) {
    return "lsystem 1\ncanvas 0 0 100 100\naxiom: F(" + std::to_string(steps) +
           ")\nF(n) : n > 0 -> F(n-1) +(60) F(n-1) -(120) F(n-1) +(60) F(n-1)\nF(n) : n == 0 -> Line f(1)\n"
           "style 1: fill none; stroke black\nterminal Line: style 1; path \"M0 0V-1\"\n";
}

ProgramRun run_to(const std::string& verb, const std::string& rules, const std::string& output, int interrupt_after_ms = 0) {
    return run_rinceau({verb, "-", "-o", output, "--max-modules", "100000000"},
                       {.input = rules, .interrupt_after_ms = interrupt_after_ms});
}

}  // namespace

TEST_CASE("The string of modules is written in memory that does not grow with it") {
    const ScratchFolder scratch;
    const std::string output = scratch.file("string.txt");
    const ProgramRun small = run_to("derive", koch(4), output);
    REQUIRE(small.status == 0);
    const auto small_size = std::filesystem::file_size(output);
    const ProgramRun large = run_to("derive", koch(10), output);
    REQUIRE(large.status == 0);
    CHECK(std::filesystem::file_size(output) > 1000 * small_size);
    CHECK(std::filesystem::file_size(output) > 10'000'000);
    CHECK(large.peak_kib < small.peak_kib + 4 * mebibyte);
}

TEST_CASE("A picture is written in memory that does not grow with it, byte for byte as a short one") {
    const ScratchFolder scratch;
    const std::string output = scratch.file("picture.svg");
    const ProgramRun small = run_to("render", koch(3), output);
    REQUIRE(small.status == 0);
    CHECK(read_file(output) == run_rinceau({"render", "-"}, {.input = koch(3)}).out);
    const ProgramRun large = run_to("render", koch(8), output);
    REQUIRE(large.status == 0);
    CHECK(std::filesystem::file_size(output) > 4'000'000);
#ifndef RINCEAU_SANITIZED  // the address sanitizer keeps what is freed for a while
    CHECK(large.peak_kib < small.peak_kib + 4 * mebibyte);
#endif
}

TEST_CASE("A string that is interrupted or fails far behind its beginning leaves the old file and nothing beside it") {
    const ScratchFolder scratch;
    const std::string name = scratch.file("string.txt");
    write_file(name, "old");
    const ProgramRun interrupted = run_to("derive", koch(12), name, 300);
    CHECK(interrupted.signal == SIGINT);
    CHECK(read_file(name) == "old");
    const std::string fails_late =
        "lsystem 1\naxiom: F(9) P(0)\nF(n) : n > 0 -> F(n-1) F(n-1) F(n-1) F(n-1)\nP(n) -> X(1/n)\n";
    const ProgramRun failed = run_to("derive", fails_late, name);
    CHECK(failed.status == 1);
    CHECK(read_file(name) == "old");
    CHECK(scratch.names() == std::vector<std::string>{"string.txt"});
}

TEST_CASE("What fails early leaves nothing on standard output") {
    const ProgramRun run = run_rinceau({"derive", "-"}, {.input = "lsystem 1\naxiom: A(1) B(1/0*0) C\nA(n) -> D E(n/0)\n"});
    CHECK(run.status == 1);
    CHECK(run.out.empty());
}

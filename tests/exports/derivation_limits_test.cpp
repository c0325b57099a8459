// The limits of a derivation hold in every export that has to derive.

#include <catch2/catch.hpp>

#include "exports/cfdg.h"
#include "exports/lindenmayer.h"
#include "exports/svg_clones.h"
#include "lsystem/grammar_text.h"
#include "scene/input_error.h"

using namespace rinceau;

namespace {

const std::string row = "lsystem 1\naxiom: P(1000)\nP(m) : m > 0 -> [A] f(2) P(m-1)\nterminal A: path \"M0 0H1V-2Z\"\n";

ExportOptions modules(std::uint64_t most) {
    ExportOptions options;
    options.derive.max_modules = most;
    return options;
}

}  // namespace

TEST_CASE("exports that look at the whole derivation stop at the most modules that it may have") {
    const Grammar grammar = parse_grammar(row);
    for (const auto& write : {to_cfdg, to_lindenmayer, to_svg_clones}) {
        CHECK_THROWS_AS(write(grammar, modules(100)), LimitError);
        CHECK_FALSE(write(grammar, modules(100'000)).bytes.empty());
    }
}

// Derives and interprets a grammar on one core: processor seconds, what is drawn and the peak of memory, as JSON.
// usage: interpreter_bench stream|list GRAMMAR

#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

namespace {

/// Of where the terminals stand: equal for programs that draw the same.
struct Drawn {
    std::size_t lines = 0;
    double sum = 0;

    void add(const Placement& placement) {
        ++lines;
        sum += placement.pose.translation.x + placement.pose.translation.y;
    }
};

Drawn draw(const Grammar& grammar, bool list) {
    InterpretOptions options;
    options.derive.max_modules = 100'000'000;
    Drawn drawn;
    if (list) {
        for (const Placement& placement : interpret(grammar, options)) drawn.add(placement);
    } else {
        visit_placements(grammar, options, [&](const Placement& placement) { drawn.add(placement); });
    }
    return drawn;
}

/// The largest resident set of the process, in KiB. (getrusage would begin with that of the program which started it.)
long peak_kib() {
    std::ifstream status("/proc/self/status");
    const std::string key = "VmHWM:";
    for (std::string word; status >> word;) {
        if (long size = 0; word == key && status >> size) return size;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string mode = argc == 3 ? argv[1] : "";
    if (mode != "stream" && mode != "list") {
        std::fprintf(stderr, "usage: interpreter_bench stream|list GRAMMAR\n");
        return 2;
    }
    std::ifstream file(argv[2]);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::clock_t start = std::clock();
    const Drawn drawn = draw(parse_grammar(text, argv[2]), mode == "list");
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("{\"lines\": %zu, \"sum\": %.17g, \"seconds\": %.6f, \"peak_kib\": %ld}\n", drawn.lines, drawn.sum, seconds,
                peak_kib());
}

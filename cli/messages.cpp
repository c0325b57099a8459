#include "cli/messages.h"

#include <cstdio>

namespace rinceau {

void say(const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }

void say_memory_does_not_suffice() noexcept {
    std::fwrite(memory_does_not_suffice.data(), 1, memory_does_not_suffice.size(), stderr);
}

void say_warnings(const std::vector<Warning>& warnings) {
    for (const Warning& warning : warnings) say("warning: " + located(warning.place, warning.message));
}

}  // namespace rinceau

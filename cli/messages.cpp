#include "cli/messages.h"

#include <cstdio>

namespace rinceau {

void say(const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }

void say_memory_does_not_suffice() noexcept {
    std::fputs("rinceau: the memory does not suffice; allow it more (ulimit -v), or give it less to do\n", stderr);
}

void say_warnings(const std::vector<Warning>& warnings) {
    for (const Warning& warning : warnings) say("warning: " + located(warning.place, warning.message));
}

}  // namespace rinceau

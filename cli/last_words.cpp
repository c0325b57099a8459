#include "cli/last_words.h"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <string_view>

#include "cli/exit_status.h"
#include "cli/messages.h"

namespace rinceau {
namespace {

/// More than libraries ask for at once.
bool is_memory_left() {
    constexpr std::size_t enough = std::size_t{64} << 20;
    void* place = ::mmap(nullptr, enough, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED) return false;
    ::munmap(place, enough);
    return true;
}

/// Does only what may be done in the middle of anything.
extern "C" void speak_and_end(int signal) {
    if (!is_memory_left()) {
        const std::string_view words = memory_does_not_suffice;
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, words.data(), words.size());
        ::_exit(exit_status::limit_reached);
    }
    ::raise(signal);  // which is as it was before, and waits for the end of this function
}

/// Not that of the program, which may be what cannot grow.
void use_own_stack() {
    constexpr std::size_t size = std::size_t{64} << 10;
    static std::array<std::byte, size> room;
    stack_t stack{};
    stack.ss_sp = room.data();
    stack.ss_size = room.size();
    ::sigaltstack(&stack, nullptr);
}

}  // namespace

void tell_when_memory_ends() {
    use_own_stack();
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGTRAP}) {
        struct sigaction before {};
        if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;  // a tool looks after it
        struct sigaction action {};
        action.sa_handler = speak_and_end;
        action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
        ::sigaction(signal, &action, nullptr);
    }
}

}  // namespace rinceau

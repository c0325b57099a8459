#include "files/signals_held.h"

#include <unistd.h>

#include <array>

namespace rinceau {
namespace {
constexpr std::array ending_signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};
}  // namespace

SignalsHeld::SignalsHeld() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : ending_signals) sigaddset(&held, signal);
    pthread_sigmask(SIG_BLOCK, &held, &before_);
}

SignalsHeld::~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

bool SignalsHeld::waiting() const {
    sigset_t pending;
    sigpending(&pending);
    for (const int signal : ending_signals) {
        if (sigismember(&pending, signal) != 1 || sigismember(&before_, signal) == 1) continue;
        struct sigaction action {};
        sigaction(signal, nullptr, &action);
        if (action.sa_handler != SIG_IGN) return true;
    }
    return false;
}

bool let_writes_fail() {
    ::signal(SIGXFSZ, SIG_IGN);
    return ::signal(SIGPIPE, SIG_IGN) == SIG_DFL;
}

void end_at_broken_pipe() {
    constexpr int as_shells_say_it = 128 + SIGPIPE;  // if the signal is blocked
    ::signal(SIGPIPE, SIG_DFL);
    ::raise(SIGPIPE);
    ::_exit(as_shells_say_it);
}

}  // namespace rinceau

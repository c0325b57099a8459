#pragma once
// Signals that would end the program.

#include <signal.h>

namespace rinceau {

/// While it lives, signals that would end the program wait.
class SignalsHeld {
  public:
    SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    ~SignalsHeld();

    /// Does one wait that would end the program?
    bool waiting() const;

  private:
    sigset_t before_{};
};

/// From now on write() fails where a signal would have ended the program: at a pipe that nobody reads any more, and at a
/// file that becomes larger than is allowed. Would such a pipe have ended it?
bool let_writes_fail();

/// Ends the program as it would have ended at a pipe that nobody reads any more: without a word, by SIGPIPE.
[[noreturn]] void end_at_broken_pipe();

}  // namespace rinceau

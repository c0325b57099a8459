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

}  // namespace rinceau

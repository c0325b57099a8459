#pragma once
// Many pieces of work, each in a process of its own: what crashes, hangs or eats memory is one piece alone.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "files/signals_held.h"

namespace rinceau {

struct ProcessOptions {
    int jobs = 1;                    ///< at a time
    double seconds = 0;              ///< of wall time for each piece; 0 = any
    std::uint64_t memory_bytes = 0;  ///< of address space for each; 0 = any
};

/// How a piece ended.
struct ProcessEnd {
    std::size_t piece = 0;
    std::string output;      ///< what its work returned, if it came to its end
    int status = 0;          ///< its exit status
    int signal = 0;          ///< that ended the process, or 0
    bool timed_out = false;  ///< it was ended because it took too long
    double seconds = 0;      ///< that it took
};

/// Runs work(0) to work(pieces - 1), each in a process of its own, and calls ended() here as each one ends. False if a
/// signal has come that would end the program: then all processes are ended, and ended() is not called for them. The same
/// holds if ended() throws, or if this process dies. The work must not throw, and this process must have one thread only.
/// Throws LimitError if no process can be started.
bool run_in_processes(std::size_t pieces, const ProcessOptions& options, const SignalsHeld& signals,
                      const std::function<std::string(std::size_t)>& work,
                      const std::function<void(const ProcessEnd&)>& ended);

}  // namespace rinceau

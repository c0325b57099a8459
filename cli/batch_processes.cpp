#include "cli/batch_processes.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "scene/input_error.h"

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds look_every{50};  // for signals and for what takes too long
constexpr std::chrono::seconds grace{2};             // between a request to end and the end
constexpr std::size_t chunk_bytes = std::size_t{16} << 10;

struct Process {
    pid_t id = -1;
    int pipe = -1;  ///< to read its output from
    Clock::time_point start;
    std::optional<Clock::time_point> asked_to_end;
    ProcessEnd end;
};

void limit_memory([[maybe_unused]] std::uint64_t bytes) {
#ifndef RINCEAU_SANITIZED  // its shadow is larger than any limit
    rlimit limit{};
    if (bytes == 0 || ::getrlimit(RLIMIT_AS, &limit) != 0) return;
    limit.rlim_cur = std::min({static_cast<rlim_t>(bytes), limit.rlim_cur, limit.rlim_max});
    ::setrlimit(RLIMIT_AS, &limit);
#endif
}

void write_to(int pipe, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(pipe, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return;  // nobody reads any more
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

[[noreturn]] void do_piece(const std::function<std::string(std::size_t)>& work, std::size_t piece, int pipe, pid_t parent,
                           std::uint64_t memory_bytes) noexcept {
    ::setpgid(0, 0);  // Ctrl-C is for the parent, which ends its processes in order
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    if (::getppid() != parent) ::_exit(1);
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    limit_memory(memory_bytes);
    write_to(pipe, work(piece));
    ::_exit(0);  // what the parent has not written out yet is not this process's to write
}

/// The processes at work, ended with its life.
class Processes {
  public:
    Processes() = default;
    Processes(const Processes&) = delete;
    Processes& operator=(const Processes&) = delete;
    ~Processes() {
        for (const Process& process : running_) ::kill(process.id, SIGTERM);
        for (const Process& process : running_) end_soon(process);
    }

    std::size_t size() const { return running_.size(); }

    /// False if the system has none to give.
    bool start(std::size_t piece, const ProcessOptions& options, const std::function<std::string(std::size_t)>& work) {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0) return false;
        const pid_t parent = ::getpid();
        const pid_t id = ::fork();
        if (id == 0) {
            for (const Process& other : running_) ::close(other.pipe);
            ::close(ends[0]);
            do_piece(work, piece, ends[1], parent, options.memory_bytes);
        }
        const int error = errno;
        ::close(ends[1]);
        if (id < 0) ::close(ends[0]);
        errno = error;
        if (id < 0) return false;
        running_.push_back({.id = id, .pipe = ends[0], .start = Clock::now(), .asked_to_end = {}, .end = {.piece = piece}});
        return true;
    }

    /// Waits a moment for outputs; returns what has ended.
    std::vector<ProcessEnd> look() {
        std::vector<pollfd> pipes;
        for (const Process& process : running_) pipes.push_back({process.pipe, POLLIN, 0});
        ::poll(pipes.data(), pipes.size(), static_cast<int>(look_every.count()));
        std::vector<ProcessEnd> ends;
        for (std::size_t i = running_.size(); i-- > 0;) {
            if (pipes[i].revents == 0 || read_some(running_[i])) continue;
            ends.push_back(wait_for(running_[i]));
            running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
        }
        return ends;
    }

    void end_those_over(double seconds) {
        const auto now = Clock::now();
        for (Process& process : running_) {
            if (!process.asked_to_end && std::chrono::duration<double>(now - process.start).count() > seconds) {
                process.asked_to_end = now;
                process.end.timed_out = true;
                ::kill(process.id, SIGTERM);
            }
            if (process.asked_to_end && now - *process.asked_to_end > grace) ::kill(process.id, SIGKILL);
        }
    }

  private:
    std::vector<Process> running_;

    /// False at the end of the output.
    static bool read_some(Process& process) {
        std::array<char, chunk_bytes> chunk;
        const ssize_t count = ::read(process.pipe, chunk.data(), chunk.size());
        if (count < 0) return errno == EINTR;
        process.end.output.append(chunk.data(), static_cast<std::size_t>(count));
        return count > 0;
    }

    static ProcessEnd wait_for(Process& process) {
        ::close(process.pipe);
        int status = 0;
        while (::waitpid(process.id, &status, 0) < 0 && errno == EINTR) {
        }
        process.end.seconds = std::chrono::duration<double>(Clock::now() - process.start).count();
        if (WIFEXITED(status)) process.end.status = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) process.end.signal = WTERMSIG(status);
        return std::move(process.end);
    }

    static void end_soon(const Process& process) {
        ::close(process.pipe);
        const auto start = Clock::now();
        while (::waitpid(process.id, nullptr, WNOHANG) == 0) {
            if (Clock::now() - start > grace) ::kill(process.id, SIGKILL);
            ::poll(nullptr, 0, 1);
        }
    }
};

}  // namespace

bool run_in_processes(std::size_t pieces, const ProcessOptions& options, const SignalsHeld& signals,
                      const std::function<std::string(std::size_t)>& work,
                      const std::function<void(const ProcessEnd&)>& ended) {
    Processes processes;
    std::size_t next = 0;
    while (next < pieces || processes.size() > 0) {
        if (signals.waiting()) return false;
        if (next < pieces && processes.size() < static_cast<std::size_t>(options.jobs)) {
            if (processes.start(next, options, work)) {
                ++next;
                continue;
            }
            if (processes.size() == 0)
                throw LimitError({"rinceau"}, std::string("no process can be started: ") + std::strerror(errno));
        }
        for (const ProcessEnd& end : processes.look()) ended(end);
        if (options.seconds > 0) processes.end_those_over(options.seconds);
    }
    return true;
}

}  // namespace rinceau

// Loaded before a program (LD_PRELOAD), makes the n-th call that changes files fail, or ends the program there.
//
// RINCEAU_FAULT=kill:N    SIGKILL at the N-th such call; of a write half is written first
// RINCEAU_FAULT=CODE:N    the N-th call and all after it fail with the errno CODE, as on a disk that is full or gone; of a
//                         write half is written first; a close is reported as failed only if it is the N-th call itself
// Calls for standard error are left alone. A program that makes fewer calls runs as ever.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

namespace {

struct Fault {
    bool kill = false;
    int code = 0;
    long at = 0;  ///< counted from 1; 0 = never
};

Fault wanted_fault() {
    const char* text = std::getenv("RINCEAU_FAULT");
    const char* colon = text == nullptr ? nullptr : std::strchr(text, ':');
    if (colon == nullptr) return {};
    constexpr int decimal = 10;
    return {.kill = std::strncmp(text, "kill:", 5) == 0,
            .code = std::atoi(text),
            .at = std::strtol(colon + 1, nullptr, decimal)};
}

const Fault fault = wanted_fault();
std::atomic<long> calls = 0;

enum class Turn : unsigned char { before, now, after };

Turn next_turn() {
    if (fault.at == 0) return Turn::before;
    const long call = ++calls;
    if (call < fault.at) return Turn::before;
    return call == fault.at ? Turn::now : Turn::after;
}

/// May the call go on?
bool goes_on() {
    if (next_turn() == Turn::before) return true;
    if (fault.kill) ::raise(SIGKILL);
    errno = fault.code;
    return false;
}

template <class Function>
Function real(const char* name, Function) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

bool opens_to_write(int flags) { return (flags & O_ACCMODE) != O_RDONLY; }

bool is_written_file(int descriptor) {
    struct stat status {};
    return descriptor > STDERR_FILENO && ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
           opens_to_write(::fcntl(descriptor, F_GETFL));
}

mode_t mode_of(int flags, va_list rest) { return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0; }

}  // namespace

extern "C" {

int open(const char* name, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    if (opens_to_write(flags) && !goes_on()) return -1;
    return real("open", &open)(name, flags, mode);
}

int open64(const char* name, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return open(name, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
    const auto real_write = real("write", &write);
    if (descriptor == STDERR_FILENO) return real_write(descriptor, bytes, count);
    const Turn turn = next_turn();
    if (turn == Turn::before) return real_write(descriptor, bytes, count);
    if (turn == Turn::now && count > 1) {
        const ssize_t half = real_write(descriptor, bytes, count / 2);
        if (fault.kill) ::raise(SIGKILL);
        return half;
    }
    if (fault.kill) ::raise(SIGKILL);
    errno = fault.code;
    return -1;
}

int fsync(int descriptor) { return goes_on() ? real("fsync", &fsync)(descriptor) : -1; }

int fdatasync(int descriptor) { return goes_on() ? real("fdatasync", &fdatasync)(descriptor) : -1; }

int rename(const char* from, const char* to) { return goes_on() ? real("rename", &rename)(from, to) : -1; }

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
    return goes_on() ? real("linkat", &linkat)(from_folder, from, to_folder, to, flags) : -1;
}

int mkdir(const char* name, mode_t mode) { return goes_on() ? real("mkdir", &mkdir)(name, mode) : -1; }

int fchmod(int descriptor, mode_t mode) { return goes_on() ? real("fchmod", &fchmod)(descriptor, mode) : -1; }

int close(int descriptor) {
    const Turn turn = is_written_file(descriptor) ? next_turn() : Turn::before;
    if (turn == Turn::now && fault.kill) ::raise(SIGKILL);
    const int result = real("close", &close)(descriptor);
    if (turn != Turn::now || result != 0) return result;
    errno = fault.code;
    return -1;
}
}

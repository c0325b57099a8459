#include "cli/files.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/exit_status.h"
#include "exports/json_grammar.h"
#include "lsystem/grammar_text.h"
#include "lsystem/resolve_uses.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr std::size_t max_input_bytes = std::size_t{512} << 20;  // as much text as read_svg accepts
constexpr std::size_t chunk_bytes = std::size_t{64} << 10;

bool is_standard_stream(const std::string& name) { return name.empty() || name == "-"; }

std::string reason(int error) { return std::strerror(error); }

[[noreturn]] void fail_output(const std::string& name, int error) {
    throw OutputError(name + ": cannot be written: " + reason(error));
}

// An open file, closed at the end of its life.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }
    /// Closes now; false if what was written did not reach the file.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

// While it lives, signals that would end the program wait.
class SignalsHeld {
  public:
    SignalsHeld() {
        sigset_t ending;
        sigemptyset(&ending);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&ending, signal);
        pthread_sigmask(SIG_BLOCK, &ending, &before_);
    }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  private:
    sigset_t before_{};
};

// 0, or the error.
int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

std::string read_all(int descriptor, const std::string& label) {
    std::string bytes;
    std::array<char, chunk_bytes> chunk;
    while (true) {
        const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw InputError({label}, "cannot be read: " + reason(errno));
        if (count == 0) return bytes;
        if (bytes.size() + static_cast<std::size_t>(count) > max_input_bytes)
            throw LimitError({label},
                             "larger than " + std::to_string(max_input_bytes >> 20) + " MiB, the most that is read");
        bytes.append(chunk.data(), static_cast<std::size_t>(count));
    }
}

// Links followed, so that a link stays one; a name that does not exist yet as it is.
std::string resolved(const std::string& name) {
    std::error_code error;
    const auto target = std::filesystem::canonical(name, error);
    return error ? name : target.string();
}

// A name in the folder of `target` that no other file has, created empty and open.
std::pair<std::string, int> create_beside(const std::string& target) {
    constexpr int attempts = 100;
    const auto folder = std::filesystem::path(target).parent_path();
    for (int i = 0; i < attempts; ++i) {
        const auto file = ".rinceau-" + std::to_string(::getpid()) + "-" + std::to_string(i);
        std::string name = (folder / file).string();
        constexpr mode_t everyone_may = 0666;  // less what the user's mask takes away
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, everyone_may);
        if (descriptor >= 0) return {std::move(name), descriptor};
        if (errno != EEXIST) break;
    }
    fail_output(target, errno);
}

void replace_file(const std::string& target, const std::optional<mode_t>& mode, std::string_view bytes) {
    const SignalsHeld held;
    const auto [beside, number] = create_beside(target);
    Descriptor file(number);
    int error = write_all(file.number(), bytes);
    if (error == 0 && mode && ::fchmod(file.number(), *mode) != 0) error = errno;
    if (error == 0 && ::fsync(file.number()) != 0) error = errno;
    if (error == 0 && !file.close()) error = errno;
    if (error == 0 && ::rename(beside.c_str(), target.c_str()) != 0) error = errno;
    if (error == 0) return;
    ::unlink(beside.c_str());
    fail_output(target, error);
}

// Devices and pipes have no name to rename to.
void write_through(const std::string& target, std::string_view bytes) {
    Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
    int error = file.number() < 0 ? errno : write_all(file.number(), bytes);
    if (error == 0 && !file.close()) error = errno;
    if (error != 0) fail_output(target, error);
}

}  // namespace

std::string input_label(const std::string& name) { return name == "-" ? "<stdin>" : name; }

std::string read_input(const std::string& name) {
    const std::string label = input_label(name);
    if (name == "-") return read_all(STDIN_FILENO, label);
    const Descriptor file(::open(name.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.number() < 0) throw InputError({label}, "cannot be read: " + reason(errno));
    return read_all(file.number(), label);
}

Grammar read_grammar_as_written(const std::string& name) {
    const std::string text = read_input(name);
    return looks_like_json(text) ? parse_json_grammar(text, input_label(name)) : parse_grammar(text, input_label(name));
}

std::string read_grammar_text(const std::string& name) {
    std::string text = read_input(name);
    return looks_like_json(text) ? to_text(parse_json_grammar(text, input_label(name))) : text;
}

Grammar read_grammar(const std::string& name) { return resolve_uses(read_grammar_as_written(name), read_grammar_text); }

void write_output(const std::string& name, std::string_view bytes) {
    if (is_standard_stream(name)) {
        if (const int error = write_all(STDOUT_FILENO, bytes)) fail_output("<stdout>", error);
        return;
    }
    const std::string target = resolved(name);
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (exists && ::access(target.c_str(), W_OK) != 0) fail_output(name, errno);
    if (exists && !S_ISREG(status.st_mode)) return write_through(target, bytes);
    constexpr mode_t permissions = 07777;
    replace_file(target, exists ? std::optional(status.st_mode & permissions) : std::nullopt, bytes);
}

void expect_writable(const std::string& name) {
    if (is_standard_stream(name)) return;
    std::error_code ignored;
    if (std::filesystem::is_directory(name, ignored)) fail_output(name, EISDIR);
    const auto folder = std::filesystem::path(name).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) fail_output(name, ENOENT);
}

FileFormat format_of(const std::string& name, FileFormat standard_output) {
    if (is_standard_stream(name)) return standard_output;
    std::string ending = std::filesystem::path(name).extension().string();
    for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    constexpr std::array<std::pair<std::string_view, FileFormat>, 6> endings{{{".svg", FileFormat::svg},
                                                                              {".png", FileFormat::png},
                                                                              {".pdf", FileFormat::pdf},
                                                                              {".lsys", FileFormat::lsys},
                                                                              {".json", FileFormat::json},
                                                                              {".csv", FileFormat::csv}}};
    for (const auto& [text, format] : endings)
        if (ending == text) return format;
    return FileFormat::unknown;
}

}  // namespace rinceau

#include "program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace rinceau::test {
namespace {

using Clock = std::chrono::steady_clock;

#ifdef RINCEAU_SANITIZED
constexpr std::chrono::seconds longest_run{240};
#else
constexpr std::chrono::seconds longest_run{60};
#endif
constexpr rlim_t memory_bytes = rlim_t{1} << 30;
constexpr int not_started = 127;

void redirect(const std::string& name, int flags, int to) {
    constexpr mode_t mode = 0600;
    const int file = ::open(name.c_str(), flags, mode);
    if (file < 0 || ::dup2(file, to) < 0) ::_exit(not_started);
    ::close(file);
}

void limit_memory() {
#ifndef RINCEAU_SANITIZED  // a sanitizer's shadow is larger than any limit
    const rlimit limit{memory_bytes, memory_bytes};
    ::setrlimit(RLIMIT_AS, &limit);
#endif
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
}

sigset_t interrupt_alone() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    return signals;
}

[[noreturn]] void become_rinceau(const std::vector<std::string>& arguments, const ProgramOptions& options,
                                 const ScratchFolder& streams) {
    redirect(streams.file("in"), O_RDONLY, STDIN_FILENO);
    redirect(options.output_to.empty() ? streams.file("out") : options.output_to, O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(streams.file("err"), O_WRONLY | O_CREAT, STDERR_FILENO);
    if (::chdir(options.folder.c_str()) != 0) ::_exit(not_started);
    std::vector<char*> words{const_cast<char*>(RINCEAU_PROGRAM)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    limit_memory();
    // The test program's own handling of an interrupt must not run in the child.
    ::signal(SIGINT, SIG_DFL);
    const sigset_t interrupt = interrupt_alone();
    ::sigprocmask(SIG_UNBLOCK, &interrupt, nullptr);
    ::execv(RINCEAU_PROGRAM, words.data());
    ::_exit(not_started);
}

int wait_for(pid_t child, const ProgramOptions& options, rusage& usage) {
    constexpr std::chrono::milliseconds pause{2};
    bool interrupted = options.interrupt_after_ms == 0;
    bool signalled = !options.signal_when;
    int status = 0;
    const auto start = Clock::now();
    while (::wait4(child, &status, WNOHANG, &usage) == 0) {
        if (!interrupted && Clock::now() - start > std::chrono::milliseconds(options.interrupt_after_ms)) {
            ::kill(child, SIGINT);
            interrupted = true;
        }
        if (!signalled && options.signal_when()) {
            ::kill(child, options.signal);
            signalled = true;
        }
        if (Clock::now() - start > longest_run) ::kill(child, SIGKILL);
        std::this_thread::sleep_for(pause);
    }
    return status;
}

double seconds(const timeval& time) {
    constexpr double micro = 1e-6;
    return static_cast<double>(time.tv_sec) + micro * static_cast<double>(time.tv_usec);
}

}  // namespace

ScratchFolder::ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "rinceau-test-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> ScratchFolder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

std::string read_file(const std::filesystem::path& name) {
    std::ifstream file(name, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + name.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const std::filesystem::path& name, std::string_view bytes) {
    std::ofstream file(name, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) throw std::runtime_error("cannot write " + name.string());
}

ProgramRun run_rinceau(const std::vector<std::string>& arguments, const ProgramOptions& options) {
    const ScratchFolder streams;
    write_file(streams.file("in"), options.input);
    for (const std::string stream : {"out", "err"}) write_file(streams.file(stream), "");
    const sigset_t interrupt = interrupt_alone();
    sigset_t before;
    ::sigprocmask(SIG_BLOCK, &interrupt, &before);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot start a process");
    if (child == 0) become_rinceau(arguments, options, streams);
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    rusage usage{};
    const int status = wait_for(child, options, usage);
    ProgramRun run;
    run.seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    run.peak_kib = usage.ru_maxrss;
    if (WIFEXITED(status)) run.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
    if (options.output_to.empty()) run.out = read_file(streams.file("out"));
    run.err = read_file(streams.file("err"));
    return run;
}

std::vector<std::vector<std::string>> page_commands(const std::string& page) {
    std::vector<std::vector<std::string>> commands;
    std::istringstream text(read_file(std::filesystem::path(RINCEAU_SOURCE_DIR) / page));
    bool in_block = false;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("```")) in_block = line == "```sh";
        if (!in_block || !line.starts_with("rinceau ")) continue;
        std::istringstream words(line.substr(0, line.find('#')));
        std::vector<std::string> command;
        for (std::string word; words >> word;) command.push_back(word);
        command.erase(command.begin());
        commands.push_back(command);
    }
    return commands;
}

std::string sample(const std::string& name) { return std::string(RINCEAU_SOURCE_DIR) + "/samples/" + name; }

std::vector<std::string> all_samples(const std::string& ending) { return all_samples_in("", ending); }

std::vector<std::string> all_samples_in(const std::string& folder, const std::string& ending) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(sample(folder)))
        if (entry.path().extension() == ending) names.push_back(entry.path().string());
    std::ranges::sort(names);
    return names;
}

}  // namespace rinceau::test

#pragma once
// The program as a user starts it, and a folder to start it in.

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rinceau::test {

/// A new empty folder, removed with all that is in it.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// The name of a file in it.
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    /// The names in it, hidden ones too, sorted.
    std::vector<std::string> names() const;

  private:
    std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& name);
void write_file(const std::filesystem::path& name, std::string_view bytes);

struct ProgramRun {
    int status = 0;      ///< exit status
    int signal = 0;      ///< that ended it, 0 = none
    double seconds = 0;  ///< of processor time, which does not depend on what else the machine does
    long peak_kib = 0;   ///< largest resident memory, that of the test program at least
    std::string out;     ///< standard output
    std::string err;     ///< standard error
};

struct ProgramOptions {
    std::string input;                                  ///< standard input
    std::filesystem::path folder = RINCEAU_SOURCE_DIR;  ///< working folder
    std::string output_to;                              ///< standard output goes to this file instead
    int interrupt_after_ms = 0;                         ///< SIGINT after so long; 0 = never
    std::function<bool()> signal_when;                  ///< `signal` as soon as this holds, and once
    int signal = SIGKILL;
};

/// Runs rinceau with these arguments, in at most a gigabyte of address space (more under sanitizers, which need it). What
/// takes longer than a minute (four under sanitizers) is ended by SIGKILL.
ProgramRun run_rinceau(const std::vector<std::string>& arguments, const ProgramOptions& options = {});

/// The lines of a page of the project, in its blocks ```sh, that start the program: each as words without its name.
std::vector<std::vector<std::string>> page_commands(const std::string& page);

/// A file of the project's samples.
std::string sample(const std::string& name);

/// All samples with this ending (".svg", ".lsys"), sorted.
std::vector<std::string> all_samples(const std::string& ending);
/// Those in a folder of samples.
std::vector<std::string> all_samples_in(const std::string& folder, const std::string& ending);

}  // namespace rinceau::test

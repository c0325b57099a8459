#include "files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "files/output_error.h"

namespace rinceau {
namespace {

constexpr std::size_t most_held_back = std::size_t{1} << 20;

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

// Links followed, so that a link stays one; a name that does not exist yet as it is.
std::string resolved(const std::string& name) {
    std::error_code error;
    const auto target = std::filesystem::canonical(name, error);
    return error ? name : target.string();
}

}  // namespace

bool is_standard_stream(const std::string& name) { return name.empty() || name == "-"; }

void fail_output(const std::string& name, int error) {
    throw OutputError(name + ": cannot be written: " + std::strerror(error));
}

void OutputFile::fail(int error) {
    give_up();
    fail_output(is_standard_stream(name_) ? "<stdout>" : name_, error);
}

void OutputFile::open() {
    if (is_standard_stream(name_)) {
        descriptor_ = STDOUT_FILENO;
        return;
    }
    target_ = resolved(name_);
    struct stat status {};
    const bool exists = ::stat(target_.c_str(), &status) == 0;
    if (exists && ::access(target_.c_str(), W_OK) != 0) fail(errno);
    if (exists && !S_ISREG(status.st_mode)) {  // devices and pipes have no name to rename to
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
        return;
    }
    constexpr mode_t permissions = 07777;
    if (exists) mode_ = status.st_mode & permissions;
    signals_.emplace();
    create_beside();
}

// A name that no other file has, in the folder of the target or that for work, created empty and open.
void OutputFile::create_beside() {
    constexpr int attempts = 100;
    const auto folder =
        work_folder_.empty() ? std::filesystem::path(target_).parent_path() : std::filesystem::path(work_folder_);
    for (int i = 0; i < attempts; ++i) {
        const auto file = ".rinceau-" + std::to_string(::getpid()) + "-" + std::to_string(i);
        const std::string name = (folder / file).string();
        constexpr mode_t everyone_may = 0666;  // less what the user's mask takes away
        descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, everyone_may);
        if (descriptor_ >= 0) {
            beside_ = name;
            return;
        }
        if (errno != EEXIST) break;
    }
    fail(errno);
}

void OutputFile::pass_on(std::string_view bytes) {
    if (descriptor_ < 0) open();
    if (signals_ && signals_->waiting()) fail(EINTR);  // giving up lets the signal through
    if (const int error = write_all(descriptor_, bytes)) fail(error);
}

void OutputFile::write(std::string_view bytes) {
    if (held_back_.size() + bytes.size() > most_held_back) {
        if (!held_back_.empty()) pass_on(held_back_);
        held_back_.clear();
    }
    if (bytes.size() > most_held_back) {
        pass_on(bytes);
    } else {
        held_back_ += bytes;
    }
}

void OutputFile::close() {
    if (descriptor_ == STDOUT_FILENO) return;
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
}

void OutputFile::finish() {
    pass_on(held_back_);
    if (beside_.empty()) return close();
    if (mode_ && ::fchmod(descriptor_, *mode_) != 0) fail(errno);
    if (::fsync(descriptor_) != 0) fail(errno);
    close();
    if (::rename(beside_.c_str(), target_.c_str()) != 0) fail(errno);
    beside_.clear();
    signals_.reset();
}

void OutputFile::give_up() {
    if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) ::close(std::exchange(descriptor_, -1));
    if (!beside_.empty()) ::unlink(std::exchange(beside_, {}).c_str());
    signals_.reset();
}

}  // namespace rinceau

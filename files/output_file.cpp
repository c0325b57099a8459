#include "files/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

namespace rinceau {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_held_back = std::size_t{1} << 20;
constexpr mode_t everyone_may = 0666;  // less what the user's mask takes away

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

// Links followed, so that a link stays one, even if it leads to no file yet.
std::string resolved(const std::string& name) {
    constexpr int most_links = 40;  // as the system follows
    fs::path target = name;
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(target, error); ++i)
        target = target.parent_path() / fs::read_symlink(target, error);
    return target.string();
}

std::string folder_of(const std::string& file) {
    const std::string folder = fs::path(file).parent_path().string();
    return folder.empty() ? "." : folder;
}

// By this name a file can be linked that has none.
std::string open_file_name(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

// Calls `take` with names in the folder until it succeeds with one that is free. The name, or "" and errno.
template <class Take>
std::string free_name(const std::string& folder, const Take& take) {
    constexpr int attempts = 1000;
    for (int i = 0; i < attempts; ++i) {
        std::string name =
            (fs::path(folder) / (".rinceau-" + std::to_string(::getpid()) + "-" + std::to_string(i))).string();
        if (take(name)) return name;
        if (errno != EEXIST) break;
    }
    return {};
}

bool may(const std::string& name, int access) { return ::faccessat(AT_FDCWD, name.c_str(), access, AT_EACCESS) == 0; }

// 0, or the error: of the file if it is there, of its folder.
int obstacle(const std::string& name) {
    const std::string target = resolved(name);
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) return EISDIR;
    if (exists && !may(target, W_OK)) return errno;
    if (exists && !S_ISREG(status.st_mode)) return 0;  // devices and pipes are written in their place
    if (!exists && errno != ENOENT) return errno;
    struct stat folder {};
    if (::stat(folder_of(target).c_str(), &folder) != 0) return errno;
    if (!S_ISDIR(folder.st_mode)) return ENOTDIR;
    return may(folder_of(target), W_OK | X_OK) ? 0 : errno;
}

}  // namespace

bool is_standard_stream(const std::string& name) { return name.empty() || name == "-"; }

void expect_writable(const std::string& name) {
    if (is_standard_stream(name)) return;
    if (const int error = obstacle(name)) fail_output(name, error);
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
    if (exists && !may(target_, W_OK)) fail(errno);
    if (exists && !S_ISREG(status.st_mode)) {  // devices and pipes have no name to rename to
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
        return;
    }
    if (exists) replaced_ = status;
    signals_.emplace();
    aside_ = true;
    if (!create_nameless()) create_beside();
}

std::string OutputFile::folder() const { return work_folder_.empty() ? folder_of(target_) : work_folder_; }

// What never gets a name goes with the process, however that ends. False where that is not to be had.
bool OutputFile::create_nameless() {
#ifdef O_TMPFILE
    descriptor_ = ::open(folder().c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, everyone_may);
    if (descriptor_ < 0) return false;
    if (::access(open_file_name(descriptor_).c_str(), F_OK) == 0) return true;
    ::close(std::exchange(descriptor_, -1));
#endif
    return false;
}

void OutputFile::create_beside() {
    const mode_t mode = replaced_ ? replaced_->st_mode & everyone_may : everyone_may;  // private at once what is to be so
    beside_ = free_name(folder(), [&](const std::string& name) {
        descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        return descriptor_ >= 0;
    });
    if (beside_.empty()) fail(errno);
}

void OutputFile::name_it() {
    const std::string file = open_file_name(descriptor_);
    beside_ = free_name(folder(), [&](const std::string& name) {
        return ::linkat(AT_FDCWD, file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    });
    if (beside_.empty()) fail(errno);
}

void OutputFile::keep_owner_and_permissions() {
    struct stat own {};
    if (::fstat(descriptor_, &own) != 0) fail(errno);
    mode_t mode = replaced_->st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
    const bool other_owner = own.st_uid != replaced_->st_uid || own.st_gid != replaced_->st_gid;
    constexpr uid_t as_it_is = uid_t(-1);
    constexpr int group_above_others = 3;  // bits
    if (other_owner && ::fchown(descriptor_, replaced_->st_uid, replaced_->st_gid) != 0 &&
        ::fchown(descriptor_, as_it_is, replaced_->st_gid) != 0)
        mode = (mode & ~mode_t{S_IRWXG}) | ((mode & S_IRWXO) << group_above_others);  // what a group may that is no more
    if (::fchmod(descriptor_, mode) != 0) fail(errno);
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
    if (!aside_) return close();
    if (replaced_) keep_owner_and_permissions();
    if (::fsync(descriptor_) != 0) fail(errno);
    if (beside_.empty()) name_it();
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

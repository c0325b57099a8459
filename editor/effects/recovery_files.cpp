#include "editor/effects/recovery_files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "editor/effects/folders.h"
#include "editor/model/project.h"
#include "files/files.h"
#include "files/output_error.h"
#include "files/output_file.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".rinceau";

std::string lock_of(const std::string& file) { return fs::path(file).replace_extension(".lock").string(); }

/// Nobody holds the lock of the copy; in doubt, somebody does.
bool is_left_behind(const std::string& file) {
    try {
        return HeldLock::take(lock_of(file)).has_value();
    } catch (const OutputError&) {
        return false;
    }
}

}  // namespace

RecoveryFiles::RecoveryFiles(std::string folder) : folder_(std::move(folder)) {}

void RecoveryFiles::begin() {
    if (!own_.empty()) return;
    if (folder_.empty()) throw OutputError("there is no home folder to keep it in");
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) fail_output(folder_, error.value());
    ::chmod(folder_.c_str(), S_IRWXU);  // drawings are their owner's alone
    constexpr int attempts = 1000;
    for (int i = 0; i < attempts && !lock_; ++i) {
        own_ = (fs::path(folder_) / (std::to_string(::getpid()) + '-' + std::to_string(i) + ending)).string();
        if (!fs::exists(own_, error)) lock_ = HeldLock::take(lock_of(own_));  // a file there is another's, left behind
    }
    if (!lock_) {
        own_.clear();
        throw OutputError(folder_ + ": no name is free for a copy");
    }
}

void RecoveryFiles::write(std::string_view bytes) {
    begin();
    write_output(own_, bytes);
}

void RecoveryFiles::remove() {
    if (!own_.empty()) ::unlink(own_.c_str());
}

std::vector<Recoverable> RecoveryFiles::left_behind() const {
    std::vector<Recoverable> found;
    std::error_code error;
    for (fs::directory_iterator at(folder_, error); !error && at != fs::directory_iterator(); at.increment(error)) {
        const std::string file = at->path().string();
        if (file == own_ || at->path().extension() != ending || !is_left_behind(file)) continue;
        const auto stamp = stamp_of(file);
        constexpr std::int64_t nanoseconds = 1'000'000'000;
        Recoverable entry{.file = file, .modified = stamp ? stamp->modified / nanoseconds : 0};
        try {
            const Project project = parse_project(read_input(file), file);
            if (project.origin) entry.path = project.origin->path;
        } catch (const std::exception& broken) {
            entry.mistake = broken.what();
        }
        found.push_back(std::move(entry));
    }
    std::ranges::sort(found, [](const Recoverable& a, const Recoverable& b) { return a.modified > b.modified; });
    return found;
}

void RecoveryFiles::adopt(const std::string& file) {
    begin();
    const std::optional<HeldLock> theirs = HeldLock::take(lock_of(file));
    if (!theirs) throw InputError({file}, "has been recovered in another window");
    if (std::rename(file.c_str(), own_.c_str()) != 0)
        throw InputError({file}, std::string("cannot be kept: ") + std::strerror(errno));
}

void RecoveryFiles::discard(const std::string& file) {
    if (is_left_behind(file)) ::unlink(file.c_str());
}

}  // namespace rinceau

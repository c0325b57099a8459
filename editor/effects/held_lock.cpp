#include "editor/effects/held_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "files/output_file.h"

namespace rinceau {
namespace {

/// Is the open file still the one of that name? Its last holder may have removed it while this process opened it.
bool is_file_of_name(int descriptor, const std::string& file) {
    struct stat open {};
    struct stat named {};
    return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
           open.st_dev == named.st_dev;
}

}  // namespace

std::optional<HeldLock> HeldLock::take(const std::string& file) {
    constexpr int attempts = 100;
    for (int i = 0; i < attempts; ++i) {
        constexpr mode_t own_only = 0600;
        const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, own_only);
        if (descriptor < 0) fail_output(file, errno);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int error = errno;
            ::close(descriptor);
            if (error != EWOULDBLOCK) fail_output(file, error);
            return {};
        }
        if (is_file_of_name(descriptor, file)) return HeldLock(file, descriptor);
        ::close(descriptor);
    }
    return {};
}

HeldLock::HeldLock(HeldLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

HeldLock& HeldLock::operator=(HeldLock&& other) noexcept {
    release();
    file_ = std::move(other.file_);
    descriptor_ = std::exchange(other.descriptor_, -1);
    return *this;
}

HeldLock::~HeldLock() { release(); }

void HeldLock::release() {
    if (descriptor_ < 0) return;
    ::unlink(file_.c_str());
    ::close(std::exchange(descriptor_, -1));
}

}  // namespace rinceau

#pragma once
// A lock that other processes see and that ends with this one, however it ends.

#include <optional>
#include <string>

namespace rinceau {

/// Held on a file that exists for nothing else; the file goes with the lock.
class HeldLock {
  public:
    /// Nothing if another process, or another lock of this one, holds it. Throws OutputError if the file cannot be made.
    static std::optional<HeldLock> take(const std::string& file);

    HeldLock(HeldLock&& other) noexcept;
    HeldLock& operator=(HeldLock&& other) noexcept;
    HeldLock(const HeldLock&) = delete;
    HeldLock& operator=(const HeldLock&) = delete;
    ~HeldLock();

  private:
    HeldLock(std::string file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
    void release();

    std::string file_;
    int descriptor_ = -1;
};

}  // namespace rinceau

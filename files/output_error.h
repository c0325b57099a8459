#pragma once
// What is thrown when an output could not be written.

#include <stdexcept>
#include <string>

namespace rinceau {

/// what() reads "name: reason", and what to do about it where that is known.
class OutputError : public std::runtime_error {
  public:
    /// `code` is errno's, 0 = the reason is another one.
    explicit OutputError(const std::string& message, int code = 0) : std::runtime_error(message), code_(code) {}
    int code() const { return code_; }

  private:
    int code_;
};

/// Throws OutputError: "name: cannot be written: reason; what to do", the reason being errno's.
[[noreturn]] void fail_output(const std::string& name, int code);

}  // namespace rinceau

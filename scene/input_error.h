#pragma once
// What is wrong with an input, where, and what was expected.

#include <stdexcept>
#include <string>

namespace rinceau {

/// A place in an input file; line and column count from 1, 0 = unknown.
struct SourcePlace {
    std::string file;
    int line = 0;
    int column = 0;
};

/// The input is at fault. what() reads "file:line:column: message"; the message says what was expected and what was found.
class InputError : public std::runtime_error {
  public:
    InputError(SourcePlace place, const std::string& message);
    const SourcePlace& place() const { return place_; }

  private:
    SourcePlace place_;
};

/// A limit (size, depth, count, time) was reached; what() names the limit and the cure.
class LimitError : public std::runtime_error {
  public:
    LimitError(SourcePlace place, const std::string& message);
    const SourcePlace& place() const { return place_; }

  private:
    SourcePlace place_;
};

/// Something in the input that is kept or skipped in a way the user should know of.
struct Warning {
    SourcePlace place;
    std::string message;  ///< names the element and the attribute
};

/// "file:line:column: message", leaving out what is unknown.
std::string located(const SourcePlace& place, const std::string& message);

}  // namespace rinceau

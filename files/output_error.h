#pragma once
// What is thrown when an output could not be written.

#include <stdexcept>

namespace rinceau {

/// what() reads "name: reason".
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace rinceau

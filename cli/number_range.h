#pragma once
// Numbers on the command line that must lie in a range.

#include <CLI/App.hpp>

namespace rinceau {

/// Accepts a plain decimal number from low to high; "nan" and text around the number are none.
CLI::Validator number_between(double low, double high);

}  // namespace rinceau

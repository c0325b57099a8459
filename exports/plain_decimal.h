#pragma once
// Numbers without exponents, for formats that know none. Internal to the folder.

#include <string>

namespace rinceau {

/// Digits and a point only, with a sign if negative: the shortest that reads back as the same number, or what fits into
/// `longest` characters of it (at least 8). Too small for that: "0".
std::string plain_decimal(double value, std::size_t longest = 400);

}  // namespace rinceau

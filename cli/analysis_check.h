#pragma once
// No grammar leaves the program that does not draw the drawing that it was found in.

#include <string>

#include "analyzer/verify.h"

namespace rinceau {

/// Throws InputError with the drawing's label if the check has not been passed.
void expect_passed(const Verification& check, const std::string& label);

}  // namespace rinceau

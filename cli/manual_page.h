#pragma once
// The program's manual page, for man(1).

#include <string>

#include "cli/program_description.h"

namespace rinceau {

/// In the man macros of roff, with every verb and option that help shows.
std::string manual_page(const ProgramDescription& program, const std::string& version);

}  // namespace rinceau

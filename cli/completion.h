#pragma once
// What shells need to complete the program's command lines: verbs, options, words, and files by their endings.

#include <string>

#include "cli/program_description.h"

namespace rinceau {

/// A script that bash reads ("source"), or finds as completions/rinceau.
std::string bash_completion(const ProgramDescription& program);
/// A function that zsh finds as _rinceau in its fpath.
std::string zsh_completion(const ProgramDescription& program);
/// A script that fish reads, or finds as completions/rinceau.fish.
std::string fish_completion(const ProgramDescription& program);

}  // namespace rinceau

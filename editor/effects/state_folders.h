#pragma once
// Where the program keeps what is not the user's own files (XDG base directories).

#include <string>

namespace rinceau {

/// $XDG_STATE_HOME/rinceau, or ~/.local/state/rinceau: what is to survive a crash. Empty if the user has no home.
std::string state_folder();

/// $XDG_CONFIG_HOME/rinceau, or ~/.config/rinceau: preferences. Empty if the user has no home.
std::string config_folder();

/// Where samples/ is: beside an installed program, else as installed, else in the source tree. Empty if nowhere.
std::string samples_folder();

}  // namespace rinceau

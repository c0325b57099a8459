#pragma once
// The preferences on the disk: preferences.json in the user's configuration folder.

#include <string>

#include "editor/model/preferences.h"

namespace rinceau {

/// The usual ones if there is no file; the mistake says what is wrong with it and what becomes of it. Never throws.
PreferencesInFile read_preferences(const std::string& config_folder);

/// What other programs, or a newer one of ours, have added to the file stays. Throws OutputError.
void write_preferences(const std::string& config_folder, const Preferences& preferences);

}  // namespace rinceau

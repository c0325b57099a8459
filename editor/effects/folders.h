#pragma once
// What stands on the disk.

#include <optional>
#include <string>

#include "editor/model/dialog_actions.h"
#include "editor/model/file_stamp.h"

namespace rinceau {

/// The path made absolute: "~" and "~/x" are in the user's home, others relative to `from` (empty = where the program was
/// started). Without "." and "..".
std::string absolute_path(const std::string& path, const std::string& from = {});

/// The entries of a folder, the first 10,000 of them. Throws InputError if it cannot be read.
FolderListed list_folder(const std::string& folder);

/// Throws OutputError if it cannot be made, and if something stands there.
void make_folder(const std::string& folder);

PathSeen look_at(const std::string& path);

/// Nothing if there is no such file.
std::optional<FileStamp> stamp_of(const std::string& path);

}  // namespace rinceau

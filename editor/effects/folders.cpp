#include "editor/effects/folders.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "files/output_error.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_entries = 10'000;

FolderEntry entry_of(const fs::directory_entry& found) {
    FolderEntry entry{.name = found.path().filename().string()};
    struct stat status {};
    if (::stat(found.path().c_str(), &status) != 0) return entry;  // a link to nowhere
    entry.folder = S_ISDIR(status.st_mode);
    entry.bytes = static_cast<std::uint64_t>(status.st_size);
    entry.modified = status.st_mtim.tv_sec;
    return entry;
}

std::string why(const std::error_code& error) {
    if (error == std::errc::permission_denied) return "you may not look into it";
    if (error == std::errc::no_such_file_or_directory) return "it does not exist any more";
    return error.message();
}

}  // namespace

std::string absolute_path(const std::string& path, const std::string& from) {
    fs::path asked(path);
    const char* home = std::getenv("HOME");
    if (home != nullptr && (path == "~" || path.starts_with("~/")))
        asked = fs::path(home) / path.substr(path == "~" ? 1 : 2);
    std::error_code ignored;
    const fs::path base = from.empty() ? fs::current_path(ignored) : fs::path(from);
    fs::path whole = (base / asked).lexically_normal();
    if (!whole.has_filename() && whole.has_relative_path()) whole = whole.parent_path();  // "folder/"
    return whole.string();
}

FolderListed list_folder(const std::string& folder) {
    FolderListed listed{.folder = folder};
    std::error_code error;
    fs::directory_iterator at(folder, error);
    if (error) throw InputError({folder}, "cannot be listed: " + why(error));
    for (; at != fs::directory_iterator(); at.increment(error)) {
        if (listed.entries.size() == most_entries) {
            listed.cut_short = true;
            break;
        }
        listed.entries.push_back(entry_of(*at));
        if (error) break;
    }
    return listed;
}

void make_folder(const std::string& folder) {
    std::error_code error;
    const bool made = fs::create_directory(folder, error);
    if (error) throw OutputError(folder + ": the folder cannot be made: " + error.message());
    if (!made) throw OutputError(folder + ": a folder of this name is there already");
}

PathSeen look_at(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {path, PathSeen::What::nothing};
    return {path, S_ISDIR(status.st_mode) ? PathSeen::What::folder : PathSeen::What::file};
}

std::optional<FileStamp> stamp_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    constexpr std::int64_t nanoseconds = 1'000'000'000;
    return FileStamp{status.st_mtim.tv_sec * nanoseconds + status.st_mtim.tv_nsec,
                     static_cast<std::uint64_t>(status.st_size), static_cast<std::uint64_t>(status.st_ino)};
}

}  // namespace rinceau

#include "editor/effects/state_folders.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace rinceau {
namespace {

namespace fs = std::filesystem;

std::string home() {
    if (const char* named = std::getenv("HOME"); named != nullptr && fs::path(named).is_absolute()) return named;
    const passwd* user = ::getpwuid(::getuid());
    return user != nullptr && user->pw_dir != nullptr ? user->pw_dir : std::string();
}

/// The specification asks to ignore relative paths.
std::string base_folder(const char* variable, const char* in_home) {
    if (const char* named = std::getenv(variable); named != nullptr && fs::path(named).is_absolute())
        return (fs::path(named) / "rinceau").string();
    const std::string user = home();
    return user.empty() ? user : (fs::path(user) / in_home / "rinceau").string();
}

}  // namespace

std::string state_folder() { return base_folder("XDG_STATE_HOME", ".local/state"); }

std::string config_folder() { return base_folder("XDG_CONFIG_HOME", ".config"); }

std::string samples_folder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path beside = program.parent_path().parent_path() / "share/rinceau/samples";
    for (const fs::path& folder : {beside, fs::path(RINCEAU_INSTALLED_SAMPLES), fs::path(RINCEAU_SOURCE_SAMPLES)})
        if (fs::is_directory(folder, error)) return folder.string();
    return {};
}

}  // namespace rinceau

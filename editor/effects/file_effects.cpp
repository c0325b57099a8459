#include "editor/effects/file_effects.h"

#include <array>
#include <charconv>
#include <chrono>
#include <exception>
#include <filesystem>
#include <new>
#include <utility>

#include "editor/effects/folders.h"
#include "editor/effects/kept_preferences.h"
#include "editor/effects/list_samples.h"
#include "editor/effects/progress_posts.h"
#include "editor/effects/read_document.h"
#include "editor/effects/state_folders.h"
#include "editor/effects/write_document.h"
#include "editor/effects/write_export.h"
#include "editor/model/project.h"
#include "files/files.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

using Fail = std::function<void(std::string)>;

/// Runs the work; what it throws is told by `fail`. JobCancelled passes.
void guarded(const std::function<void()>& work, const Fail& fail) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        fail("The memory does not suffice");
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

std::string in_folder(const std::string& folder, const std::string& name) {
    return folder.empty() ? folder : (std::filesystem::path(folder) / name).string();
}

/// A name for the lock of a file: FNV-1a of its path, the same in every process.
std::string lock_name(const std::string& path) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : path) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    constexpr int hexadecimal = 16;
    std::array<char, hexadecimal> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, hexadecimal).ptr;
    return std::string(digits.data(), end) + ".lock";
}

std::string canonical(const std::string& path) {
    std::error_code error;
    const auto real = std::filesystem::canonical(path, error);
    return error ? path : real.string();
}

}  // namespace

FileEffects::FileEffects(ActionQueue& answers, KeptFolders folders)
    : answers_(answers), folders_(std::move(folders)), recovery_(in_folder(folders_.state, "recovery")) {}

void FileEffects::fulfil(const ReadDocument& request) {
    reads_.run([this, path = request.path] {
        guarded([&] { answers_.post(FileAction{read_document(path)}); },
                [&](std::string message) {
                    answers_.post(FileAction{FileFailed{path, std::move(message)}});
                });
    });
}

void FileEffects::fulfil(const WriteDocument& request) {
    writes_.run([this, request] { answers_.post(write_document(request)); });
}

void FileEffects::fulfil(const WriteExport& request) {
    export_stopped_ = std::make_shared<std::atomic<bool>>(false);
    writes_.run([this, request, stopped = export_stopped_] {
        ProgressPosts posts;
        const Progress progress = [&](std::string_view stage, double fraction) {
            if (*stopped) throw JobCancelled{};
            if (posts.worth(stage, std::chrono::steady_clock::now()))
                answers_.post(FileAction{ExportProgress{std::string(stage), fraction}});
        };
        const Fail fail = [&](std::string message) {
            answers_.post(FileAction{ExportFailed{request.what.path, std::move(message)}});
        };
        const auto work = [&] {
            const ExportedFiles made = make_export(request.document, request.what, progress);
            const std::vector<std::string> there = files_to_replace(made);
            if (!there.empty() && !request.what.replace) {
                answers_.post(FileAction{WouldReplace{there, request.what}});
                return;
            }
            progress("write", 1);
            write_export(made);
            answers_.post(FileAction{FileExported{request.what.path, made.notes}});
        };
        try {
            guarded(work, fail);
        } catch (const JobCancelled&) {
            fail({});
        }
    });
}

void FileEffects::fulfil(const StopExport&) {
    if (export_stopped_) *export_stopped_ = true;
}

void FileEffects::fulfil(const HoldFile& request) {
    if (folders_.state.empty()) return;
    writes_.run([this, path = request.path] { hold(path); });
}

void FileEffects::hold(const std::string& path) {
    if (path == held_path_) return;
    held_.reset();
    held_path_ = path;
    if (path.empty()) return;
    try {
        const std::string folder = in_folder(folders_.state, "open");
        std::error_code ignored;  // the lock says so if it is missing
        std::filesystem::create_directories(folder, ignored);
        held_ = HeldLock::take(in_folder(folder, lock_name(canonical(path))));
        if (!held_) answers_.post(FileAction{FileHeldElsewhere{path}});
    } catch (const std::exception&) {  // without a place for locks other windows cannot be known
    }
}

void FileEffects::fulfil(const ListFolder& request) {
    looks_.run([this, request] { answer_folder([&] { return list_folder(absolute_path(request.folder, request.from)); }); });
}

void FileEffects::fulfil(const MakeFolder& request) {
    looks_.run([this, request] {
        answer_folder([&] {
            const std::string folder = absolute_path(request.folder, request.from);
            make_folder(folder);
            return list_folder(folder);
        });
    });
}

void FileEffects::answer_folder(const std::function<FolderListed()>& list) {
    guarded([&] { answers_.post(DialogAction{list()}); },
            [&](std::string message) { answers_.post(DialogAction{FolderFailed{std::move(message)}}); });
}

void FileEffects::fulfil(const LookAtPath& request) {
    looks_.run([this, request] { answers_.post(DialogAction{look_at(absolute_path(request.path, request.from))}); });
}

void FileEffects::fulfil(const ListSamples&) {
    looks_.run([this] { answers_.post(DialogAction{SamplesListed{list_samples(samples_folder())}}); });
}

void FileEffects::fulfil(const WriteRecovery& request) {
    writes_.run([this, request] {
        guarded(
            [&] {
                recovery_.write(
                    to_json(Project{request.document, request.view, ProjectOrigin{request.path, request.stamp}}));
                answers_.post(RecoveryAction{RecoveryWritten{request.document}});
            },
            [&](std::string message) { answers_.post(RecoveryAction{RecoveryFailed{std::move(message)}}); });
    });
}

void FileEffects::fulfil(const RemoveRecovery&) {
    writes_.run([this] { recovery_.remove(); });
}

void FileEffects::fulfil(const FindRecoverables&) {
    if (folders_.state.empty()) return;
    writes_.run([this] {
        guarded([&] { answers_.post(RecoveryAction{RecoverablesFound{recovery_.left_behind()}}); },
                [](const std::string&) {});
    });
}

void FileEffects::fulfil(const ReadRecovery& request) {
    writes_.run([this, file = request.file] {
        guarded(
            [&] {
                Project project = parse_project(read_input(file), file);
                recovery_.adopt(file);
                const ProjectOrigin origin = project.origin.value_or(ProjectOrigin{});
                answers_.post(RecoveryAction{
                    DocumentRecovered{file, origin.path, std::move(project.document), origin.stamp, project.view}});
            },
            [&](std::string message) {
                answers_.post(RecoveryAction{RecoverableFailed{file, std::move(message)}});
            });
    });
}

void FileEffects::fulfil(const DiscardRecovery& request) {
    writes_.run([file = request.file] { RecoveryFiles::discard(file); });
}

void FileEffects::fulfil(const WritePreferences& request) {
    if (folders_.config.empty()) return;
    writes_.run([folder = folders_.config, preferences = request.preferences] {
        guarded([&] { write_preferences(folder, preferences); },
                [](const std::string&) {});  // nothing of the user's work is lost
    });
}

}  // namespace rinceau

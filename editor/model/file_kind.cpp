#include "editor/model/file_kind.h"

#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

namespace rinceau {
namespace {

constexpr std::array<std::pair<std::string_view, FileKind>, 9> endings{{{".svg", FileKind::drawing},
                                                                        {".svgz", FileKind::drawing},
                                                                        {".lsys", FileKind::grammar},
                                                                        {".json", FileKind::json_grammar},
                                                                        {".rinceau", FileKind::project},
                                                                        {".obj", FileKind::mesh},
                                                                        {".off", FileKind::mesh},
                                                                        {".ply", FileKind::mesh},
                                                                        {".fgsg", FileKind::shape_grammar}}};

}  // namespace

FileKind kind_of_name(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    for (const auto& [text, kind] : endings)
        if (ending == text) return kind;
    return FileKind::other;
}

std::string ending_of(FileKind kind) {
    for (const auto& [text, known] : endings)
        if (known == kind) return std::string(text);
    return {};
}

std::string with_kind(const std::string& path, FileKind kind) {
    std::filesystem::path name(path);
    if (kind_of_name(path) != FileKind::other) name.replace_extension();
    return name.string() + ending_of(kind);
}

std::string file_name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string stem_of(const std::string& path) {
    const std::string stem = std::filesystem::path(path).stem().string();
    return stem.empty() ? "untitled" : stem;
}

bool can_be_saved_as(FileKind kind) {
    return kind == FileKind::grammar || kind == FileKind::json_grammar || kind == FileKind::project;
}

}  // namespace rinceau

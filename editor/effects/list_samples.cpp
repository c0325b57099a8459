#include "editor/effects/list_samples.h"

#include <algorithm>
#include <filesystem>

#include "editor/model/file_kind.h"
#include "files/files.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

/// The title in the grammar's text, read without its rules; else the file's name.
std::string label_of(const std::string& path) {
    const std::string text = read_input(path);
    constexpr std::string_view word = "\ntitle \"";
    const std::size_t at = text.find(word);
    const std::size_t end = at == std::string::npos ? at : text.find('"', at + word.size());
    if (end == std::string::npos) return stem_of(path);
    return text.substr(at + word.size(), end - at - word.size());
}

}  // namespace

std::vector<PickItem> list_samples(const std::string& folder) {
    std::vector<PickItem> samples;
    std::error_code error;
    if (folder.empty()) return samples;
    for (fs::recursive_directory_iterator at(folder, error); !error && at != fs::recursive_directory_iterator();
         at.increment(error)) {
        const std::string path = at->path().string();
        if (kind_of_name(path) != FileKind::grammar) continue;
        try {
            samples.push_back({label_of(path), path});
        } catch (const std::runtime_error&) {  // a sample that cannot be read is none
        }
    }
    std::ranges::sort(samples, [](const PickItem& a, const PickItem& b) {
        return a.label != b.label ? a.label < b.label : a.path < b.path;
    });
    return samples;
}

}  // namespace rinceau

#include "cli/batch_drawings.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>

#include <CLI/Error.hpp>

#include "files/fingerprint.h"
#include "geometry/random.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

bool is_drawing_name(std::string_view name) {
    const std::size_t point = name.rfind('.');
    if (point == std::string_view::npos) return false;
    std::string ending(name.substr(point));
    for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return ending == ".svg" || ending == ".svgz";
}

bool has_hidden_part(std::string_view name) { return name.starts_with('.') || name.find("/.") != std::string_view::npos; }

/// Where an argument lies, whatever way it is written. The last part of a file's name may be a link.
fs::path identity_of(const std::string& argument, bool is_folder) {
    std::error_code ignored;
    const fs::path absolute = fs::absolute(argument, ignored);
    if (is_folder) return fs::weakly_canonical(absolute, ignored);
    return fs::weakly_canonical(absolute.parent_path(), ignored) / absolute.filename();
}

/// What the arguments before one hold already.
class EarlierArguments {
  public:
    EarlierArguments(const std::vector<std::string>& arguments, const std::vector<bool>& is_folder) {
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            identities_.push_back(identity_of(arguments[i], is_folder[i]).string());
            if (is_folder[i]) {
                const bool root = identities_.back().ends_with('/');
                folders_.push_back({identities_.back() + (root ? "" : "/"), i});
            } else {
                files_.try_emplace(identities_.back(), i);
            }
        }
    }

    const std::string& identity(std::size_t argument) const { return identities_[argument]; }

    bool hold(std::string_view identity, std::size_t argument) const {
        if (const auto file = files_.find(identity); file != files_.end() && file->second < argument) return true;
        return std::ranges::any_of(folders_, [&](const Folder& folder) {
            if (folder.argument >= argument || !identity.starts_with(folder.start)) return false;
            const std::string_view below = identity.substr(folder.start.size());
            return below.empty() || (is_drawing_name(below) && !has_hidden_part(below));
        });
    }

  private:
    struct Folder {
        std::string start;  ///< of the names in it
        std::size_t argument;
    };
    std::vector<std::string> identities_;
    std::vector<Folder> folders_;
    std::map<std::string, std::size_t, std::less<>> files_;
};

std::uint32_t shard_of(const BatchDrawing& drawing, const Shard& shard) {
    return Random(fingerprint(output_stem(drawing))).below(shard.count) + 1;
}

class Listing {
  public:
    Listing(BatchDrawings& batch, const Shard& shard)
        : batch_(batch), shard_(shard), earlier_(batch.arguments, batch.is_folder) {}

    void add_argument(std::uint32_t argument) {
        if (batch_.is_folder[argument]) return add_folder(argument);
        add({fs::path(batch_.arguments[argument]).filename().string(), argument}, earlier_.identity(argument));
    }

  private:
    BatchDrawings& batch_;
    const Shard& shard_;
    EarlierArguments earlier_;

    void add(BatchDrawing drawing, std::string_view identity) {
        if (earlier_.hold(identity, drawing.argument)) return;
        ++batch_.found;
        if (shard_.count == 1 || shard_of(drawing, shard_) == shard_.index) batch_.drawings.push_back(std::move(drawing));
    }

    void add_folder(std::uint32_t argument) {
        std::vector<std::string> waiting{""};  // names below the argument, each ending in '/'
        while (!waiting.empty()) {
            const std::string below = std::move(waiting.back());
            waiting.pop_back();
            add_names_in(below, argument, waiting);
        }
    }

    void add_names_in(const std::string& below, std::uint32_t argument, std::vector<std::string>& waiting) {
        std::error_code error;
        fs::directory_iterator entry(fs::path(batch_.arguments[argument]) / below, error);
        const std::string start = earlier_.identity(argument) + "/";
        for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
            const std::string name = entry->path().filename().string();
            if (name.starts_with('.')) continue;
            std::error_code unknown;
            const fs::file_type type = entry->symlink_status(unknown).type();
            if (type == fs::file_type::directory) waiting.push_back(below + name + "/");
            if (!is_drawing_name(name)) continue;
            // A link to nothing is a drawing that cannot be read.
            const bool file =
                type == fs::file_type::regular ||
                (type == fs::file_type::symlink && (entry->is_regular_file(unknown) || !entry->exists(unknown)));
            if (file) add({below + name, argument}, start + below + name);
        }
        if (error) add({below.empty() ? "./" : below, argument}, start + below);
    }
};

void expect_no_stem_twice(const BatchDrawings& batch) {
    const auto same = [](const BatchDrawing& a, const BatchDrawing& b) {
        return output_stem(a) == output_stem(b) && !a.name.ends_with('/');  // folders write nothing
    };
    const auto pair = std::ranges::adjacent_find(batch.drawings, same);
    if (pair == batch.drawings.end()) return;
    throw CLI::ValidationError("ART", "'" + input_name(batch, pair[0]) + "' and '" + input_name(batch, pair[1]) +
                                          "' would both be written as '" + std::string(output_stem(*pair)) +
                                          ".lsys': give the folder above both, or an -o for each");
}

}  // namespace

Shard parse_shard(const std::string& text) {
    Shard shard;
    const char* end = text.data() + text.size();
    const auto index = std::from_chars(text.data(), end, shard.index);
    const bool divided = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
    const auto count = divided ? std::from_chars(index.ptr + 1, end, shard.count) : index;
    if (!divided || count.ec != std::errc() || count.ptr != end || shard.index < 1 || shard.index > shard.count)
        throw CLI::ValidationError("--shard", "expected i/n with i from 1 to n, such as 2/16, found '" + text + "'");
    return shard;
}

std::string_view output_stem(const BatchDrawing& drawing) {
    const std::string_view name = drawing.name;
    const std::size_t slash = name.rfind('/');
    const std::size_t start = slash == std::string_view::npos ? 0 : slash + 1;
    const std::size_t point = name.rfind('.');
    return point == std::string_view::npos || point <= start ? name : name.substr(0, point);
}

std::string input_name(const BatchDrawings& batch, const BatchDrawing& drawing) {
    const std::string& argument = batch.arguments[drawing.argument];
    return batch.is_folder[drawing.argument] ? (fs::path(argument) / drawing.name).string() : argument;
}

BatchDrawings list_drawings(const std::vector<std::string>& arguments, const Shard& shard) {
    BatchDrawings batch{.arguments = arguments};
    for (const std::string& argument : arguments) {
        if (argument == "-")
            throw CLI::ValidationError("ART", "standard input ('-') is one drawing, and cannot be among many");
        std::error_code ignored;
        batch.is_folder.push_back(fs::is_directory(argument, ignored));
    }
    Listing listing(batch, shard);
    for (std::uint32_t i = 0; i < arguments.size(); ++i) listing.add_argument(i);
    std::ranges::sort(batch.drawings, {}, [](const BatchDrawing& drawing) {
        return std::pair(output_stem(drawing), std::string_view(drawing.name));
    });
    expect_no_stem_twice(batch);
    return batch;
}

}  // namespace rinceau

#include "cli/batch_journal.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <functional>

#include "files/output_error.h"
#include "files/output_file.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t chunk_bytes = std::size_t{64} << 10;
constexpr std::string_view journal_ending = ".jsonl";

using LineSink = std::function<void(std::uint64_t place, std::string_view line)>;

/// Bytes from `place` on, as many as there are up to a chunk's. Returns their number, or less than 0.
ssize_t read_at(int descriptor, std::uint64_t place, std::span<char> chunk) {
    ssize_t count = 0;
    do count = ::pread(descriptor, chunk.data(), chunk.size(), static_cast<off_t>(place));
    while (count < 0 && errno == EINTR);
    return count;
}

/// Every line from `place` on that has an end, without it, until the sink has seen `most` of them.
void read_lines(int descriptor, std::uint64_t place, std::size_t most, const LineSink& sink) {
    std::string line;
    std::array<char, chunk_bytes> chunk;
    std::uint64_t read_to = place;
    for (ssize_t count; most > 0 && (count = read_at(descriptor, read_to, chunk)) > 0;) {
        read_to += static_cast<std::uint64_t>(count);
        std::string_view rest(chunk.data(), static_cast<std::size_t>(count));
        for (std::size_t end; most > 0 && (end = rest.find('\n')) != std::string_view::npos; --most) {
            line += rest.substr(0, end);
            sink(place, line);
            place += line.size() + 1;
            line.clear();
            rest.remove_prefix(end + 1);
        }
        line += rest;
    }
}

/// "rows", or "rows-2-of-3".
std::string shard_name(const Shard& shard) {
    if (shard.count == 1) return "rows";
    return "rows-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
}

std::vector<std::string> other_journals(const std::string& name) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(fs::path(name).parent_path(), error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        if (entry->path().extension() == journal_ending && entry->path() != name) names.push_back(entry->path().string());
    std::ranges::sort(names);
    return names;
}

/// The number of the drawing that a row of these options is about.
std::optional<std::size_t> drawing_of(const std::optional<BatchRow>& row, std::span<const BatchDrawing> drawings,
                                      const std::string& options) {
    if (!row || row->options != options) return std::nullopt;
    const auto found = std::ranges::lower_bound(drawings, std::string_view(row->drawing), {}, output_stem);
    if (found == drawings.end() || output_stem(*found) != row->drawing) return std::nullopt;
    return static_cast<std::size_t>(found - drawings.begin());
}

/// The lock is the process's own: processes that it starts do not have it, and it ends with the process.
bool lock(int descriptor) {
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    // A disk that knows no locks is used without.
    return ::fcntl(descriptor, F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN);
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail_output(folder.string(), error.value());
}

}  // namespace

BatchJournal::BatchJournal(const std::string& folder, const Shard& shard) {
    const fs::path own = fs::path(folder) / ".rinceau";
    make_folder(own);
    name_ = (own / (shard_name(shard) + std::string(journal_ending))).string();
    work_ = (own / (shard_name(shard) + ".work")).string();
    try {
        open();
        std::error_code error;
        fs::remove_all(work_, error);
        if (error) fail_output(work_, error.value());
        make_folder(work_);
    } catch (...) {
        if (descriptor_ >= 0) ::close(descriptor_);
        throw;
    }
}

BatchJournal::~BatchJournal() {
    std::error_code ignored;
    fs::remove_all(work_, ignored);
    ::close(descriptor_);
}

void BatchJournal::open() {
    constexpr mode_t everyone_may = 0666;  // less what the user's mask takes away
    descriptor_ = ::open(name_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, everyone_may);
    if (descriptor_ < 0) fail_output(name_, errno);
    if (!lock(descriptor_))
        throw OutputError(name_ +
                          ": cannot be written: another rinceau is at work in this folder; --shard divides the work");
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail_output(name_, errno);
    end_ = static_cast<std::uint64_t>(status.st_size);
    // A line that was cut off must not be joined by the next.
    std::array<char, 1> last{'\n'};
    if (end_ > 0 && read_at(descriptor_, end_ - 1, last) == 1 && last[0] != '\n') append_line("\n");
}

std::uint64_t BatchJournal::append_line(std::string_view line) {
    const std::uint64_t place = end_;
    while (!line.empty()) {
        const ssize_t written = ::write(descriptor_, line.data(), line.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail_output(name_, errno);
        line.remove_prefix(static_cast<std::size_t>(written));
        end_ += static_cast<std::uint64_t>(written);
    }
    return place;
}

std::uint64_t BatchJournal::append(const BatchRow& row) {
    const std::uint64_t place = append_line(row_line(row));
    if (::fdatasync(descriptor_) != 0) fail_output(name_, errno);
    return place;
}

BatchRow BatchJournal::read(std::uint64_t place) const {
    std::optional<BatchRow> row;
    read_lines(descriptor_, place, 1, [&](std::uint64_t, std::string_view line) { row = parse_row(line); });
    if (!row) throw OutputError(name_ + ": was changed by another program");
    return *row;
}

std::vector<std::optional<std::uint64_t>> BatchJournal::find_rows(std::span<const BatchDrawing> drawings,
                                                                  const std::string& options) {
    constexpr std::size_t all = std::size_t(-1);
    std::vector<std::optional<std::uint64_t>> places(drawings.size());
    read_lines(descriptor_, 0, all, [&](std::uint64_t place, std::string_view line) {
        if (const auto drawing = drawing_of(parse_row(line), drawings, options)) places[*drawing] = place;
    });
    const auto own = places;
    for (const std::string& name : other_journals(name_)) {
        const int other = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
        if (other < 0) continue;  // what cannot be read is done again
        read_lines(other, 0, all, [&](std::uint64_t, std::string_view line) {
            const auto drawing = drawing_of(parse_row(line), drawings, options);
            if (drawing && !own[*drawing]) places[*drawing] = append_line(std::string(line) + "\n");
        });
        ::close(other);
    }
    return places;
}

}  // namespace rinceau

#include "files/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "exports/json_grammar.h"
#include "files/output_file.h"
#include "lsystem/grammar_text.h"
#include "lsystem/resolve_uses.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr std::size_t max_input_bytes = std::size_t{512} << 20;  // as much text as read_svg accepts
constexpr std::size_t chunk_bytes = std::size_t{64} << 10;

std::string reason(int error) { return std::strerror(error); }

// An open file, closed at the end of its life.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }

  private:
    int number_;
};

std::string read_all(int descriptor, const std::string& label) {
    std::string bytes;
    std::array<char, chunk_bytes> chunk;
    while (true) {
        const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw InputError({label}, "cannot be read: " + reason(errno));
        if (count == 0) return bytes;
        if (bytes.size() + static_cast<std::size_t>(count) > max_input_bytes)
            throw LimitError({label},
                             "larger than " + std::to_string(max_input_bytes >> 20) + " MiB, the most that is read");
        bytes.append(chunk.data(), static_cast<std::size_t>(count));
    }
}

Grammar parse_as_written(const std::string& name, const std::string& text) {
    expect_no_shape_grammar(name);
    return looks_like_json(text) ? parse_json_grammar(text, input_label(name)) : parse_grammar(text, input_label(name));
}

}  // namespace

std::string input_label(const std::string& name) { return name == "-" ? "<stdin>" : name; }

std::string read_input(const std::string& name) {
    const std::string label = input_label(name);
    if (name == "-") return read_all(STDIN_FILENO, label);
    const Descriptor file(::open(name.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.number() < 0) throw InputError({label}, "cannot be read: " + reason(errno));
    return read_all(file.number(), label);
}

void expect_no_shape_grammar(const std::string& name) {
    if (std::filesystem::path(name).extension() != ".fgsg") return;
    throw InputError(
        {input_label(name)},
        "expected a drawing or an L-system, found a shape grammar by its ending: 'rinceau grow' grows and draws "
        "it, 'rinceau check' checks it");
}

bool looks_like_drawing(std::string_view bytes) {
    // A grammar's text has no '<' before its first statement's end; gzip begins with a mark of its own.
    const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && (bytes[first] == '<' || bytes[first] == '\x1F');
}

Grammar read_grammar_as_written(const std::string& name) { return parse_as_written(name, read_input(name)); }

std::string read_grammar_text(const std::string& name) {
    std::string text = read_input(name);
    return looks_like_json(text) ? to_text(parse_json_grammar(text, input_label(name))) : text;
}

Grammar read_grammar(const std::string& name) { return read_grammar(name, read_input(name)); }

Grammar read_grammar(const std::string& name, const std::string& bytes) {
    return resolve_uses(parse_as_written(name, bytes), read_grammar_text);
}

void write_output(const std::string& name, std::string_view bytes) { write_output(name, bytes, {}); }

void write_output(const std::string& name, std::string_view bytes, const std::string& work_folder) {
    OutputFile file(name, work_folder);
    file.write(bytes);
    file.finish();
}

FileFormat format_of(const std::string& name, FileFormat standard_output) {
    if (is_standard_stream(name)) return standard_output;
    std::string ending = std::filesystem::path(name).extension().string();
    for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    constexpr std::array<std::pair<std::string_view, FileFormat>, 10> endings{{{".svg", FileFormat::svg},
                                                                               {".png", FileFormat::png},
                                                                               {".pdf", FileFormat::pdf},
                                                                               {".lsys", FileFormat::lsys},
                                                                               {".json", FileFormat::json},
                                                                               {".csv", FileFormat::csv},
                                                                               {".html", FileFormat::html},
                                                                               {".obj", FileFormat::obj},
                                                                               {".glb", FileFormat::glb},
                                                                               {".ply", FileFormat::ply}}};
    for (const auto& [text, format] : endings)
        if (ending == text) return format;
    return FileFormat::unknown;
}

}  // namespace rinceau

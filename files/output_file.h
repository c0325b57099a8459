#pragma once
// An output that is written piece by piece.

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "files/signals_held.h"

namespace rinceau {

/// What stands in the place of the file `name` when it is finished; "" or "-" = standard output. A regular file is written
/// beside its name and renamed; a signal that would end the program ends it between two pieces: either the old content
/// stands there or the whole new one, and nothing is left over. A symbolic link is followed. The first mebibyte is held
/// back, so that what fails early leaves nothing on standard output, a pipe or a device either. All functions throw
/// OutputError.
class OutputFile {
  public:
    explicit OutputFile(std::string name) : name_(std::move(name)) {}
    /// Written in `work_folder`, which is on the same disk, instead of beside its name: what even SIGKILL leaves over is
    /// there.
    OutputFile(std::string name, std::string work_folder) : name_(std::move(name)), work_folder_(std::move(work_folder)) {}
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    /// An output that is not finished is given up.
    ~OutputFile() { give_up(); }

    void write(std::string_view bytes);
    void finish();

  private:
    std::string name_;
    std::string work_folder_;     ///< empty = the folder of the target
    std::string target_;          ///< links followed; empty = standard output
    std::string beside_;          ///< the file that will be renamed; empty = none
    std::optional<mode_t> mode_;  ///< of the file that is replaced
    int descriptor_ = -1;
    std::string held_back_;
    std::optional<SignalsHeld> signals_;

    void open();
    void create_beside();
    void pass_on(std::string_view bytes);
    void close();
    void give_up();
    [[noreturn]] void fail(int error);
};

/// "" and "-".
bool is_standard_stream(const std::string& name);

/// Throws OutputError: "name: cannot be written: reason", the reason being errno's.
[[noreturn]] void fail_output(const std::string& name, int error);

}  // namespace rinceau

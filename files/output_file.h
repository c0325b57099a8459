#pragma once
// An output that is written piece by piece.

#include <sys/stat.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "files/output_error.h"
#include "files/signals_held.h"

namespace rinceau {

/// What stands in the place of the file `name` when it is finished; "" or "-" = standard output. A regular file is written
/// aside and renamed; a signal that would end the program ends it between two pieces: either the old content stands there
/// or the whole new one, and nothing is left over. After SIGKILL nothing is left over either, unless it comes in the moment
/// of the renaming, or the disk knows no files without a name; then ".rinceau-PROCESS-NUMBER" may be, which harms nobody.
/// Permissions stay, and so does the owner as far as that is allowed. A symbolic link is followed; a hard link is not: its
/// other names keep the old content. The first mebibyte is held back, so that what fails early leaves nothing on standard
/// output, a pipe or a device either. All functions throw OutputError.
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
    std::string work_folder_;              ///< empty = the folder of the target
    std::string target_;                   ///< links followed; empty = standard output
    bool aside_ = false;                   ///< written aside, to be renamed
    std::string beside_;                   ///< what it is called until then; empty = it has no name
    std::optional<struct stat> replaced_;  ///< the file that is replaced
    int descriptor_ = -1;
    std::string held_back_;
    std::optional<SignalsHeld> signals_;

    void open();
    std::string folder() const;
    bool create_nameless();
    void create_beside();
    void name_it();
    void keep_owner_and_permissions();
    void pass_on(std::string_view bytes);
    void close();
    void give_up();
    [[noreturn]] void fail(int error);
};

/// "" and "-".
bool is_standard_stream(const std::string& name);

/// Throws OutputError if it is plain beforehand that `name` cannot be written: it is a folder, or the file or its folder
/// is missing or may not be written.
void expect_writable(const std::string& name);

}  // namespace rinceau

#pragma once
// The rows of a batch as they come: a file to which a line is appended for every drawing that has ended.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/batch_drawings.h"
#include "cli/batch_row.h"

namespace rinceau {

/// In FOLDER/.rinceau/: a journal for each shard, which only grows. A line is there as a whole or is no row. One process at
/// a time writes a shard. All functions throw OutputError.
class BatchJournal {
  public:
    /// Makes what is missing of the folder. Throws also if another process writes this shard.
    BatchJournal(const std::string& folder, const Shard& shard);
    BatchJournal(const BatchJournal&) = delete;
    BatchJournal& operator=(const BatchJournal&) = delete;
    ~BatchJournal();

    /// For files on their way to the folder; empty at first, whatever a run that was killed has left there.
    const std::string& work_folder() const { return work_; }

    /// Returns where the row stands. It survives the end of this process, and of the machine.
    std::uint64_t append(const BatchRow& row);

    /// What was appended.
    BatchRow read(std::uint64_t place) const;

    /// Of each drawing, where the last row with these options stands that this shard has; where it has none, a row of
    /// another shard's journal is copied from there. Drawings are sorted by output_stem().
    std::vector<std::optional<std::uint64_t>> find_rows(std::span<const BatchDrawing> drawings, const std::string& options);

  private:
    std::string name_;
    std::string work_;
    int descriptor_ = -1;
    std::uint64_t end_ = 0;

    void open();
    std::uint64_t append_line(std::string_view line);
};

}  // namespace rinceau

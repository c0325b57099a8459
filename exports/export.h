#pragma once
// A grammar written for another program: what every export takes and gives.

#include <string>
#include <vector>

#include "lsystem/derive.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct ExportOptions {
    DeriveOptions derive;          ///< depth and seed, where the export has to derive
    std::string name = "rinceau";  ///< of the whole, for formats that name things: letters, digits, underscores
    bool live_random = false;      ///< write draws by chance as such where the format can; else they are frozen at the seed
};

/// A file that belongs beside the exported one: its name is that of the export with its ending replaced by `ending`.
struct CompanionFile {
    std::string ending;  ///< ".map"
    std::string bytes;
};

/// Guarantee: what the other program draws is the grammar's picture, but for what `notes` says.
struct Export {
    std::string bytes;
    std::vector<CompanionFile> companions;
    std::vector<std::string> notes;  ///< what the format cannot hold and what was written instead, one sentence each
};

/// Every to_<format>(grammar, options) -> Export throws
///   InputError   as derive(), and where the format cannot hold the grammar and nothing near it: the message says what and
///                which format can,
///   LimitError   as derive().

}  // namespace rinceau

#pragma once
// How a file on disk is told from the one that was read.

#include <cstdint>

namespace rinceau {

/// Two stamps of one name that differ: something has written the file in between.
struct FileStamp {
    std::int64_t modified = 0;  ///< nanoseconds since 1970
    std::uint64_t bytes = 0;
    std::uint64_t node = 0;  ///< number of the file in its file system
    friend constexpr bool operator==(const FileStamp&, const FileStamp&) = default;
};

}  // namespace rinceau

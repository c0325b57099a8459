#pragma once
// The drawings of a batch: what the arguments name, and the share of it that one run takes.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rinceau {

/// One of `count` runs that together take every drawing once.
struct Shard {
    std::uint32_t index = 1;  ///< from 1 to count
    std::uint32_t count = 1;
};

/// Reads "2/16". Throws CLI::ValidationError.
Shard parse_shard(const std::string& text);

struct BatchDrawing {
    std::string name;  ///< below the folder that holds it: "roses/a.svg"; ends in '/': a folder that cannot be listed
    std::uint32_t argument = 0;  ///< that names it or its folder
};

/// Of a drawing's name without its ending: "roses/a". Outputs are called so, and it decides on the shard.
std::string_view output_stem(const BatchDrawing& drawing);

struct BatchDrawings {
    std::vector<std::string> arguments;
    std::vector<bool> is_folder;         ///< of each argument
    std::vector<BatchDrawing> drawings;  ///< of this shard, sorted by output_stem(), no stem twice
    std::size_t found = 0;               ///< in all shards
};

/// How the drawing is opened, and called in messages.
std::string input_name(const BatchDrawings& batch, const BatchDrawing& drawing);

/// Files as they are named; below folders all files that end in .svg or .svgz, but nothing hidden and nothing behind links
/// to folders. What several arguments hold is taken once, by the first. The shard of a drawing depends on its stem and on
/// the number of shards alone. Memory: the names of this shard. Throws CLI::ValidationError if two drawings have one stem.
BatchDrawings list_drawings(const std::vector<std::string>& arguments, const Shard& shard);

}  // namespace rinceau

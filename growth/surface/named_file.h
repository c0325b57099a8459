#pragma once
// Files that a shape grammar names.

#include <functional>
#include <string>

#include "scene/input_error.h"

namespace rinceau {

/// The bytes of a file by the name that the grammar gives it; throws InputError if it cannot be read.
using ReadNamedFile = std::function<std::string(const std::string& name)>;

/// Throws InputError at the place of the statement that names the file, if that is known.
inline std::string read_named(const ReadNamedFile& read, const std::string& name, const SourcePlace& place) {
    try {
        return read(name);
    } catch (const InputError& error) {
        if (place.file.empty()) throw;
        throw InputError(place, error.what());
    }
}

}  // namespace rinceau

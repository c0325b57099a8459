#pragma once
// From a file to a document.

#include <string>

#include "editor/model/file_actions.h"

namespace rinceau {

/// An SVG becomes a document with a drawing and the flat list of its elements, a .lsys or its JSON one with that grammar, a
/// project what was saved.
/// Throws InputError and LimitError.
FileOpened read_document(const std::string& path);

}  // namespace rinceau

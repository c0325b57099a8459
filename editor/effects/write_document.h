#pragma once
// From a document to a file.

#include "editor/model/file_actions.h"
#include "editor/model/request.h"

namespace rinceau {

/// Writes the document as the kind of file that its name says: a grammar as text or JSON, or a project. The file is whole
/// before and afterwards. The answer is FileSaved, SaveFailed with the cure, WouldReplace or FileChangedOutside. Never
/// throws.
FileAction write_document(const WriteDocument& request);

/// The reason why something could not be written, with what to do about it.
std::string with_cure(const std::string& message);

}  // namespace rinceau

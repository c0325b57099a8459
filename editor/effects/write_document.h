#pragma once
// From a document to a file.

#include "editor/model/file_actions.h"
#include "editor/model/request.h"

namespace rinceau {

/// Writes the document as the kind of file that its name says: a grammar as text or JSON, or a project. The file is whole
/// before and afterwards. The answer is FileSaved, SaveFailed with what to do, WouldReplace or FileChangedOutside. Never
/// throws.
FileAction write_document(const WriteDocument& request);

}  // namespace rinceau

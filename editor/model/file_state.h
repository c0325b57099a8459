#pragma once
// What the editor knows of files.

#include <memory>
#include <string>

#include "lsystem/grammar.h"

namespace rinceau {

struct FileState {
    std::string path;                              ///< of the document; empty = it has never been saved or opened
    std::shared_ptr<const Grammar> saved_grammar;  ///< what the file holds
    std::string opening;                           ///< path that is being read; empty = none
};

}  // namespace rinceau

#pragma once
// The gallery of samples.

#include <string>
#include <vector>

#include "editor/model/pick_list.h"

namespace rinceau {

/// The grammars in the folder and those below it, named by their titles, in that order. Empty without such a folder.
std::vector<PickItem> list_samples(const std::string& folder);

}  // namespace rinceau

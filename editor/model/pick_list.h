#pragma once
// A list from which a document is chosen: the samples, or the files that were open lately.

#include <string>
#include <vector>

namespace rinceau {

struct PickItem {
    std::string label;  ///< "Facade"
    std::string path;
};

struct PickList {
    enum class Of : unsigned char { samples, recent };
    Of of = Of::samples;
    bool waiting = false;  ///< the items are on their way
    std::vector<PickItem> items;
    int selected = 0;
};

}  // namespace rinceau

#pragma once
// Symbols as single characters, for formats that have no longer names. Internal to the folder.

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace rinceau {

struct SingleCharacter {
    char character = 0;
    int number = -1;  ///< first argument of modules that share the character; -1 = it is theirs alone
};

/// The first letter of a name if it is still free, else the next free character; if there are too few, the last one is
/// shared by all that are left over.
std::map<std::string, SingleCharacter, std::less<>> single_characters(const std::set<std::string>& names,
                                                                      std::string_view free);

}  // namespace rinceau

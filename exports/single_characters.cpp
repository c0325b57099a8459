#include "exports/single_characters.h"

namespace rinceau {

std::map<std::string, SingleCharacter, std::less<>> single_characters(const std::set<std::string>& names,
                                                                      std::string_view free) {
    std::map<std::string, SingleCharacter, std::less<>> result;
    std::string left(free);
    const char last = left.back();
    if (names.size() > left.size()) left.pop_back();
    int number = 0;
    for (const std::string& name : names) {
        if (left.empty()) {
            result[name] = {last, number++};
            continue;
        }
        std::size_t at = left.find(name.front());
        if (at == std::string::npos) at = 0;
        result[name] = {left[at], -1};
        left.erase(at, 1);
    }
    return result;
}

}  // namespace rinceau

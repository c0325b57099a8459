#include "exports/target_names.h"

namespace rinceau {

std::string free_name(const std::string& wish, std::set<std::string>& taken,
                      const std::function<bool(std::string_view)>& allowed) {
    std::string name = wish;
    for (int k = 1; taken.contains(name) || !allowed(name); ++k) name = k == 1 ? wish + '_' : wish + '_' + std::to_string(k);
    taken.insert(name);
    return name;
}

std::string one_line(std::string_view text) {
    std::string line(text);
    for (char& c : line) {
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    }
    return line;
}

}  // namespace rinceau

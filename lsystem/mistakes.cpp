#include "lsystem/mistakes.h"

namespace rinceau {

Warning warning_of(const InputError& error) {
    const std::string front = located(error.place(), "");
    std::string message = error.what();
    if (message.starts_with(front)) message.erase(0, front.size());
    return {error.place(), message};
}

bool add_mistake(std::vector<Warning>& mistakes, const SourcePlace& place, const std::string& message) {
    if (mistakes.size() >= max_mistakes) return false;
    mistakes.push_back({place, message});
    return true;
}

bool add_mistake(std::vector<Warning>& mistakes, const InputError& error) {
    const Warning mistake = warning_of(error);
    return add_mistake(mistakes, mistake.place, mistake.message);
}

}  // namespace rinceau

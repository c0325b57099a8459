#include "scene/input_error.h"

namespace rinceau {

std::string located(const SourcePlace& place, const std::string& message) {
    std::string text = place.file;
    if (place.line > 0) {
        if (!text.empty()) text += ':';
        text += std::to_string(place.line);
        if (place.column > 0) text += ':' + std::to_string(place.column);
    }
    return text.empty() ? message : text + ": " + message;
}

InputError::InputError(SourcePlace place, const std::string& message)
    : std::runtime_error(located(place, message)), place_(std::move(place)) {}

LimitError::LimitError(SourcePlace place, const std::string& message)
    : std::runtime_error(located(place, message)), place_(std::move(place)) {}

}  // namespace rinceau

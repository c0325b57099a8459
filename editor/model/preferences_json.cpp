#include <algorithm>

#include "editor/model/preferences.h"
#include "exports/json_text.h"

namespace rinceau {
namespace {

constexpr std::size_t most_recent = 12;

/// The member as it is, if it is a number within the range.
double number_in(const Json& json, const char* name, double usual, double low, double high) {
    const auto found = json.find(name);
    if (found == json.end() || !found->is_number()) return usual;
    const double value = found->get<double>();
    return value >= low && value <= high ? value : usual;
}

bool truth_in(const Json& json, const char* name, bool usual) {
    const auto found = json.find(name);
    return found != json.end() && found->is_boolean() ? found->get<bool>() : usual;
}

std::string text_in(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::vector<std::string> texts_in(const Json& json, const char* name) {
    std::vector<std::string> texts;
    const auto found = json.find(name);
    if (found == json.end() || !found->is_array()) return texts;
    for (const Json& text : *found)
        if (text.is_string() && texts.size() < most_recent) texts.push_back(text.get<std::string>());
    return texts;
}

}  // namespace

std::string to_json(const Preferences& preferences, std::string_view before) {
    Json json = Json::parse(before, nullptr, false);
    if (!json.is_object()) json = Json::object();
    json["dark"] = preferences.dark;
    json["scale"] = preferences.scale;
    json["window"] = {{"width", preferences.window_width}, {"height", preferences.window_height}};
    json["autosave_seconds"] = preferences.autosave_seconds;
    json["recent"] = preferences.recent;
    json["last_folder"] = preferences.last_folder;
    constexpr int indentation = 2;
    return json.dump(indentation, ' ', false, Json::error_handler_t::replace) + '\n';
}

PreferencesInFile parse_preferences(std::string_view text) {
    PreferencesInFile read;
    Preferences& preferences = read.preferences;
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) {
        read.mistake = "is no JSON object";
        return read;
    }
    constexpr double smallest_window = 320;
    constexpr double largest_window = 32767;
    constexpr double largest_scale = 8;
    constexpr double longest_wait = 60;  // a recovered document is never older
    preferences.dark = truth_in(json, "dark", preferences.dark);
    preferences.scale = number_in(json, "scale", preferences.scale, 0, largest_scale);
    const Json window = json.value("window", Json::object());
    preferences.window_width =
        static_cast<int>(number_in(window, "width", preferences.window_width, smallest_window, largest_window));
    preferences.window_height =
        static_cast<int>(number_in(window, "height", preferences.window_height, smallest_window, largest_window));
    preferences.autosave_seconds = number_in(json, "autosave_seconds", preferences.autosave_seconds, 1, longest_wait);
    preferences.recent = texts_in(json, "recent");
    preferences.last_folder = text_in(json, "last_folder");
    return read;
}

}  // namespace rinceau

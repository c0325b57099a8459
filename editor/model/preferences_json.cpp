#include <algorithm>
#include <nlohmann/json.hpp>

#include "editor/model/preferences.h"

namespace rinceau {
namespace {

using Json = nlohmann::ordered_json;

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

float length_in(const Json& json, const char* name, float usual, double low, double high) {
    return static_cast<float>(number_in(json, name, static_cast<double>(usual), low, high));
}

Json panels_json(const Preferences& preferences) {
    const PanelSizes& sizes = preferences.sizes;
    const ShownPanels& shown = preferences.shown;
    return {{"left", shown.left},           {"left_width", sizes.left},
            {"terminals", shown.terminals}, {"terminals_share", sizes.terminals_share},
            {"analysis", shown.analysis},   {"right", shown.right},
            {"right_width", sizes.right},   {"log", shown.log},
            {"log_height", sizes.log}};
}

void read_panels(const Json& json, Preferences& preferences) {
    if (!json.is_object()) return;
    constexpr double longest = 10000;
    PanelSizes& sizes = preferences.sizes;
    sizes.left = length_in(json, "left_width", sizes.left, 1, longest);
    sizes.right = length_in(json, "right_width", sizes.right, 1, longest);
    sizes.log = length_in(json, "log_height", sizes.log, 1, longest);
    sizes.terminals_share = length_in(json, "terminals_share", sizes.terminals_share, 0, 1);
    ShownPanels& shown = preferences.shown;
    shown.left = truth_in(json, "left", shown.left);
    shown.terminals = truth_in(json, "terminals", shown.terminals);
    shown.analysis = truth_in(json, "analysis", shown.analysis);
    shown.right = truth_in(json, "right", shown.right);
    shown.log = truth_in(json, "log", shown.log);
}

}  // namespace

std::string to_json(const Preferences& preferences, std::string_view before) {
    Json json = Json::parse(before, nullptr, false);
    if (!json.is_object()) json = Json::object();
    json["dark"] = preferences.dark;
    json["text_scale"] = preferences.text_scale;
    json["panels"] = panels_json(preferences);
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
    constexpr double smallest_text = 0.5;
    constexpr double largest_text = 3;
    constexpr double longest_wait = 60;  // a recovered document is never older
    preferences.dark = truth_in(json, "dark", preferences.dark);
    preferences.text_scale = length_in(json, "text_scale", preferences.text_scale, smallest_text, largest_text);
    read_panels(json.value("panels", Json::object()), preferences);
    preferences.autosave_seconds = number_in(json, "autosave_seconds", preferences.autosave_seconds, 1, longest_wait);
    preferences.recent = texts_in(json, "recent");
    preferences.last_folder = text_in(json, "last_folder");
    return read;
}

}  // namespace rinceau

#include "editor/model/places_json.h"

#include <nlohmann/json.hpp>

namespace rinceau {

std::string to_json(const WindowTrace& trace) {
    nlohmann::json widgets = nlohmann::json::array();
    for (const WidgetPlace& place : trace.widgets) {
        widgets.push_back({{"name", place.name},
                           {"left", place.left},
                           {"top", place.top},
                           {"right", place.right},
                           {"bottom", place.bottom}});
    }
    const nlohmann::json json{{"title", trace.title},
                              {"frame", trace.frame},
                              {"busy", trace.busy},
                              {"refining", trace.refining},
                              {"framebuffer", {trace.width, trace.height}},
                              {"scale", trace.scale},
                              {"widgets", std::move(widgets)}};
    constexpr int compact = -1;  // no indentation
    return json.dump(compact, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace rinceau

#include "editor/panels/frame_timing.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <limits>

namespace rinceau {
namespace {

constexpr float tooltip_delay = 0.45F;  // seconds
constexpr double blink = 0.4;           // seconds: Dear ImGui's cursor is 0.8 s on, 0.4 s off

}  // namespace

bool mouse_has_rested() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return context.HoveredId == 0 || context.HoveredIdTimer >= tooltip_delay;
}

double seconds_to_next_frame() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    double seconds = std::numeric_limits<double>::infinity();
    if (context.IO.WantTextInput) seconds = blink;
    if (!mouse_has_rested()) seconds = std::min(seconds, static_cast<double>(tooltip_delay - context.HoveredIdTimer));
    return seconds;
}

}  // namespace rinceau

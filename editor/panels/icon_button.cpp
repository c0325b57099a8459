#include "editor/panels/icon_button.h"

#include <imgui.h>

namespace rinceau {
namespace {

constexpr float pi = 3.14159265F;

/// Where an icon is drawn: shares of the square of side `size` at `low`.
struct IconBox {
    ImDrawList* list;
    ImVec2 low;
    float size;
    ImU32 color;

    ImVec2 at(float x, float y) const { return {low.x + x * size, low.y + y * size}; }
};

void draw_lock(const IconBox& box, bool locked) {
    const float line = 0.09F * box.size;
    const float lift = locked ? 0 : -0.12F;
    const float radius = 0.16F * box.size;
    box.list->PathLineTo(box.at(0.34F, 0.5F + lift));
    box.list->PathArcTo(box.at(0.5F, 0.36F + lift), radius, pi, 2 * pi);
    if (locked) box.list->PathLineTo(box.at(0.66F, 0.5F));
    box.list->PathStroke(box.color, 0, line);
    box.list->AddRectFilled(box.at(0.27F, 0.48F), box.at(0.73F, 0.82F), box.color, 0.06F * box.size);
}

/// A circle that goes back to where it began.
void draw_reset(const IconBox& box) {
    const ImVec2 center = box.at(0.5F, 0.52F);
    const float radius = 0.27F * box.size;
    constexpr float begin = -0.5F * pi;
    constexpr float round = 1.55F * pi;
    box.list->PathArcTo(center, radius, begin, begin + round);
    box.list->PathStroke(box.color, 0, 0.09F * box.size);
    const ImVec2 head = box.at(0.5F, 0.25F);
    const float wing = 0.16F * box.size;
    box.list->AddTriangleFilled({head.x - wing, head.y}, {head.x + 0.4F * wing, head.y - wing},
                                {head.x + 0.4F * wing, head.y + wing}, box.color);
}

/// Three dots below each other.
void draw_menu(const IconBox& box) {
    for (const float y : {0.27F, 0.5F, 0.73F}) box.list->AddCircleFilled(box.at(0.5F, y), 0.07F * box.size, box.color);
}

}  // namespace

float icon_button_width() { return ImGui::GetFrameHeight(); }

bool icon_button(const char* id, Icon icon, const char* tooltip) {
    const float size = icon_button_width();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    const bool pressed = ImGui::Button(id, {size, size});
    ImGui::PopStyleColor();
    const bool faint = icon == Icon::unlocked && !ImGui::IsItemHovered();
    const ImU32 color = ImGui::GetColorU32(faint ? ImGuiCol_TextDisabled : ImGuiCol_Text);
    const IconBox box{ImGui::GetWindowDrawList(), low, size, color};
    if (icon == Icon::reset) {
        draw_reset(box);
    } else if (icon == Icon::menu) {
        draw_menu(box);
    } else {
        draw_lock(box, icon == Icon::locked);
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip);
    return pressed;
}

}  // namespace rinceau

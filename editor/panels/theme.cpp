#include "editor/panels/theme.h"

namespace rinceau {
namespace {

ImVec4 rgb(unsigned hex, float alpha = 1) {
    constexpr unsigned byte = 0xff;
    constexpr float most = 255;
    return {static_cast<float>(hex >> 16U & byte) / most, static_cast<float>(hex >> 8U & byte) / most,
            static_cast<float>(hex & byte) / most, alpha};
}

/// What the colours of all widgets are made from.
struct Palette {
    unsigned window, panel, popup, line;
    unsigned field, field_hovered, field_active;
    unsigned button, button_hovered, button_active;
    unsigned text, faint;
    unsigned accent, accent_strong;
    unsigned note, warning, mistake;
    unsigned ground;
};

constexpr Palette dark_palette{
    .window = 0x1b1d20,
    .panel = 0x222528,
    .popup = 0x292c30,
    .line = 0x35393e,
    .field = 0x2e3237,
    .field_hovered = 0x373c42,
    .field_active = 0x41474e,
    .button = 0x33383d,
    .button_hovered = 0x3e444b,
    .button_active = 0x49515a,
    .text = 0xdcdee0,
    .faint = 0x8d949b,
    .accent = 0x6fb58a,
    .accent_strong = 0x8acca2,
    .note = 0xb4bac0,
    .warning = 0xe0b35c,
    .mistake = 0xec8074,
    .ground = 0x2a2d31,
};

constexpr Palette light_palette{
    .window = 0xe9eaeb,
    .panel = 0xf4f5f5,
    .popup = 0xfcfcfc,
    .line = 0xcdd1d4,
    .field = 0xffffff,
    .field_hovered = 0xe9f1ec,
    .field_active = 0xdae9e0,
    .button = 0xe0e3e5,
    .button_hovered = 0xd3d8db,
    .button_active = 0xc4cbcf,
    .text = 0x23272b,
    .faint = 0x6a7279,
    .accent = 0x2f7d50,
    .accent_strong = 0x226240,
    .note = 0x4a5157,
    .warning = 0x8f5f00,
    .mistake = 0xb3261a,
    .ground = 0xd5d8da,
};

const Palette& palette(bool dark) { return dark ? dark_palette : light_palette; }

void set_surfaces(ImVec4* colours, const Palette& p) {
    colours[ImGuiCol_Text] = rgb(p.text);
    colours[ImGuiCol_TextDisabled] = rgb(p.faint);
    colours[ImGuiCol_WindowBg] = rgb(p.window);
    colours[ImGuiCol_ChildBg] = rgb(p.panel);
    colours[ImGuiCol_PopupBg] = rgb(p.popup);
    colours[ImGuiCol_MenuBarBg] = rgb(p.window);
    colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive] = colours[ImGuiCol_TitleBgCollapsed] = rgb(p.popup);
    colours[ImGuiCol_Border] = colours[ImGuiCol_Separator] = colours[ImGuiCol_TableBorderStrong] = rgb(p.line);
    colours[ImGuiCol_TableBorderLight] = rgb(p.line, 0.6F);
    colours[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
    colours[ImGuiCol_TableHeaderBg] = rgb(p.button);
    colours[ImGuiCol_TableRowBg] = {0, 0, 0, 0};
    colours[ImGuiCol_TableRowBgAlt] = rgb(p.text, 0.03F);
    colours[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
    colours[ImGuiCol_ScrollbarGrab] = rgb(p.button);
    colours[ImGuiCol_ScrollbarGrabHovered] = rgb(p.button_hovered);
    colours[ImGuiCol_ScrollbarGrabActive] = rgb(p.button_active);
    colours[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45F};
    colours[ImGuiCol_NavWindowingDimBg] = {0, 0, 0, 0.3F};
}

void set_widgets(ImVec4* colours, const Palette& p) {
    colours[ImGuiCol_FrameBg] = rgb(p.field);
    colours[ImGuiCol_FrameBgHovered] = rgb(p.field_hovered);
    colours[ImGuiCol_FrameBgActive] = rgb(p.field_active);
    colours[ImGuiCol_Button] = rgb(p.button);
    colours[ImGuiCol_ButtonHovered] = rgb(p.button_hovered);
    colours[ImGuiCol_ButtonActive] = rgb(p.button_active);
    colours[ImGuiCol_Header] = rgb(p.accent, 0.22F);
    colours[ImGuiCol_HeaderHovered] = rgb(p.accent, 0.30F);
    colours[ImGuiCol_HeaderActive] = rgb(p.accent, 0.42F);
    colours[ImGuiCol_Tab] = colours[ImGuiCol_TabUnfocused] = rgb(p.window);
    colours[ImGuiCol_TabHovered] = rgb(p.button_hovered);
    colours[ImGuiCol_TabActive] = colours[ImGuiCol_TabUnfocusedActive] = rgb(p.panel);
    colours[ImGuiCol_CheckMark] = colours[ImGuiCol_SliderGrab] = rgb(p.accent);
    colours[ImGuiCol_SliderGrabActive] = rgb(p.accent_strong);
    colours[ImGuiCol_SeparatorHovered] = rgb(p.accent, 0.6F);
    colours[ImGuiCol_SeparatorActive] = rgb(p.accent);
    colours[ImGuiCol_ResizeGrip] = rgb(p.line, 0.6F);
    colours[ImGuiCol_ResizeGripHovered] = rgb(p.accent, 0.6F);
    colours[ImGuiCol_ResizeGripActive] = rgb(p.accent);
    colours[ImGuiCol_PlotLines] = colours[ImGuiCol_PlotHistogram] = rgb(p.accent);
    colours[ImGuiCol_PlotLinesHovered] = colours[ImGuiCol_PlotHistogramHovered] = rgb(p.accent_strong);
    colours[ImGuiCol_TextSelectedBg] = rgb(p.accent, 0.35F);
    colours[ImGuiCol_DragDropTarget] = colours[ImGuiCol_NavHighlight] = rgb(p.accent);
    colours[ImGuiCol_NavWindowingHighlight] = rgb(p.accent_strong);
}

}  // namespace

void apply_theme(bool dark, float scale) {
    ImGuiStyle style;
    style.WindowPadding = {8, 8};
    style.FramePadding = {6, 3};
    style.ItemSpacing = {6, 4};
    style.ItemInnerSpacing = {5, 4};
    style.CellPadding = {4, 2};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowRounding = style.PopupRounding = 4;
    style.ChildRounding = style.FrameRounding = style.GrabRounding = style.TabRounding = 3;
    style.ScrollbarRounding = 6;
    style.WindowTitleAlign = {0.5F, 0.5F};
    style.DisabledAlpha = 0.45F;
    style.ScaleAllSizes(scale);
    set_surfaces(style.Colors, palette(dark));
    set_widgets(style.Colors, palette(dark));
    ImGui::GetStyle() = style;
}

ImVec4 accent_colour(bool dark) { return rgb(palette(dark).accent); }

ImVec4 message_colour(MessageKind kind, bool dark) {
    const Palette& p = palette(dark);
    switch (kind) {
        case MessageKind::warning:
            return rgb(p.warning);
        case MessageKind::mistake:
            return rgb(p.mistake);
        case MessageKind::note:
            break;
    }
    return rgb(p.note);
}

ImVec4 canvas_ground(bool dark) { return rgb(palette(dark).ground); }

}  // namespace rinceau

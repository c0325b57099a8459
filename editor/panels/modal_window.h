#pragma once
// A window before all others, open as long as the state says so.

#include <imgui.h>

namespace rinceau {

/// As ImGui::BeginPopupModal: what is between it and EndPopup() is drawn if it gives true. Call it in every frame, also
/// when nothing is `wanted`: a popup that was open is closed then.
inline bool begin_modal(const char* title, bool wanted, ImGuiWindowFlags flags) {
    if (wanted && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    if (!ImGui::BeginPopupModal(title, nullptr, flags | ImGuiWindowFlags_NoSavedSettings)) return false;
    if (wanted) return true;
    ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return false;
}

}  // namespace rinceau

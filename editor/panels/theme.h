#pragma once
// How the window looks: calm greys and one accent.

#include <imgui.h>

#include "editor/model/editor_state.h"

namespace rinceau {

/// Colours and paddings of Dear ImGui for the frames to come.
void apply_theme(bool dark, float scale);

/// What is selected, running or being dragged.
ImVec4 accent_colour(bool dark);

/// Letters of a message of that kind.
ImVec4 message_colour(MessageKind kind, bool dark);

/// Around the drawing's own paper.
ImVec4 canvas_ground(bool dark);

}  // namespace rinceau

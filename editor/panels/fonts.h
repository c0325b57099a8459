#pragma once
// The letters of the window.

struct ImFont;

namespace rinceau {

struct EditorFonts {
    ImFont* text = nullptr;  ///< DejaVu Sans, or Dear ImGui's own if the system does not have it
    ImFont* mono = nullptr;  ///< DejaVu Sans Mono: for the text of grammars
};

/// Makes the atlas anew, for letters of `scale` times the usual height, drawn with `framebuffer` pixels a window coordinate.
/// The texture on the graphics processor is the caller's to renew.
EditorFonts load_fonts(float scale, float framebuffer);

}  // namespace rinceau

#pragma once
// Where frames are drawn, at which scale and in which theme: the window, or memory for a screenshot.

#include <optional>
#include <utility>

#include "editor/main/editor_options.h"
#include "editor/main/offscreen_frame.h"
#include "editor/main/window.h"
#include "editor/model/shell_state.h"
#include "editor/panels/fonts.h"

namespace rinceau {

class Screen {
  public:
    /// Into memory if the options ask for a screenshot. The window must outlive this.
    Screen(Window& window, const EditorOptions& options);

    /// Begins a frame of Dear ImGui as the shell's state wants it to look.
    void begin(const ShellState& shell);
    /// Draws what Dear ImGui was given since, and shows it.
    void end();

    float scale() const { return scale_; }  ///< of fonts and widgets, in window coordinates
    const EditorFonts& fonts() const { return fonts_; }
    std::pair<int, int> framebuffer_size() const;
    /// The last frame; only of one in memory.
    Picture read() const { return offscreen_->read(); }

  private:
    void fit_to(const ShellState& shell);

    Window& window_;
    EditorOptions options_;
    std::optional<OffscreenFrame> offscreen_;
    EditorFonts fonts_;
    float scale_ = 0;
    float framebuffer_scale_ = 0;
    std::optional<bool> dark_;
};

}  // namespace rinceau

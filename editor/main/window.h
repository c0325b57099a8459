#pragma once
// A window with an OpenGL context and Dear ImGui in it.

#include <string>

struct GLFWwindow;

namespace rinceau {

/// Factors between the units of a display.
struct DisplayScale {
    float widgets = 1;      ///< size of fonts and widgets in window coordinates, beside that of an ordinary display
    float framebuffer = 1;  ///< pixels per window coordinate
};

class Window {
  public:
    /// `visible` = false: nobody sees it; it is drawn elsewhere. Throws std::runtime_error with the reason if no window
    /// can be opened.
    Window(int width, int height, bool visible);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    DisplayScale display_scale() const;
    void set_title(const std::string& title);

  private:
    GLFWwindow* window_ = nullptr;
    std::string title_;
};

}  // namespace rinceau

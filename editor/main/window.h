#pragma once
// A window with an OpenGL context and Dear ImGui in it.

#include <functional>
#include <stdexcept>
#include <string>

struct GLFWwindow;

namespace rinceau {

/// Factors between the units of a display.
struct DisplayScale {
    float widgets = 1;      ///< size of fonts and widgets in window coordinates, beside that of an ordinary display
    float framebuffer = 1;  ///< pixels per window coordinate
};

/// What a window tells; arguments as GLFW's.
struct WindowEvents {
    std::function<void(int key, int scancode, int action, int mods)> key;
    std::function<void(unsigned letter)> letter;
    std::function<void(std::string file)> drop;
};

/// what() is the reason that the system gives.
class NoWindow : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class Window {
  public:
    /// `visible` = false: nobody sees it; it is drawn elsewhere. Throws NoWindow.
    Window(int width, int height, bool visible);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    DisplayScale display_scale() const;
    /// Keys and letters no longer go to Dear ImGui by themselves.
    void set_events(WindowEvents events);
    void set_title(const std::string& title);

  private:
    GLFWwindow* window_ = nullptr;
    std::string title_;
    WindowEvents events_;
};

}  // namespace rinceau

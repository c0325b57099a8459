#pragma once
// OpenGL without anything on the screen.

#include <cstdint>
#include <memory>
#include <vector>

namespace rinceau::test {

/// A context of OpenGL 3.3, current as long as it lives. Needs a display. Throws std::runtime_error if there is none.
class HiddenWindow {
  public:
    HiddenWindow();
    ~HiddenWindow();
    HiddenWindow(const HiddenWindow&) = delete;
    HiddenWindow& operator=(const HiddenWindow&) = delete;

  private:
    struct Handle;
    std::unique_ptr<Handle> handle_;
};

/// Red, green, blue, opacity a pixel, from the upper row down, of a texture whose lowest row comes first.
std::vector<std::uint8_t> texture_pixels(unsigned texture, int width, int height);

/// Waits until all that was asked for is drawn.
void finish_drawing();

/// Has OpenGL complained since it was asked the last time?
bool opengl_complains();

}  // namespace rinceau::test

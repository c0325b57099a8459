#include "editor/main/screen.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include "editor/panels/theme.h"

namespace rinceau {

Screen::Screen(Window& window, const EditorOptions& options) : window_(window), options_(options) {
    if (!options.screenshot.empty()) offscreen_.emplace(options.width, options.height);
}

// Letters are drawn anew when the scale changes, so that they are crisp at each.
void Screen::fit_to(const ShellState& shell) {
    const DisplayScale display = offscreen_ ? DisplayScale{} : window_.display_scale();
    const float scale = (options_.scale > 0 ? options_.scale : display.widgets) * shell.text_scale;
    const bool resized = scale != scale_ || display.framebuffer != framebuffer_scale_;
    if (resized) {
        scale_ = scale;
        framebuffer_scale_ = display.framebuffer;
        fonts_ = load_fonts(scale, display.framebuffer);
        ImGui_ImplOpenGL3_DestroyFontsTexture();  // made again from the new atlas with the frame
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    if (!resized && dark_ == shell.dark) return;
    dark_ = shell.dark;
    apply_theme(shell.dark, scale);
}

void Screen::begin(const ShellState& shell) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    fit_to(shell);
    if (offscreen_) {
        ImGui::GetIO().DisplaySize = {static_cast<float>(options_.width), static_cast<float>(options_.height)};
        ImGui::GetIO().DisplayFramebufferScale = {1, 1};
    }
    ImGui::NewFrame();
}

void Screen::end() {
    ImGui::Render();
    const auto [width, height] = framebuffer_size();
    if (offscreen_) {
        offscreen_->bind();
    } else {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    glViewport(0, 0, width, height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (!offscreen_) glfwSwapBuffers(window_.handle());
}

std::pair<int, int> Screen::framebuffer_size() const {
    if (offscreen_) return {options_.width, options_.height};
    std::pair<int, int> size;
    glfwGetFramebufferSize(window_.handle(), &size.first, &size.second);
    return size;
}

}  // namespace rinceau

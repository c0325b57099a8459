#include "editor/main/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <utility>

namespace rinceau {
namespace {

constexpr const char* program_name = "Rinceau";
constexpr int least_width = 640;  ///< of the window, which the user may still drag smaller than is comfortable
constexpr int least_height = 400;

[[noreturn]] void fail() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    const std::string told = reason != nullptr ? reason : "no reason given";
    glfwTerminate();
    throw NoWindow(told);
}

}  // namespace

Window::Window(int width, int height, bool visible) : title_(program_name) {
    if (glfwInit() != GLFW_TRUE) fail();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SAMPLES, 0);  // the canvas smooths by itself
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, program_name);
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, program_name);
    window_ = glfwCreateWindow(width, height, program_name, nullptr, nullptr);
    if (window_ == nullptr) fail();
    glfwSetWindowSizeLimits(window_, least_width, least_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // preferences are kept by the program itself
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

DisplayScale Window::display_scale() const {
    int width = 0, height = 0, pixels_across = 0, pixels_down = 0;
    glfwGetWindowSize(window_, &width, &height);
    glfwGetFramebufferSize(window_, &pixels_across, &pixels_down);
    float content = 1, unused = 1;
    glfwGetWindowContentScale(window_, &content, &unused);
    DisplayScale scale;
    if (width > 0 && pixels_across > 0) scale.framebuffer = static_cast<float>(pixels_across) / static_cast<float>(width);
    if (content > 0) scale.widgets = content / scale.framebuffer;
    return scale;
}

void Window::set_events(WindowEvents events) {
    events_ = std::move(events);
    glfwSetWindowUserPointer(window_, &events_);
    const auto key = [](GLFWwindow* window, int code, int scancode, int action, int mods) {
        static_cast<WindowEvents*>(glfwGetWindowUserPointer(window))->key(code, scancode, action, mods);
    };
    const auto letter = [](GLFWwindow* window, unsigned code) {
        static_cast<WindowEvents*>(glfwGetWindowUserPointer(window))->letter(code);
    };
    const auto drop = [](GLFWwindow* window, int count, const char** files) {
        for (int i = 0; i < count; ++i) static_cast<WindowEvents*>(glfwGetWindowUserPointer(window))->drop(files[i]);
    };
    glfwSetKeyCallback(window_, key);
    glfwSetCharCallback(window_, letter);
    glfwSetDropCallback(window_, drop);
}

void Window::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
}

}  // namespace rinceau

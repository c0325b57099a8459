#include "editor/main/session.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <cstdio>
#include <utility>

#include "editor/effects/effects.h"
#include "editor/gl/picture_renderer.h"
#include "editor/model/update.h"
#include "editor/panels/panel.h"

namespace rinceau {
namespace {

/// A window with its context and Dear ImGui in it.
class Window {
  public:
    explicit Window(const EditorOptions& options) {
        if (glfwInit() != GLFW_TRUE) return;
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        window_ = glfwCreateWindow(options.width, options.height, "Rinceau", nullptr, nullptr);
        if (window_ == nullptr) return;
        glfwMakeContextCurrent(window_);
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui_ImplGlfw_InitForOpenGL(window_, true);
        ImGui_ImplOpenGL3_Init("#version 330 core");
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window() {
        if (window_ != nullptr) {
            ImGui_ImplOpenGL3_Shutdown();
            ImGui_ImplGlfw_Shutdown();
            ImGui::DestroyContext();
            glfwDestroyWindow(window_);
        }
        glfwTerminate();
    }
    GLFWwindow* handle() const { return window_; }

  private:
    GLFWwindow* window_ = nullptr;
};

class Session {
  public:
    Session(GLFWwindow* window, const EditorOptions& options)
        : window_(window), state_(initial_state()), answers_(glfwPostEmptyEvent), effects_(answers_) {
        if (!options.file.empty()) act(FileAction{OpenFile{options.file}});
    }
    void run() {
        while (!effects_.wants_to_close()) {
            wait();
            if (glfwWindowShouldClose(window_) != 0) {
                glfwSetWindowShouldClose(window_, GLFW_FALSE);
                act(FileAction{QuitEditor{}});
            }
            frame();
        }
    }

  private:
    static constexpr double longest_wait = 0.5;  // seconds: a text cursor blinks

    void wait() {
        if (pending_frames_ > 0 || renderer_.refining()) {
            --pending_frames_;
            glfwPollEvents();
        } else {
            glfwWaitEventsTimeout(longest_wait);
            pending_frames_ = 2;  // ImGui shows the effect of an input one frame later
        }
    }
    void act(const Action& action) {
        Update next = update(std::move(state_), action);
        state_ = std::move(next.state);
        for (const Request& request : next.requests) effects_.fulfil(request);
        for (const Action& answer : answers_.drain()) act(answer);
    }
    void frame() {
        for (const Action& answer : answers_.drain()) act(answer);
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        PanelTools tools;
        tools.canvas_texture = renderer_.draw(state_.picture, state_.canvas.view);
        const Actions actions = editor_window(state_, tools);
        ImGui::Render();
        int width = 0;
        int height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        glViewport(0, 0, width, height);
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        glfwSwapBuffers(window_);
        for (const Action& action : actions) act(action);
        if (!actions.empty()) pending_frames_ = 2;
    }

    GLFWwindow* window_;
    EditorState state_;
    ActionQueue answers_;
    Effects effects_;
    PictureRenderer renderer_;
    int pending_frames_ = 2;
};

}  // namespace

int run_editor(const EditorOptions& options) {
    const Window window(options);
    if (window.handle() == nullptr) {
        std::fputs("rinceau edit: no window could be opened: a display and OpenGL 3.3 are needed\n", stderr);
        return 1;
    }
    Session(window.handle(), options).run();
    return 0;
}

}  // namespace rinceau

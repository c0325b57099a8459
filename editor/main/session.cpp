#include "editor/main/session.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "editor/effects/effects.h"
#include "editor/main/canvas_emphasis.h"
#include "editor/gl/picture_renderer.h"
#include "editor/main/offscreen_frame.h"
#include "editor/main/window.h"
#include "editor/model/update.h"
#include "editor/panels/panel.h"
#include "files/files.h"
#include "files/output_error.h"
#include "scene/input_error.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

namespace status {
constexpr int done = 0;
constexpr int input_at_fault = 1;
constexpr int output_not_written = 4;
}  // namespace status

class Session {
  public:
    Session(Window& window, const EditorOptions& options)
        : window_(window), options_(options), state_(initial_state()), answers_(glfwPostEmptyEvent), effects_(answers_) {
        if (!options.screenshot.empty()) offscreen_.emplace(options.width, options.height);
        if (!options.file.empty()) act(FileAction{OpenFile{options.file}});
    }
    void run() {
        while (!effects_.wants_to_close()) {
            wait();
            if (glfwWindowShouldClose(window_.handle()) != 0) {
                glfwSetWindowShouldClose(window_.handle(), GLFW_FALSE);
                act(FileAction{QuitEditor{}});
            }
            frame();
        }
    }
    /// The window when nothing changes any more. Throws InputError if the file could not be opened.
    Picture settled_frame() {
        while (pending_frames_ > 0 || is_busy(state_) || renderer_.refining()) {
            wait();
            frame();
        }
        for (const EditorMessage& message : state_.messages)
            if (message.kind == MessageKind::mistake) throw InputError({}, message.text);
        return offscreen_->read();
    }

  private:
    static constexpr double longest_wait = 0.5;  // seconds: a text cursor blinks
    static constexpr int frames_of_input = 2;    // ImGui shows the effect of an input one frame later

    void wait() {
        if (pending_frames_ > 0 || renderer_.refining()) {
            pending_frames_ = std::max(0, pending_frames_ - 1);
            glfwPollEvents();
        } else {
            glfwWaitEventsTimeout(longest_wait);
            pending_frames_ = frames_of_input;
        }
    }
    void act(const Action& action) {
        Update next = update(std::move(state_), action);
        state_ = std::move(next.state);
        for (const Request& request : next.requests) effects_.fulfil(request);
        for (const Action& answer : answers_.drain()) act(answer);
    }
    void frame() {
        for (const Action& answer : answers_.drain()) {
            act(answer);
            pending_frames_ = frames_of_input;
        }
        begin_frame();
        PanelTools tools;
        const DisplayScale display = offscreen_ ? DisplayScale{} : window_.display_scale();
        tools.scale = options_.scale > 0 ? options_.scale : display.widgets;
        tools.canvas_texture = renderer_.draw(state_.picture, state_.canvas.view, emphasis_of(state_.canvas));
        std::vector<WidgetPlace> places;
        if (!options_.places.empty()) tools.places = &places;
        const Actions actions = editor_window(state_, tools);
        end_frame();
        for (const Action& action : actions) act(action);
        if (!actions.empty()) pending_frames_ = frames_of_input;
        if (!options_.places.empty()) write_trace(std::move(places), tools.scale);
    }
    void begin_frame() {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        if (offscreen_) {
            ImGui::GetIO().DisplaySize = {static_cast<float>(options_.width), static_cast<float>(options_.height)};
            ImGui::GetIO().DisplayFramebufferScale = {1, 1};
        }
        ImGui::NewFrame();
    }
    void end_frame() {
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
    std::pair<int, int> framebuffer_size() const {
        if (offscreen_) return {options_.width, options_.height};
        std::pair<int, int> size;
        glfwGetFramebufferSize(window_.handle(), &size.first, &size.second);
        return size;
    }
    void write_trace(std::vector<WidgetPlace> places, float scale) {
        const auto [width, height] = framebuffer_size();
        const std::string text = to_json({.title = "Rinceau",
                                          .frame = ++frame_,
                                          .busy = is_busy(state_) || pending_frames_ > 0,
                                          .refining = renderer_.refining(),
                                          .width = width,
                                          .height = height,
                                          .scale = scale,
                                          .widgets = std::move(places)});
        // Not by write_output(): that waits for the disk, which a frame must not.
        const std::string beside = options_.places + ".new";
        std::ofstream(beside, std::ios::binary) << text;
        std::error_code ignored;
        std::filesystem::rename(beside, options_.places, ignored);
    }

    Window& window_;
    EditorOptions options_;
    EditorState state_;
    ActionQueue answers_;
    Effects effects_;
    PictureRenderer renderer_;
    std::optional<OffscreenFrame> offscreen_;
    int pending_frames_ = frames_of_input;
    std::uint64_t frame_ = 0;
};

int take_screenshot(Window& window, const EditorOptions& options) {
    try {
        expect_writable(options.screenshot);
        const Picture frame = Session(window, options).settled_frame();
        write_output(options.screenshot, picture_to_png(frame));
        return status::done;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return status::input_at_fault;
    } catch (const OutputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return status::output_not_written;
    }
}

}  // namespace

int run_editor(const EditorOptions& options) {
    try {
        Window window(options.width, options.height, options.screenshot.empty());
        if (!options.screenshot.empty()) return take_screenshot(window, options);
        Session(window, options).run();
        return status::done;
    } catch (const std::runtime_error& error) {
        std::fprintf(stderr,
                     "rinceau edit: no window could be opened (%s). A display with OpenGL 3.3 is needed: start it from a "
                     "desktop, or under a virtual display as 'xvfb-run rinceau edit'.\n",
                     error.what());
        return status::input_at_fault;
    }
}

}  // namespace rinceau

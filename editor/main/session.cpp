#include "editor/main/session.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "editor/effects/effects.h"
#include "editor/effects/kept_preferences.h"
#include "editor/effects/state_folders.h"
#include "editor/gl/picture_renderer.h"
#include "editor/gl/surface_renderer.h"
#include "editor/gl/thumbnails.h"
#include "editor/main/canvas_emphasis.h"
#include "editor/main/keyboard.h"
#include "editor/main/screen.h"
#include "editor/main/window.h"
#include "editor/model/command.h"
#include "editor/model/growth_view.h"
#include "editor/model/state_preferences.h"
#include "editor/model/surface_stage.h"
#include "editor/model/surface_view.h"
#include "editor/model/update.h"
#include "editor/panels/frame_timing.h"
#include "editor/panels/panel.h"
#include "editor/panels/theme.h"
#include "files/files.h"
#include "files/output_file.h"
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

Color colour_of(const ImVec4& colour) {
    const auto byte = [](float part) { return static_cast<std::uint8_t>(std::lround(255 * part)); };
    return {byte(colour.x), byte(colour.y), byte(colour.z)};
}

PictureSurround surround(bool dark) { return {.ground = colour_of(canvas_ground(dark))}; }

SurfacePicture surface_picture(const SurfaceState& surface, bool dark) {
    SurfacePicture picture{.behind = colour_of(canvas_ground(dark))};
    if (!surface.stage) return picture;
    const SurfaceSettings& settings = surface.settings;
    if (settings.ground) picture.ground = surface.stage->ground;
    picture.wireframe = settings.wireframe;
    if (surface.grown) picture.pattern = surface.grown->assembly;
    if (surface.field && settings.streamlines) picture.lines = surface.field->streamlines;
    return picture;
}

class Session {
  public:
    Session(Window& window, const EditorOptions& options)
        : window_(window),
          options_(options),
          screen_(window, options),
          keyboard_(window.handle()),
          state_(initial_state()),
          answers_(glfwPostEmptyEvent),
          effects_(answers_, folders_of(options)) {
        listen();
        if (options.screenshot.empty()) begin_keeping();
        if (options.light) act(ShellAction{SetDarkTheme{false}});
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
        while (wants_frame() || is_busy(state_)) {
            wait();
            frame();
        }
        for (const EditorMessage& message : state_.messages)
            if (message.kind == MessageKind::mistake) throw InputError({}, message.text);
        return screen_.read();
    }

  private:
    static constexpr int frames_of_input = 2;  // ImGui shows the effect of an input one frame later
    static constexpr double seconds_a_tick = 1;

    /// A screenshot shows the file alone, whatever was done before.
    static KeptFolders folders_of(const EditorOptions& options) {
        return options.screenshot.empty() ? KeptFolders{state_folder(), config_folder()} : KeptFolders{};
    }
    void begin_keeping() {
        const PreferencesInFile read = read_preferences(config_folder());
        act(RecoveryAction{PreferencesRead{read.preferences, read.mistake}});
        if (options_.autosave_seconds > 0) state_.recovery.interval = options_.autosave_seconds;
        act(RecoveryAction{LookForRecoverables{}});
    }
    /// Once a second: what is kept against a crash. True if something was asked for.
    bool tick() {
        const double now = glfwGetTime();
        if (!options_.screenshot.empty() || now < last_tick_ + seconds_a_tick) return false;
        last_tick_ = now;
        return act(RecoveryAction{Tick{now}});
    }
    void listen() {
        window_.set_events({
            .key = [this](int key, int scancode, int action, int mods) { keyboard_.on_key(key, scancode, action, mods); },
            .letter = [this](unsigned letter) { keyboard_.on_letter(letter); },
            .drop = [this](std::string file) { act(FileAction{OpenFile{std::move(file)}}); },
        });
    }
    bool wants_frame() const {
        return pending_frames_ > 0 || renderer_.refining() || thumbnails_.waiting() || keyboard_.is_waiting();
    }

    /// For whatever comes first: input, an answer, or time for the next frame.
    void wait() {
        if (wants_frame()) {
            pending_frames_ = std::max(0, pending_frames_ - 1);
            glfwPollEvents();
            if (window_.had_input()) pending_frames_ = frames_of_input;
            return;
        }
        const double frame_due = glfwGetTime() + seconds_to_next_frame();
        for (bool due = false; !due;) {
            const double to_frame = frame_due - glfwGetTime();
            const double seconds = wants_tick(state_) ? std::min(to_frame, seconds_a_tick) : to_frame;
            if (std::isfinite(seconds)) {
                if (seconds > 0) glfwWaitEventsTimeout(seconds);
            } else {
                glfwWaitEvents();
            }
            const bool ticked = tick();
            take_answers();
            due = window_.had_input() || ticked || pending_frames_ > 0 || glfwGetTime() >= frame_due;
        }
        pending_frames_ = frames_of_input;
    }
    void take_answers() {
        const Actions answers = answers_.drain();
        if (!answers.empty()) pending_frames_ = frames_of_input;
        for (const Action& answer : answers) act(answer);
    }
    /// True if the action asked for something.
    bool act(const Action& action) {
        Update next = update(std::move(state_), action);
        state_ = std::move(next.state);
        for (const Request& request : next.requests) effects_.fulfil(request);
        take_answers();
        return !next.requests.empty();
    }
    /// A key gives its command, unless it is for the text that is being typed or for an open menu.
    bool take(const KeyPress& press) {
        constexpr ImGuiPopupFlags any_popup = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
        if (ImGui::IsPopupOpen(nullptr, any_popup)) return false;
        if (ImGui::GetIO().WantTextInput && belongs_to_text(press.chord)) return false;
        const Command* command = command_of_key(commands(), meanings(press.chord, press.position));
        if (command == nullptr) return false;
        if (is_enabled(*command, state_) && (command->repeats || !press.repeated)) act(command->action(state_));
        return press.chord.key != "Escape";  // which Dear ImGui wants to know of, too
    }
    void frame() {
        tick();
        take_answers();
        keyboard_.feed([this](const KeyPress& press) { return take(press); });
        show_title();
        screen_.begin(state_.shell);
        PanelTools tools;
        tools.scale = screen_.scale();
        tools.fonts = screen_.fonts();
        draw_canvas(tools);
        thumbnails_.begin_frame();
        tools.thumbnail = [this](int look) { return thumbnail(look); };
        std::vector<WidgetPlace> places;
        if (!options_.places.empty()) tools.places = &places;
        const Actions actions = editor_window(state_, tools);
        screen_.end();
        for (const Action& action : actions) act(action);
        if (!actions.empty()) pending_frames_ = frames_of_input;
        if (!options_.places.empty()) write_trace(std::move(places));
    }
    void draw_canvas(PanelTools& tools) {
        if (shows_surface(state_)) {
            if (!surfaces_) surfaces_.emplace();
            tools.canvas_texture = surfaces_->draw(surface_picture(state_.surface, state_.shell.dark), state_.surface.view);
            return;
        }
        // flags of emphasis count the document's elements
        const PictureEmphasis emphasis = shows_grown(state_) ? PictureEmphasis{} : emphasis_of(state_.canvas);
        tools.canvas_texture =
            renderer_.draw(canvas_picture(state_), state_.canvas.view, emphasis, {.surround = surround(state_.shell.dark)});
        tools.shortcoming = renderer_.shortcoming();
    }
    unsigned thumbnail(int look) {
        if (!state_.picture) return 0;
        constexpr float side = 48;  // at scale 1
        return thumbnails_.thumbnail(state_.picture, look, static_cast<int>(side * screen_.scale())).value_or(0);
    }
    void show_title() {
        title_ = window_title(state_);
        window_.set_title(title_);
    }
    void write_trace(std::vector<WidgetPlace> places) {
        const auto [width, height] = screen_.framebuffer_size();
        const std::string text = to_json({.title = title_,
                                          .frame = ++frame_,
                                          .busy = is_busy(state_) || pending_frames_ > 0 || keyboard_.is_waiting(),
                                          .refining = renderer_.refining(),
                                          .width = width,
                                          .height = height,
                                          .scale = screen_.scale(),
                                          .widgets = std::move(places)});
        // Not by write_output(): that waits for the disk, which a frame must not.
        const std::string beside = options_.places + ".new";
        std::ofstream(beside, std::ios::binary) << text;
        std::error_code ignored;
        std::filesystem::rename(beside, options_.places, ignored);
    }

    Window& window_;
    EditorOptions options_;
    Screen screen_;
    Keyboard keyboard_;
    EditorState state_;
    ActionQueue answers_;
    Effects effects_;
    PictureRenderer renderer_;
    ThumbnailRenderer thumbnails_;
    std::optional<SurfaceRenderer> surfaces_;  ///< made when a surface is first shown
    int pending_frames_ = frames_of_input;
    std::uint64_t frame_ = 0;
    std::string title_;
    double last_tick_ = 0;
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
    } catch (const NoWindow& error) {
        std::fprintf(stderr,
                     "rinceau edit: no window could be opened (%s). A display with OpenGL 3.3 is needed: start it from a "
                     "desktop, or under a virtual display as 'xvfb-run rinceau edit'.\n",
                     error.what());
        return status::input_at_fault;
    }
}

}  // namespace rinceau

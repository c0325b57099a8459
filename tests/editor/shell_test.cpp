#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <set>

#include "editor/model/places_json.h"
#include "editor/model/update.h"
#include "editor/model/window_layout.h"

using namespace rinceau;

namespace {

EditorState after(EditorState state, const ShellAction& action) { return update(std::move(state), action).state; }

}  // namespace

TEST_CASE("the keyboard goes round all open panels and back again") {
    EditorState state = after(initial_state(), ShowPanel{EditorPanel::analysis, false});
    std::set<EditorPanel> visited;
    for (int i = 0; i < 5; ++i) {
        state = after(state, FocusNextPanel{1});
        REQUIRE(state.shell.focus_wanted);
        const EditorPanel panel = *state.shell.focus_wanted;
        CHECK(is_open(state.shell, panel));
        CHECK(visited.insert(panel).second);
        state = after(state, PanelFocused{panel});
        CHECK_FALSE(state.shell.focus_wanted);
    }
    CHECK(visited == std::set{EditorPanel::terminals, EditorPanel::canvas, EditorPanel::rules, EditorPanel::tools,
                              EditorPanel::growth});
    const EditorPanel here = state.shell.focused;
    state = after(after(state, FocusNextPanel{1}), FocusNextPanel{-1});
    CHECK(state.shell.focus_wanted == here);
}

TEST_CASE("a panel that the keyboard is sent to is shown, with its column and tab") {
    EditorState state = after(initial_state(), ShowLeftColumn{false});
    state = after(state, ShowPanel{EditorPanel::rules, false});
    CHECK_FALSE(is_open(state.shell, EditorPanel::terminals));
    state = after(after(state, FocusPanel{EditorPanel::terminals}), FocusPanel{EditorPanel::tools});
    CHECK(is_open(state.shell, EditorPanel::terminals));
    CHECK(is_open(state.shell, EditorPanel::tools));
    CHECK(state.shell.right_tab == EditorPanel::tools);
}

TEST_CASE("text and panels keep within reason, whatever is asked") {
    EditorState state = initial_state();
    for (const float wild : {-1.0F, 0.0F, 1e9F, std::numeric_limits<float>::infinity()}) {
        state = after(state, SetTextScale{wild});
        CHECK(state.shell.text_scale >= 0.5F);
        CHECK(state.shell.text_scale <= 3);
        state = after(state, ResizePanels{{wild, wild, wild, wild}});
        CHECK(state.shell.sizes.left >= 50);
        CHECK(state.shell.sizes.right <= 5000);
        CHECK(state.shell.sizes.terminals_share > 0);
        CHECK(state.shell.sizes.terminals_share < 1);
    }
    const float kept = state.shell.text_scale;
    state = after(state, SetTextScale{std::numeric_limits<float>::quiet_NaN()});
    CHECK(state.shell.text_scale == kept);
}

TEST_CASE("columns and rows fill the window, and the canvas is never lost") {
    const bool left = GENERATE(false, true);
    const bool right = GENERATE(false, true);
    const bool log = GENERATE(false, true);
    const float scale = GENERATE(1.0F, 2.0F);
    const float width = GENERATE(640.0F, 1024.0F, 2048.0F);
    ShellState shell;
    shell.shown = {.left = left, .right = right, .log = log};
    shell.sizes = {.left = 600, .right = 700, .log = 900};
    const float height = 620;
    const WindowLayout layout = window_layout(shell, {width, height, 20 * scale, scale});
    CAPTURE(left, right, log, scale, width);
    const float splitters = layout.splitter * static_cast<float>(int{left} + int{right});
    CHECK(layout.left + layout.canvas + layout.right + splitters == Approx(width));
    CHECK(layout.canvas >= width / 3 - 1);
    CHECK(layout.body + layout.log + (log ? layout.splitter : 0) == Approx(height));
    CHECK(layout.body >= 0.45F * height);
    if (left) CHECK(layout.terminals + layout.analysis + layout.splitter + 2 * 20 * scale == Approx(layout.body).margin(1));
    CHECK((layout.left > 0) == left);
    CHECK((layout.right > 0) == right);
}

TEST_CASE("the title names the file and marks unsaved changes") {
    EditorState state = initial_state();
    CHECK(window_title(state) == "Untitled – Rinceau");
    state.file.path = "/art/facade.lsys";
    Grammar changed;
    changed.title = "another";
    state.document.grammar = std::make_shared<const Grammar>(changed);
    CHECK(window_title(state) == "*facade.lsys – Rinceau");
}

TEST_CASE("the trace is JSON that holds what the window shows") {
    const std::string json = to_json(WindowTrace{.title = "a \"b\"", .frame = 7, .width = 3, .height = 4, .widgets = {{"x/y", 1, 2, 3, 4}}});
    CHECK(json.find("\"framebuffer\":[3,4]") != std::string::npos);
    CHECK(json.find("\"name\":\"x/y\"") != std::string::npos);
    CHECK(json.find("a \\\"b\\\"") != std::string::npos);
}

#include "how_to/legend_panel.h"

#include <imgui.h>
#include <catch2/catch.hpp>

#include <algorithm>

#include "editor/model/update.h"
#include "how_to/colour_legend.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;

namespace {

/// What update() asks for is fulfilled at once.
EditorState acted(EditorState state, const Action& action) {
    Update next = update(std::move(state), action);
    for (const Request& request : next.requests) {
        const auto* derive = std::get_if<DerivePicture>(&request);
        if (derive == nullptr) continue;
        auto picture = std::make_shared<const DerivedPicture>(derive_picture(derive->document));
        next.state = acted(std::move(next.state), CanvasAction{PictureDerived{derive->revision, picture}});
    }
    return std::move(next.state);
}

EditorState opened(const std::string& rules) {
    const Grammar grammar = parse_grammar("lsystem 1\ncanvas 0 -50 100 100\n" + rules);
    EditorState asked = acted(initial_state(), FileAction{OpenFile{"x.lsys"}});
    return acted(std::move(asked), FileAction{FileOpened{"x.lsys", with_grammar(empty_document(), grammar), {}}});
}

/// Four red leaves with black outlines, two blue ones, and one that a command paints green.
EditorState leaves() {
    return opened(
        "axiom: P(4) Q(2) fill(0, 255, 0) B\nP(m) : m > 0 -> [A] f(9) P(m-1)\nQ(m) : m > 0 -> [B] f(9) Q(m-1)\n"
        "style 1: fill #ff0000; stroke #000000\nstyle 2: fill #0000ff\n"
        "terminal A: style 1; path \"M0 0L4 -9L-4 -9Z\"\nterminal B: style 2; path \"M0 0L3 -5L-3 -5Z\"");
}

/// Dear ImGui without window, keyboard and graphics: frames are made and thrown away.
class Frames {
  public:
    Frames() : context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {400, 300};
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    Frames(const Frames&) = delete;
    Frames& operator=(const Frames&) = delete;
    ~Frames() { ImGui::DestroyContext(context_); }

    /// The panel in a window of its own, with the mouse at a place; what it noted is in `places` afterwards.
    Actions draw(const EditorState& state, ImVec2 mouse) {
        places.clear();
        PanelTools tools;
        tools.places = &places;
        ImGui::GetIO().MousePos = mouse;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("Legend", nullptr, ImGuiWindowFlags_NoDecoration);
        Actions actions = legend_panel(state, tools);
        ImGui::End();
        ImGui::Render();
        vertices = ImGui::GetDrawData()->TotalVtxCount;
        return actions;
    }
    ImVec2 middle_of(const std::string& name) const {
        const auto found = std::ranges::find(places, name, &WidgetPlace::name);
        REQUIRE(found != places.end());
        return {(found->left + found->right) / 2, (found->top + found->bottom) / 2};
    }

    std::vector<WidgetPlace> places;
    int vertices = 0;

  private:
    ImGuiContext* context_;
};

const ImVec2 elsewhere{-1, -1};

}  // namespace

TEST_CASE("a legend counts the elements of each colour, those that commands repaint in their new one") {
    const EditorState state = leaves();
    REQUIRE(state.picture);
    const std::vector<LegendColour> legend = colour_legend(*state.picture);
    REQUIRE(legend.size() == 4);
    CHECK(legend[0].color == Color{0, 0, 0});
    CHECK(legend[1].color == Color{255, 0, 0});
    CHECK(legend[0].elements == 4);
    CHECK(legend[1].elements == 4);
    CHECK(legend[2].color == Color{0, 0, 255});
    CHECK(legend[2].elements == 2);
    CHECK(legend[3].color == Color{0, 255, 0});
    CHECK(legend[3].elements == 1);
}

TEST_CASE("the panel shows a row for each colour, in order") {
    Frames frames;
    frames.draw(leaves(), elsewhere);
    const Actions actions = frames.draw(leaves(), elsewhere);
    CHECK(actions.empty());
    CHECK(frames.vertices > 0);
    REQUIRE(frames.places.size() == 4);
    const std::vector<std::string> names{"legend/#000000", "legend/#ff0000", "legend/#0000ff", "legend/#00ff00"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        CHECK(frames.places[i].name == names[i]);
        if (i > 0) CHECK(frames.places[i].top >= frames.places[i - 1].bottom);
    }
}

TEST_CASE("on a row its elements are lit on the canvas, and beside it none") {
    Frames frames;
    EditorState state = leaves();
    frames.draw(state, elsewhere);
    const ImVec2 row = frames.middle_of("legend/#0000ff");
    for (int frame = 0; frame < 3; ++frame)
        for (const Action& action : frames.draw(state, row)) state = acted(std::move(state), action);
    REQUIRE(state.canvas.lit);
    CHECK(std::ranges::count(*state.canvas.lit, char{1}) == 2);
    for (const PictureItem& item : state.picture->items) {
        const bool blue = (*state.canvas.lit)[static_cast<std::size_t>(item.order)] != 0;
        CHECK(blue == (item.order == 4 || item.order == 5));
    }
    CHECK(frames.draw(state, row).empty());  // nothing is asked for again while nothing changes
    for (int frame = 0; frame < 2; ++frame)
        for (const Action& action : frames.draw(state, elsewhere)) state = acted(std::move(state), action);
    CHECK_FALSE(state.canvas.lit);
}

TEST_CASE("without a picture the panel says so") {
    Frames frames;
    CHECK(frames.draw(initial_state(), elsewhere).empty());
    CHECK(frames.places.empty());
}

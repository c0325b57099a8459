// Surfaces in the editor: the eye that goes round, marks, and what changes ask for. The work itself is tested with the
// library.

#include <catch2/catch.hpp>

#include "editor/model/surface_stage.h"
#include "editor/model/surface_view.h"
#include "editor_desk.h"

using namespace rinceau;

namespace {

/// A square of four triangles in the plane z = 0, facing +z.
constexpr const char* square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

/// The square, seen from the front in 200 x 100 pixels.
struct SurfaceDesk {
    TestFolder folder;
    EditorDesk desk;

    SurfaceDesk() {
        write_output(folder / "square.obj", square);
        desk.act(FileAction{OpenFile{folder / "square.obj"}});
        desk.act(SurfaceAction{ResizeSurfaceView{{200, 100}}});
        settle();
        desk.changeable().surface.view.azimuth = desk.changeable().surface.view.elevation = 0;
        desk.act(SurfaceAction{FitSurface{}});
    }
    const SurfaceState& surface() const { return desk.state().surface; }
    void settle() {
        desk.until([this] { return !surface_is_busy(surface()); });
    }
    void set(const std::function<void(SurfaceSettings&)>& change) {
        SurfaceSettings settings = surface().settings;
        change(settings);
        desk.act(SurfaceAction{SetSurface{settings}});
    }
    void click(Point at) {
        desk.act(SurfaceAction{PressSurface{at, 5}});
        desk.act(SurfaceAction{ReleaseSurface{}});
    }
};

}  // namespace

TEST_CASE("what lies under a point of the view is seen at that point, however the eye stands") {
    TriangleMesh mesh{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0.5}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    const SurfaceMesh surface = surface_mesh(mesh);
    for (const bool z_up : {false, true}) {
        OrbitView view{.azimuth = 0.3, .elevation = z_up ? 1.2 : 0.2, .size = {300, 200}, .z_up = z_up};
        view = fitted_to(view, {-1, -1, 0}, {1, 1, 0.5});
        const auto under = surface_point_under(surface, view, {150, 100});
        REQUIRE(under);
        CHECK(abs(seen_at(view, position_in_space(surface, *under)).at - Point{150, 100}) < 1e-9);
        CHECK_FALSE(surface_point_under(surface, view, {1, 1}));
    }
}

TEST_CASE("zooming leaves the place under the mouse where it is, and turning the middle") {
    OrbitView view{.zoom = 10, .size = {300, 200}};
    const SpacePoint place{0.7, 0.2, -0.1};
    const Point at = seen_at(view, place).at;
    CHECK(abs(seen_at(zoomed_at(view, at, 3), place).at - at) < 1e-9);
    CHECK(abs(seen_at(turned_by(view, {40, -25}), view.centre).at - Point{150, 100}) < 1e-9);
    CHECK(abs(seen_at(panned_by(view, {4, 5}), place).at - (at + Point{4, 5})) < 1e-9);
}

TEST_CASE("a mesh that is opened stands beside the document, as large as fits") {
    const SurfaceDesk desk;
    REQUIRE(desk.surface().stage);
    CHECK(desk.surface().stage->told.starts_with("4 faces"));
    CHECK(shows_surface(desk.desk.state()));
    CHECK(desk.desk.state().file.path.empty());
    const double top = seen_at(desk.surface().view, {0, 1, 0}).at.y;
    CHECK(top > 0);
    CHECK(top < 15);
}

TEST_CASE("a file that is no surface is told, and the surface before stays") {
    SurfaceDesk desk;
    write_output(desk.folder / "bad.obj", "v 0 0 0\nf 1 2 3\n");
    const auto before = desk.surface().stage;
    desk.desk.act(SurfaceAction{OpenMesh{desk.folder / "bad.obj"}});
    desk.settle();
    CHECK(desk.surface().stage == before);
    CHECK(desk.surface().mistake.find("bad.obj:2") != std::string::npos);
}

TEST_CASE("a click puts an element, a drag moves it, and the field follows each") {
    SurfaceDesk desk;
    desk.set([](SurfaceSettings& settings) {
        settings.tool = SurfaceTool::element;
        settings.element = "node";
        settings.field.smooth = 0;
    });
    desk.click({100, 50});
    REQUIRE(desk.surface().settings.field.elements.size() == 1);
    CHECK(desk.surface().settings.field.elements[0].kind == "node");
    desk.settle();
    REQUIRE(desk.surface().field);
    const auto first = desk.surface().field;
    desk.desk.act(SurfaceAction{PressSurface{{100, 50}, 5}});
    desk.desk.act(SurfaceAction{DragSurface{{120, 50}}});
    desk.desk.act(SurfaceAction{DragSurface{{3, 3}}});  // beside the surface: it stays at the rim
    desk.desk.act(SurfaceAction{ReleaseSurface{}});
    CHECK(desk.surface().settings.field.elements.size() == 1);
    CHECK(desk.surface().settings.field.elements[0].at.x > 0.2);
    desk.settle();
    CHECK(desk.surface().field != first);
    const SpacePoint at = desk.surface().settings.field.elements[0].at;
    desk.desk.act(SurfaceAction{RemoveMark{seen_at(desk.surface().view, at).at, 5}});
    CHECK(desk.surface().settings.field.elements.empty());
    CHECK_FALSE(desk.surface().field);
}

TEST_CASE("growth without a surface or without rules says what is missing") {
    EditorDesk empty;
    empty.act(SurfaceAction{GrowSurface{}});
    CHECK(empty.state().messages.back().text.find("open a mesh") != std::string::npos);
    SurfaceDesk desk;
    desk.desk.act(SurfaceAction{GrowSurface{}});
    CHECK(desk.desk.state().messages.back().text.find("open a drawing") != std::string::npos);
    CHECK_FALSE(desk.surface().growing);
}

TEST_CASE("a shape grammar grows rule by rule, at the seeds that were put") {
    SurfaceDesk desk;
    write_output(desk.folder / "row.fgsg",
                 "shape b = box\naxiom vertex 0 Row(4)\nRow(n) : n > 0 ~ [S(0.1) I(\"b\")] T(0.1,0,0) Row(n-1)\n");
    desk.set([&](SurfaceSettings& settings) {
        settings.grammar = desk.folder / "row.fgsg";
        settings.tool = SurfaceTool::seed;
    });
    desk.click({100, 50});
    REQUIRE(desk.surface().settings.seeds.size() == 1);
    desk.desk.act(SurfaceAction{StepSurface{2}});
    desk.settle();
    REQUIRE(desk.surface().grown);
    CHECK(desk.surface().grown->steps == 2);
    const std::size_t two = desk.surface().grown->assembly->instances.size();
    desk.desk.act(SurfaceAction{GrowSurface{}});
    desk.settle();
    CHECK(desk.surface().grown->assembly->instances.size() > two);
    const SpacePoint first = desk.surface().grown->assembly->instances.front().pose.translation;
    CHECK(abs(first) < 0.3);  // at the seed in the middle, not at the corner that is vertex 0
    desk.desk.act(SurfaceAction{ExportSurface{desk.folder / "row.obj"}});
    desk.settle();
    CHECK(read_input(desk.folder / "row.obj").find("\nf ") != std::string::npos);
    desk.desk.act(SurfaceAction{ExportSurface{desk.folder / "row.txt"}});
    desk.settle();
    CHECK(desk.desk.state().messages.back().kind == MessageKind::mistake);
}

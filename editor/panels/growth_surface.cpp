// Surfaces: which mesh, which field, what grows on it.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "editor/model/surface_stage.h"
#include "editor/model/surface_view.h"
#include "editor/panels/growth_parts.h"

namespace rinceau {
namespace {

constexpr std::array<const char*, 6> element_kinds{"regular", "wedge", "trisector", "node", "centre", "saddle"};

void mesh_rows(GrowthForm& form) {
    const SurfaceState& surface = form.state().surface;
    if (form.file("mesh", form.surface.mesh, "Open",
                  "A mesh of triangles: .obj, .off or .ply. It can be dropped on the canvas, too"))
        form.actions.push_back(SurfaceAction{OpenMesh{form.surface.mesh}});
    if (surface.stage) {
        ImGui::TextDisabled("%s", surface.stage->told.c_str());
        note_place(form.tools(), "growth/mesh facts");
    } else if (!surface.mistake.empty()) {
        ImGui::TextWrapped("%s", surface.mistake.c_str());
    }
    form.text("grammar", form.surface.grammar,
              "File of a shape grammar (.fgsg) that grows on the mesh; nothing: the document's rules");
}

void show_row(GrowthForm& form) {
    SurfaceSettings& settings = form.surface;
    form.check("surface", settings.ground, "The mesh itself");
    ImGui::SameLine();
    form.check("triangles", settings.wireframe, "Its edges");
    ImGui::SameLine();
    form.check("streamlines", settings.streamlines, "Lines along the field");
}

void tool_row(GrowthForm& form) {
    int tool = static_cast<int>(form.surface.tool);
    form.choice(
        "left button", tool, {"turns", "puts field elements", "puts seeds"},
        "On the canvas. The right one moves the surface, and a right click removes a mark; the wheel turns a mark that it "
        "is over, else it zooms.");
    form.surface.tool = static_cast<SurfaceTool>(tool);
    if (form.surface.tool != SurfaceTool::element) return;
    const auto found = std::ranges::find(element_kinds, form.surface.element);
    int kind = found == element_kinds.end() ? 0 : static_cast<int>(found - element_kinds.begin());
    form.choice("element", kind, {element_kinds.begin(), element_kinds.end()}, "What the next click puts there");
    form.surface.element = element_kinds[static_cast<std::size_t>(kind)];
}

void marks_row(GrowthForm& form, const char* what, std::size_t count, SurfaceTool of) {
    ImGui::TextDisabled("%zu %s", count, what);
    ImGui::SameLine();
    ImGui::BeginDisabled(count == 0);
    const std::string label = std::string("Clear##") + what;
    if (ImGui::SmallButton(label.c_str())) form.actions.push_back(SurfaceAction{ClearMarks{of}});
    ImGui::EndDisabled();
    note_place(form.tools(), std::string("growth/clear ") + what);
}

void field_rows(GrowthForm& form) {
    FieldSettings& field = form.surface.field;
    int source = static_cast<int>(field.source);
    form.choice("field", source, {"none", "from elements", "of curvature", "smoothest"},
                "What guides growth over the surface");
    field.source = static_cast<FieldSettings::Source>(source);
    if (field.source == FieldSettings::Source::none) return;
    if (field.source != FieldSettings::Source::curvature) {
        int symmetry = static_cast<int>(field.symmetry);
        form.choice("kind", symmetry, {"directions", "lines", "crosses"},
                    "Directions have a front; lines are the same after half a turn, crosses after a quarter.");
        field.symmetry = static_cast<FieldSymmetry>(symmetry);
    }
    constexpr float step = 0.002F;
    constexpr double most_smooth = 1;
    form.number("smooth", field.smooth, 0, most_smooth, step, "%.3f", "How far the field is evened out, of the diagonal.");
    if (field.source == FieldSettings::Source::elements) {
        constexpr double most_decay = 50;
        form.number("decay", field.decay, 0.1, most_decay, 10 * step, "%.1f", "How soon an element's pull fades.");
        marks_row(form, "elements", field.elements.size(), SurfaceTool::element);
    }
    if (form.state().surface.field) ImGui::TextWrapped("%s", form.state().surface.field->told.c_str());
    note_place(form.tools(), "growth/field facts");
}

void drawing_rows(GrowthForm& form) {
    SurfaceSettings& settings = form.surface;
    constexpr float step = 0.005F;
    constexpr double most_size = 20;
    form.number("size", settings.size, 0.01, most_size, step, "%.2f x", "The drawing's diagonal beside the surface's.");
    form.number("heading", settings.heading, -180, 180, 1, "%.0f deg", "By which the drawing is turned.");
    form.number("follow", settings.follow, 0, 1, step, "%.2f", "How far the drawing bends with the field.");
    constexpr double highest = 0.2;
    constexpr float height_step = 0.0002F;
    form.number("height", settings.height, 0, highest, height_step, "%.4f",
                "Of what is laid, of the surface's diagonal; 0 = flat.");
    form.check("may overlap", settings.merge, "What meets itself on the surface stays.");
}

void grow_rows(GrowthForm& form) {
    form.command("surface.grow");
    ImGui::SameLine();
    form.command("surface.clear");
    if (!form.surface.grammar.empty()) {
        form.command("surface.step");
        ImGui::SameLine();
        form.command("surface.steps");
    } else {
        drawing_rows(form);
    }
    marks_row(form, "seeds", form.surface.seeds.size(), SurfaceTool::seed);
    form.seed(form.surface.seed);
}

void progress_rows(GrowthForm& form) {
    const SurfaceState& surface = form.state().surface;
    ImGui::BeginDisabled(!surface.growing);
    if (ImGui::Button("Stop")) form.actions.push_back(SurfaceAction{StopSurface{}});
    ImGui::EndDisabled();
    note_place(form.tools(), "growth/Stop");
    ImGui::SameLine();
    const char* words = surface.stopping    ? "stopping"
                        : surface.growing   ? "growing"
                        : surface.designing ? "designing the field"
                        : surface.grown     ? surface.grown->told.c_str()
                                            : "";
    ImGui::ProgressBar(surface.growing ? static_cast<float>(surface.fraction) : 0, {-1, 0}, words);
    note_place(form.tools(), "growth/Progress");
}

void export_row(GrowthForm& form) {
    ImGui::BeginDisabled(!form.state().surface.stage || form.state().surface.writing);
    if (form.file("write to", form.surface.output, "Write", "A file that ends in .glb, .obj, .ply or .png"))
        form.actions.push_back(SurfaceAction{ExportSurface{form.surface.output}});
    ImGui::EndDisabled();
}

}  // namespace

void growth_surface(GrowthForm& form) {
    constexpr float room_for_labels = 8;  // widths of a letter
    progress_rows(form);
    ImGui::Separator();
    ImGui::PushItemWidth(-room_for_labels * ImGui::GetFontSize());
    mesh_rows(form);
    show_row(form);
    tool_row(form);
    ImGui::Separator();
    field_rows(form);
    ImGui::Separator();
    grow_rows(form);
    ImGui::Separator();
    export_row(form);
    ImGui::PopItemWidth();
}

}  // namespace rinceau

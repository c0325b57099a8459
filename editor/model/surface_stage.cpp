#include "editor/model/surface_stage.h"

#include <algorithm>

#include "geometry/angle.h"
#include "growth/surface/curvature_field.h"
#include "growth/surface/field_elements.h"
#include "growth/surface/field_smooth.h"
#include "growth/surface/streamlines.h"
#include "growth/surface/surface_read.h"

namespace rinceau {
namespace {

std::string counted(long count, const std::string& one, const std::string& many) {
    std::string digits = std::to_string(count);
    for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), ",");
    return digits + ' ' + (count == 1 ? one : many);
}

std::string shape_in_words(const SurfaceMesh& surface) {
    if (surface.border_edges > 0) return counted(surface.border_edges, "edge", "edges") + " of its border are open";
    return "closed, Euler characteristic " + std::to_string(euler_characteristic(surface));
}

int symmetry_of(FieldSymmetry symmetry) {
    return symmetry == FieldSymmetry::vectors ? 1 : symmetry == FieldSymmetry::lines ? 2 : 4;
}

FieldElement element_of(const SurfaceMesh& surface, const SurfaceMark& mark, const FieldSettings& settings) {
    FieldElement element{.kind = field_element_kind(mark.kind).value_or(FieldElementKind::regular), .decay = settings.decay};
    element.vertex = nearest_vertex(surface, mark.at);
    element.direction = reference_direction(surface, element.vertex) + radians(mark.angle);
    return element;
}

SurfaceField designed_field(const SurfaceMesh& surface, const FieldSettings& settings, const Progress& progress) {
    const int n = symmetry_of(settings.symmetry);
    switch (settings.source) {
        case FieldSettings::Source::curvature:
            return guiding_curvature_field(surface);
        case FieldSettings::Source::elements: {
            std::vector<FieldElement> elements;
            for (const SurfaceMark& mark : settings.elements) elements.push_back(element_of(surface, mark, settings));
            return field_of_elements(surface, n, elements, "The field", progress);
        }
        case FieldSettings::Source::smoothest:
        case FieldSettings::Source::none:
            break;
    }
    return smoothest_field(surface, n, progress);
}

std::vector<std::vector<SpacePoint>> lines_along(const FieldOnSurface& field, double spacing, const Progress& progress) {
    const SurfaceMesh& surface = field.surface();
    std::vector<std::vector<SpacePoint>> lines;
    for (const Streamline& line : streamlines(field, {.spacing = spacing * surface.diagonal}, progress).lines) {
        std::vector<SpacePoint>& points = lines.emplace_back();
        for (const SurfacePoint p : line.path) points.push_back(position_in_space(surface, p));
    }
    return lines;
}

std::string field_in_words(const FieldOnSurface& field) {
    const std::size_t count = field.singular_faces().size();
    std::string text = counted(static_cast<long>(count), "singular point", "singular points");
    const SurfaceMesh& surface = field.surface();
    const auto parts = [&](long nth) {
        return nth % field.n() == 0 ? std::to_string(nth / field.n())
                                    : std::to_string(nth) + '/' + std::to_string(field.n());
    };
    text += ", index sum " + parts(field.index_sum());
    if (surface.border_edges == 0) text += ", Euler characteristic " + std::to_string(euler_characteristic(surface));
    return text;
}

}  // namespace

SurfaceStage surface_stage(const std::string& path, const std::string& text) {
    constexpr Color clay{214, 208, 196};
    SurfaceReading reading = read_surface(text, path);
    SurfaceStage stage{.path = path};
    for (const Warning& warning : reading.warnings) stage.warnings.push_back(located(warning.place, warning.message));
    MeshAssembly ground;
    ground.meshes.push_back({"surface", reading.surface.mesh, clay});
    ground.instances.push_back({0, {}});
    stage.ground = std::make_shared<const MeshAssembly>(std::move(ground));
    stage.told = counted(reading.surface.faces(), "face", "faces") + ", " + shape_in_words(reading.surface);
    stage.surface = std::make_shared<const SurfaceMesh>(std::move(reading.surface));
    return stage;
}

StageField stage_field(const SurfaceStage& stage, const FieldSettings& settings, double spacing, const Progress& progress) {
    SurfaceField field = designed_field(*stage.surface, settings, progress);
    if (settings.smooth > 0 && settings.source != FieldSettings::Source::smoothest)
        field = smoothed(*stage.surface, std::move(field), settings.smooth, progress);
    StageField made{.surface = stage.surface};
    made.field = std::make_shared<const FieldOnSurface>(*stage.surface, std::move(field));
    for (const int face : made.field->singular_faces())
        made.singular.push_back(
            {position_in_space(*stage.surface, {face, made.field->zero(face)}), made.field->index(face)});
    made.streamlines =
        std::make_shared<const std::vector<std::vector<SpacePoint>>>(lines_along(*made.field, spacing, progress));
    made.told = field_in_words(*made.field);
    return made;
}

}  // namespace rinceau

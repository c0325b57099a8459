#include "growth/surface/field_source.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "growth/surface/curvature_field.h"
#include "growth/surface/field_elements.h"
#include "growth/surface/field_filled.h"
#include "growth/surface/field_json.h"
#include "growth/surface/field_smooth.h"
#include "growth/picture_png_read.h"
#include "growth/surface/vertex_axes.h"
#include "lsystem/similar_name.h"

namespace rinceau {
namespace {

/// What one kind of source is made from.
struct Sources {
    const FieldSource& source;
    const SurfaceMesh& surface;
    const ReadNamedFile& read;
    const Progress& progress;

    [[noreturn]] void fail(const std::string& message) const { throw InputError(source.place, message); }
    double number(const std::string& name, double otherwise) const {
        const auto found = source.numbers.find(name);
        if (found == source.numbers.end()) return otherwise;
        if (!std::isfinite(found->second)) fail("the field's " + name + " is not a finite number");
        return found->second;
    }
    int whole(const std::string& name, int otherwise, int highest) const {
        const double value = number(name, otherwise);
        if (value < 0 || value > highest || value != std::floor(value))
            fail("the field's " + name + " is no whole number from 0 to " + std::to_string(highest));
        return static_cast<int>(value);
    }
    int n(int otherwise) const {
        const int n = whole("n", otherwise, 4);
        if (n != 1 && n != 2 && n != 4) fail("the field's n is " + std::to_string(n) + "; expected 1, 2 or 4");
        return n;
    }
    std::string file() const { return read_named(read, source.text, source.place); }
    std::string label() const { return source.text.empty() ? source.place.file : source.text; }
};

SurfaceField elements_source(const Sources& from) {
    const FieldDesign design = read_field_design_json(from.file(), from.surface, from.label());
    SurfaceField field = field_of_elements(from.surface, design.n, design.elements, from.label(), from.progress);
    field = smoothed(from.surface, std::move(field), design.smooth, from.progress);
    return smoothed_by_rounds(from.surface, std::move(field), design.rounds, {}, from.progress);
}

SurfaceField file_source(const Sources& from) { return read_field_json(from.file(), from.surface, from.label()); }

SurfaceField curvature_source(const Sources& from) {
    const bool blended = from.number("smooth", 0) > 0 || from.number("rounds", 0) > 0;
    return blended ? guiding_curvature_field(from.surface) : curvature_field(from.surface);
}

/// A vector of the plane laid into the surface at a vertex, so that it has its way when seen from +z; where the surface is
/// too steep for that, its tangent part.
Complex laid_at(const SurfaceMesh& surface, int v, Complex vector) {
    constexpr double steep = 0.1;
    const SpacePoint normal = surface.vertex_normal[static_cast<std::size_t>(v)];
    const bool seen = std::abs(normal.z) > steep;
    const double rise = seen ? -(normal.x * vector.x + normal.y * vector.y) / normal.z : 0;
    return from_space_to_vertex(surface, vertex_axis(surface, v), v, {vector.x, vector.y, rise});
}

SurfaceField image_source(const Sources& from) {
    const PictureEdges edges{from.number("blur", PictureEdges{}.blur), from.number("sigma", PictureEdges{}.sigma)};
    Picture pixels = read_picture_png(from.file(), from.label());
    const auto [low, high] = bounds(from.surface.mesh);
    PlanePicture picture = plane_picture(std::move(pixels), {{low.x, low.y}, {high.x, high.y}}, edges, from.label());
    if (from.number("across", 0) != 0)
        for (Complex& z : picture.along) z = -z;
    SurfaceField field{.n = 2, .along_picture = is_plane(from.surface), .label = from.label()};
    if (!field.along_picture)
        for (int v = 0; v < from.surface.vertices(); ++v) {
            const SpacePoint p = from.surface.mesh.positions[static_cast<std::size_t>(v)];
            const Complex z = edges_along(picture, {p.x, p.y}), laid = laid_at(from.surface, v, polar(1, arg(z) / 2));
            field.values.push_back(abs(laid) > 0 ? abs(z) * power(laid / abs(laid), 2) : Complex{});
        }
    field.picture = std::make_shared<const PlanePicture>(std::move(picture));
    return field;
}

SurfaceField constant_source(const Sources& from) {
    return {.n = from.n(1), .exact = PlaneForm{.angle = radians(from.number("angle", 0))}, .label = from.label()};
}

SurfaceField about_source(const Sources& from) {
    constexpr double default_spiral = 45;
    double angle = 0;
    if (from.source.kind == "vortex") angle = pi / 2;
    if (from.source.kind == "spiral") angle = radians(from.number("angle", default_spiral));
    return {
        .n = from.n(1), .exact = PlaneForm{true, {from.number("x", 0), from.number("y", 0)}, angle}, .label = from.label()};
}

SurfaceField direction_source(const Sources& from) {
    const SpacePoint wanted{from.number("x", 0), from.number("y", 0), from.number("z", 0)};
    const double length = abs(wanted);
    if (!(length > 0)) from.fail("expected a direction in space: x, y and z that are not all 0");
    SurfaceField field{.n = from.n(1), .label = from.label()};
    for (int v = 0; v < from.surface.vertices(); ++v) {
        const SpacePoint unit_length = 1 / length * wanted;
        const Complex laid = from_space_to_vertex(from.surface, vertex_axis(from.surface, v), v, unit_length);
        field.values.push_back(abs(laid) > 0 ? abs(laid) * power(laid / abs(laid), field.n) : Complex{});
    }
    return field;
}

SurfaceField smoothest_source(const Sources& from) { return smoothest_field(from.surface, from.n(2), from.progress); }

struct SourceKind {
    std::string name;
    std::vector<std::string> numbers;  ///< besides smooth and rounds
    SurfaceField (*make)(const Sources&);
    bool of_file = false;
};

const std::vector<SourceKind>& source_kinds() {
    static const std::vector<SourceKind> kinds{{"elements", {}, elements_source, true},
                                               {"file", {}, file_source, true},
                                               {"curvature", {}, curvature_source},
                                               {"image", {"blur", "sigma", "across"}, image_source, true},
                                               {"constant", {"angle", "n"}, constant_source},
                                               {"radial", {"x", "y", "n"}, about_source},
                                               {"vortex", {"x", "y", "n"}, about_source},
                                               {"spiral", {"x", "y", "angle", "n"}, about_source},
                                               {"direction", {"x", "y", "z", "n"}, direction_source},
                                               {"smoothest", {"n"}, smoothest_source}};
    return kinds;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text.append(text.empty() ? "" : ", ").append(name);
    return text;
}

void check_names(const FieldSource& source, const SourceKind& kind) {
    std::vector<std::string> known = kind.numbers;
    known.insert(known.end(), {"smooth", "rounds"});
    const auto expect_known = [&](const std::string& name) {
        if (std::ranges::find(known, name) == known.end())
            throw InputError(source.place,
                             "a field of the kind " + kind.name + " has no " + name + "; expected one of " + listed(known));
    };
    for (const auto& [name, value] : source.numbers) expect_known(name);
    for (const auto& [name, word] : source.words) {
        expect_known(name);
        throw InputError(source.place, "the field's " + name + " is \"" + word + "\"; expected a number");
    }
}

const SourceKind& checked_kind(const FieldSource& source) {
    const auto kind = std::ranges::find(source_kinds(), source.kind, &SourceKind::name);
    if (kind == source_kinds().end())
        throw InputError(source.place, "expected the kind of a field, found '" + source.kind + "'" +
                                           instead_of(source.kind, field_source_kinds()));
    check_names(source, *kind);
    if (kind->of_file && source.text.empty())
        throw InputError(source.place, "expected the name of a file in quotation marks after \"" + source.kind + "\"");
    if (!kind->of_file && !source.text.empty())
        throw InputError(source.place,
                         "expected no file for a field of the kind " + source.kind + ", found \"" + source.text + "\"");
    return *kind;
}

}  // namespace

const std::vector<std::string>& field_source_kinds() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const SourceKind& kind : source_kinds()) all.push_back(kind.name);
        return all;
    }();
    return names;
}

void check_field_source(const FieldSource& source) { checked_kind(source); }

SurfaceField make_field(const FieldSource& source, const SurfaceMesh& surface, const ReadNamedFile& read,
                        const Progress& progress) {
    const SourceKind& kind = checked_kind(source);
    const Sources from{source, surface, read, progress};
    SurfaceField field = kind.make(from);
    const double radius = from.number("smooth", 0);
    if (!(radius >= 0)) from.fail("the field's smooth is below 0; expected diagonals of the surface");
    field = smoothed(surface, std::move(field), radius, progress);
    field = smoothed_by_rounds(surface, std::move(field), from.whole("rounds", 0, most_smoothing_rounds), {}, progress);
    if (field.label.empty()) field.label = source.kind;
    return field;
}

}  // namespace rinceau

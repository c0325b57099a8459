// The solids are made for a scope of size 1 and coarse: a pattern has thousands of them. The torus of 576 faces makes 8,913
// instances the 5.1 million faces of Li et al. 2010, figure 17.

#include "growth/surface/shape_sources.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/angle.h"
#include "geometry/convex_hull.h"
#include "growth/mesh/mesh_read.h"
#include "growth/mesh/mesh_silhouette.h"
#include "growth/mesh/solids.h"
#include "growth/surface/shape_outlines.h"
#include "growth/surface/shape_settings.h"
#include "scene/svg_color.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

/// A shape on its way: the mesh fills the scope; the outline is made from it if it stays empty.
struct Draft {
    TriangleMesh mesh;
    Region outline;
    double rim = 0;
    std::optional<Color> color;
};

/// What a kind is made of: the text of its file, and a fineness instead of the setting that faces = n chooses.
struct DraftInput {
    const ShapeSource& source;
    const SettingValues& values;
    const std::string& file_text;
};

struct ShapeKind {
    std::string_view name;
    CollideAs collide = CollideAs::box;
    bool has_file = false;
    std::vector<NumberSetting> numbers;
    std::vector<WordSetting> words;
    Draft (*draft)(const DraftInput& input) = nullptr;
};

constexpr double most_corners = 1000;
constexpr double round_radius = 0.5;  // of all shapes that collide as discs

NumberSetting detail(double value, double low = 3) { return {"detail", value, low, most_corners, true}; }
NumberSetting height_setting() { return {"height", 1, 1e-6, 1e6}; }

Draft prism_of(Region outline, double height) {
    Draft draft;
    draft.mesh = extruded(outline, 0, height);
    draft.outline = std::move(outline);
    return draft;
}

Draft box_draft(const DraftInput&) { return prism_of({tile_outline(0, 0)}, 1); }

Draft tile_draft(const DraftInput& in) {
    const double round = in.values.number("round"), bevel = in.values.number("bevel");
    const std::vector<Point> outline = tile_outline(round, in.values.whole("detail"));
    if (bevel <= 0) return prism_of({outline}, 1);
    return {.mesh = bevelled_prism(outline, 1, bevel), .outline = {outline}};
}

/// A turned solid about z, from -0.5 to 0.5, laid along x.
Draft cylinder_draft(const DraftInput& in) {
    Draft draft;
    draft.mesh = turned_solid({{0, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {0, 0.5}}, in.values.whole("detail"));
    for (SpacePoint& p : draft.mesh.positions) p = {p.z, p.x, p.y};
    return draft;
}

Draft sphere_draft(const DraftInput& in) {
    const int around = in.values.whole("detail"), rows = std::max(2, around / 2);
    std::vector<Point> profile;
    for (int i = 0; i <= rows; ++i) profile.push_back(polar(0.5, pi * i / rows - 0.5 * pi));
    return {.mesh = turned_solid(profile, around), .rim = 1};
}

Draft torus_draft(const DraftInput& in) {
    const double tube = in.values.number("tube");
    const int around = in.values.whole("detail"), about_tube = std::max(3, around / 2);
    std::vector<Point> profile;
    for (int i = 0; i < about_tube; ++i) profile.push_back(Point{0.5 - tube, 0} + polar(tube, two_pi * i / about_tube));
    return {.mesh = turned_ring(profile, around), .rim = 2 * tube};
}

Draft disc_draft(const DraftInput& in) {
    return prism_of({round_outline(in.values.whole("detail"))}, in.values.number("height"));
}

Draft cone_draft(const DraftInput& in) {
    return {.mesh = turned_solid({{0, 0}, {0.5, 0}, {0, 1}}, in.values.whole("detail"))};
}

Draft pyramid_draft(const DraftInput&) {
    Draft draft;
    draft.mesh.positions = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}, {0, 0, 1}};
    draft.mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    return draft;
}

Draft prism_draft(const DraftInput& in) {
    return prism_of({round_outline(in.values.whole("sides"))}, in.values.number("height"));
}

Draft star_draft(const DraftInput& in) {
    return prism_of({star_outline(in.values.whole("points"), in.values.number("inner"))}, in.values.number("height"));
}

Draft leaf_draft(const DraftInput& in) {
    return prism_of({leaf_outline(in.values.whole("detail"))}, in.values.number("height"));
}

Draft arrow_draft(const DraftInput& in) {
    return prism_of({arrow_outline(in.values.number("shaft"), in.values.number("head"))}, in.values.number("height"));
}

Draft glyph_draft(const DraftInput& in) {
    const SettingValues& v = in.values;
    return prism_of(glyph_outline(v.whole("detail"), v.whole("lines"), v.number("gap")), v.number("height"));
}

std::optional<Color> fill_color(const Style& style) {
    if (const auto* color = std::get_if<Color>(&style.fill)) return *color;
    if (const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&style.fill))
        return (*gradient)->stops.front().color;
    if (const auto* color = std::get_if<Color>(&style.stroke.paint)) return *color;
    return std::nullopt;
}

/// All that the drawing paints, as one region; the colour of what covers most.
Draft outline_draft(const DraftInput& in) {
    const Scene scene = read_svg(in.file_text, {.file_name = in.source.text}).scene;
    const SourcePlace file{in.source.text};
    Box ink;
    for (const Element& element : scene.elements)
        if (element.verbatim.empty()) ink = including(ink, painted_box(element));
    if (!(width(ink) > 0 && height(ink) > 0))
        throw InputError(file, "expected paths that are filled or drawn, found none: text and pictures make no shape");
    const bool page = in.values.words.find("fit")->second == "page" && scene.sized && !is_empty(scene.viewport);
    const Box fit = page ? scene.viewport : ink;
    Draft draft;
    double largest = 0;
    Region all;
    for (const Element& element : scene.elements) {
        if (!element.verbatim.empty()) continue;
        const Region region = painted_region(element, in.values.number("deviation") * std::min(width(fit), height(fit)));
        const double covered = area(region);
        if (const std::optional<Color> color = fill_color(element.style); color && covered > largest) {
            largest = covered;
            draft.color = color;
        }
        all = union_of(all, region);
    }
    for (auto& ring : all)
        for (Point& p : ring) p = {(p.x - center(fit).x) / width(fit), (p.y - center(fit).y) / height(fit)};
    draft.mesh = extruded(all, 0, in.values.number("height"));
    if (draft.mesh.triangles.empty()) throw InputError(file, "expected a drawing that covers an area, found none");
    draft.outline = std::move(all);
    return draft;
}

/// The whole in the middle of the scope, as large as fits, standing on z = 0.
Draft mesh_draft(const DraftInput& in) {
    Draft draft;
    draft.mesh = read_mesh(in.source.text, in.file_text, {.file_name = in.source.text});
    if (in.values.words.find("up")->second == "y")
        for (SpacePoint& p : draft.mesh.positions) p = {p.x, -p.z, p.y};
    const auto [low, high] = bounds(draft.mesh);
    const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (!(extent > 0)) throw InputError({in.source.text}, "expected a mesh with an extent, found all corners in one place");
    const SpacePoint middle{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), low.z};
    for (SpacePoint& p : draft.mesh.positions) p = (1 / extent) * (p - middle);
    return draft;
}

const std::vector<ShapeKind>& shape_kinds() {
    const std::vector<WordSetting> fit{{"fit", {"page", "ink"}}}, up{{"up", {"z", "y"}}};
    static const std::vector<ShapeKind> kinds{
        {"box", CollideAs::box, false, {}, {}, box_draft},
        {"tile", CollideAs::box, false, {{"round", 0.12, 0, 0.45}, {"bevel", 0.08, 0, 0.4}, detail(3, 1)}, {}, tile_draft},
        {"cylinder", CollideAs::box, false, {detail(12)}, {}, cylinder_draft},
        {"sphere", CollideAs::disc, false, {detail(16)}, {}, sphere_draft},
        {"ellipsoid", CollideAs::disc, false, {detail(16)}, {}, sphere_draft},
        {"torus", CollideAs::disc, false, {{"tube", 0.14, 0.01, 0.24}, detail(24)}, {}, torus_draft},
        {"disc", CollideAs::disc, false, {height_setting(), detail(24)}, {}, disc_draft},
        {"ellipse", CollideAs::disc, false, {height_setting(), detail(24)}, {}, disc_draft},
        {"cone", CollideAs::disc, false, {detail(16)}, {}, cone_draft},
        {"pyramid", CollideAs::box, false, {}, {}, pyramid_draft},
        {"prism", CollideAs::hull, false, {{"sides", 6, 3, most_corners, true}, height_setting()}, {}, prism_draft},
        {"star",
         CollideAs::hull,
         false,
         {{"points", 5, 3, most_corners, true}, {"inner", 0.45, 0.05, 1}, height_setting()},
         {},
         star_draft},
        {"leaf", CollideAs::hull, false, {height_setting(), detail(8)}, {}, leaf_draft},
        {"arrow",
         CollideAs::hull,
         false,
         {{"shaft", 0.4, 0.01, 0.99}, {"head", 0.45, 0.01, 0.99}, height_setting()},
         {},
         arrow_draft},
        {"glyph",
         CollideAs::disc,
         false,
         {{"lines", 1, 0, 2, true}, {"gap", 0.1, 0.001, 0.9}, height_setting(), detail(48)},
         {},
         glyph_draft},
        {"outline", CollideAs::hull, true, {height_setting(), {"deviation", 0.004, 1e-6, 0.2}}, fit, outline_draft},
        {"mesh", CollideAs::box, true, {}, up, mesh_draft}};
    return kinds;
}

const ShapeKind& kind_of(const ShapeSource& source) {
    const std::vector<ShapeKind>& kinds = shape_kinds();
    const auto kind = std::ranges::find(kinds, source.kind, &ShapeKind::name);
    if (kind != kinds.end()) return *kind;
    std::vector<std::string_view> names;
    for (const ShapeKind& known : kinds) names.push_back(known.name);
    throw InputError(source.place, "the shape '" + source.name + "': expected a kind among " + listed(names) + ", found '" +
                                       source.kind + "'");
}

constexpr std::array<std::string_view, 4> collide_names{"box", "disc", "hull", "outline"};

SettingValues checked_settings(const ShapeKind& kind, const ShapeSource& source, const NumberOfSetting& number_of) {
    std::map<std::string, double> said;
    for (const auto& [name, expression] : source.numbers) said.emplace(name, number_of(expression));
    std::vector<NumberSetting> numbers = kind.numbers;
    std::vector<WordSetting> words = kind.words;
    const bool fine =
        std::ranges::any_of(numbers, [](const NumberSetting& n) { return n.name == "detail" || n.name == "deviation"; });
    constexpr double most_faces = 1e6;
    if (fine) numbers.push_back({"faces", 0, 1, most_faces, true});
    std::vector<std::string_view> collide{collide_names.begin(), collide_names.end()};
    std::swap(collide.front(), collide[static_cast<std::size_t>(kind.collide)]);  // the default comes first
    words.push_back({"collide", collide});
    words.push_back({"colour", {}});
    return setting_values(source, said, numbers, words);
}

std::string text_of_file(const ShapeKind& kind, const ShapeSource& source, const ReadNamedFile& read_file) {
    if (kind.has_file && source.text.empty())
        throw InputError(source.place,
                         "the shape '" + source.name + "': expected a file name in quotation marks behind " + source.kind);
    if (!kind.has_file && !source.text.empty())
        throw InputError(source.place, "the shape '" + source.name + "': expected settings behind " + source.kind +
                                           ", found \"" + source.text + "\"");
    return kind.has_file ? read_named(read_file, source.text, source.place) : std::string();
}

/// The draft whose number of faces is nearest to faces = n, by halving the range of the setting that makes it finer.
Draft draft_of(const ShapeKind& kind, const ShapeSource& source, SettingValues values, const std::string& text) {
    const auto wanted = values.numbers.find("faces");
    if (wanted == values.numbers.end() || wanted->second <= 0) return kind.draft({source, values, text});
    const double faces = wanted->second;
    const NumberSetting setting = *std::ranges::find_if(
        kind.numbers, [](const NumberSetting& n) { return n.name == "detail" || n.name == "deviation"; });
    // On a scale of the logarithm; a smaller deviation is finer.
    double coarse = std::log(setting.whole ? setting.low : setting.high),
           fine = std::log(setting.whole ? setting.high : setting.low);
    Draft best;
    double miss = std::numeric_limits<double>::infinity();
    constexpr int halvings = 14;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (coarse + fine);
        values.numbers.find(setting.name)->second = setting.whole ? std::round(std::exp(middle)) : std::exp(middle);
        Draft draft = kind.draft({source, values, text});
        const double count = static_cast<double>(draft.mesh.triangles.size());
        (count < faces ? coarse : fine) = middle;
        if (std::abs(count - faces) >= miss) continue;
        miss = std::abs(count - faces);
        best = std::move(draft);
    }
    return best;
}

Color color_of(const ShapeSource& source, const SettingValues& values, const Draft& draft) {
    const auto said = values.words.find("colour");
    if (said == values.words.end()) return draft.color.value_or(GrammarShape{}.color);
    const std::optional<ParsedColor> color = parse_color(said->second);
    if (!color || color->current)
        throw InputError(source.place, "the shape '" + source.name + "': expected a colour such as \"#d9a441\", found '" +
                                           said->second + "'");
    return color->color;
}

std::vector<Point> hull_of(const Region& outline) {
    std::vector<Point> corners;
    for (const auto& ring : outline) corners.insert(corners.end(), ring.begin(), ring.end());
    return convex_hull(corners);
}

}  // namespace

GrammarShape make_shape(const ShapeSource& source, const ReadNamedFile& read_file, const NumberOfSetting& number_of) {
    const ShapeKind& kind = kind_of(source);
    const SettingValues values = checked_settings(kind, source, number_of);
    Draft draft = draft_of(kind, source, values, text_of_file(kind, source, read_file));
    GrammarShape shape;
    shape.name = source.name;
    shape.color = color_of(source, values, draft);
    shape.rim = draft.rim;
    shape.outline = draft.outline.empty() ? silhouette(draft.mesh, UpAxis::z, source.name) : std::move(draft.outline);
    shape.hull = hull_of(shape.outline);
    shape.mesh = std::move(draft.mesh);
    const auto [low, high] = bounds(shape.mesh);
    shape.low = low;
    shape.high = high;
    if (kind.collide == CollideAs::disc) {
        // the corners of a coarse round shape, or of one that is cut, need not reach as far as its circle
        shape.low.x = shape.low.y = -round_radius;
        shape.high.x = shape.high.y = round_radius;
    }
    const auto collide = std::ranges::find(collide_names, values.words.find("collide")->second);
    shape.collide = static_cast<CollideAs>(collide - collide_names.begin());
    return shape;
}

}  // namespace rinceau

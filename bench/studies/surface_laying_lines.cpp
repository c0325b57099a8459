// Outlines laid on surfaces: how many a second, and how many lie only when shrunk, or not at all (bars: docs/growth.md).

#include <cmath>
#include <functional>
#include <map>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "growth/surface/laid_overlaps.h"
#include "growth/surface/lay_script.h"
#include "surface_bench.h"
#include "surface_cases.h"

namespace rinceau::test {
namespace {

constexpr int places = 300;

/// A disc of radius 1 of 24 triangles.
TerminalArt disc_art() {
    constexpr int sides = 24;
    ArtLayer layer;
    layer.points.push_back({0, 0});
    for (int i = 0; i < sides; ++i) layer.points.push_back(polar(1, two_pi * i / sides));
    for (int i = 0; i < sides; ++i) layer.triangles.push_back({0, i + 1, (i + 1) % sides + 1});
    layer.area = sides * std::sin(two_pi / sides) / 2;
    TerminalArt art;
    art.box = {{-1, -1}, {1, 1}};
    art.hull.assign(layer.points.begin() + 1, layer.points.end());
    art.layers.push_back(std::move(layer));
    return art;
}

/// A drawing of one disc, laid as the command lays drawings.
class DiscLayer {
  public:
    explicit DiscLayer(const SurfaceMesh& surface) : surface_(&surface) {
        script_.deeds.push_back({TurtleEventKind::placed, {0, 0}, 0, -1});
        script_.elements.push_back({});
        elements_.push_back(drawn_element(art_, {}));
    }

    LaidScript lay(SurfacePoint at, double radius) const {
        DrawingStand stand;
        stand.at = at;
        return lay_script(*surface_, script_, elements_, {nullptr, 0, radius}, stand, {});
    }

  private:
    const SurfaceMesh* surface_;
    TerminalArt art_ = disc_art();
    TurtleScript script_;
    std::vector<DrawnElement> elements_;
};

/// Without the rest of the command's work for a drawing: an outline through its chart.
class ChartLayer {
  public:
    explicit ChartLayer(const SurfaceMesh& surface) : layer_(surface, 1, false) {}

    void lay(SurfacePoint at, double radius) {
        const std::vector<DrawnElement> elements{drawn_element(art_, {{radius, 0}, {}, false})};
        DrawingStand stand;
        stand.at = at;
        const std::array<int, 1> chosen{0};
        constexpr double stretch = 1.5;
        layer_.lay(layer_.polar_chart(stand, radius), elements, chosen, stretch);
    }

  private:
    ElementLayer layer_;
    TerminalArt art_ = disc_art();
};

std::vector<SurfacePoint> places_on(const SurfaceMesh& surface) {
    Random random(17);
    std::vector<SurfacePoint> result;
    for (int i = 0; i < places; ++i) result.push_back(random_surface_point(surface, random));
    return result;
}

/// A piece is turned over, or two pieces of the shape lie on each other: by the pieces as they lie on their faces, not by
/// the chart that they came through.
bool is_folded(const LaidShape& shape) {
    double area = 0, common = 0;
    bool turned = false;
    for (const LaidLayer& layer : shape.layers) {
        std::map<int, std::vector<LaidPiece>> by_face;
        for (const LaidPiece& piece : layer.area.pieces) by_face[piece.face].push_back(piece);
        const auto corners = [&](const LaidPiece& piece) { return layer.area.corners.data() + piece.first; };
        for (const auto& [face, pieces] : by_face)
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                const double own =
                    convex_common_area(corners(pieces[i]), pieces[i].count, corners(pieces[i]), pieces[i].count);
                area += own;
                double twice = 0;
                for (int k = 0; k < pieces[i].count; ++k)
                    twice += cross(corners(pieces[i])[k], corners(pieces[i])[(k + 1) % pieces[i].count]);
                turned = turned || twice < 0;
                for (std::size_t j = 0; j < i; ++j)
                    common += convex_common_area(corners(pieces[i]), pieces[i].count, corners(pieces[j]), pieces[j].count);
            }
    }
    constexpr double rounding = 1e-6;  // of the area
    return turned || common > rounding * area;
}

struct Shares {
    std::vector<std::pair<double, std::string>> dropped;  ///< percent by mesh, the most first
    double worst_full = 0;                                ///< percent shrunk or dropped, of the worst mesh
    long folded = 0, laid = 0;
};

Shares shares_at(const std::vector<MeshCase>& meshes, double share) {
    Shares shares;
    for (const MeshCase& mesh : meshes) {
        if (!is_closed(mesh)) continue;
        const DiscLayer layer(*mesh.surface);
        long not_full = 0, lost = 0;
        for (const SurfacePoint at : places_on(*mesh.surface)) {
            const LaidScript laid = layer.lay(at, share * mesh.surface->diagonal);
            not_full += laid.shapes.empty() || laid.shrunk > 0 ? 1 : 0;
            lost += laid.shapes.empty() ? 1 : 0;
            for (const LaidShape& shape : laid.shapes) shares.folded += is_folded(shape) ? 1 : 0;
            shares.laid += static_cast<long>(laid.shapes.size());
        }
        shares.worst_full = std::max(shares.worst_full, 100.0 * static_cast<double>(not_full) / places);
        shares.dropped.emplace_back(100.0 * static_cast<double>(lost) / places, mesh.name);
    }
    std::ranges::sort(shares.dropped, std::greater<>());
    return shares;
}

void share_lines(GrowthLines& lines, const std::vector<MeshCase>& meshes) {
    struct Bar {
        double share, most_lost;
    };
    for (const Bar bar : {Bar{0.01, 0.5}, Bar{0.02, 2}, Bar{0.04, 8}}) {
        const Shares shares = shares_at(meshes, bar.share);
        std::ostringstream name;
        name << "radius " << bar.share << ": ";
        const auto of_mesh = [&](std::size_t i) { return "dropped, % of " + shares.dropped[i].second; };
        if (shares.dropped.size() < 2) return lines.failed("fewer than two closed meshes");
        lines.at_most(name.str() + of_mesh(0), shares.dropped[0].first, bar.most_lost);
        lines.say(name.str() + of_mesh(1), shares.dropped[1].first);
        lines.say(name.str() + "shrunk or dropped, %, worst mesh", shares.worst_full);
        lines.at_most(name.str() + "with a fold, of " + std::to_string(shares.laid), static_cast<double>(shares.folded), 0);
    }
}

void speed_lines(GrowthLines& lines, const MeshCase& mesh) {
    const std::vector<SurfacePoint> at = places_on(*mesh.surface);
    for (const double share : {0.01, 0.02, 0.03}) {
        ChartLayer layer(*mesh.surface);
        const double seconds = best_seconds(5, [&] {
            for (const SurfacePoint place : at) layer.lay(place, share * mesh.surface->diagonal);
        });
        std::ostringstream name;
        name << mesh.name << ", radius " << share << ": laid a second";
        lines.at_least(name.str(), places / seconds, 5000);
    }
}

}  // namespace

void laying_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes) {
    if (!options.wants("outlines")) return;
    lines.begin("outlines (discs) laid on closed surfaces, 300 places each");
    share_lines(lines, meshes);
    for (const MeshCase& mesh : meshes)
        if (mesh.surface && (mesh.name == "cub" || mesh.name == "bunny_adaptive")) speed_lines(lines, mesh);
}

}  // namespace rinceau::test

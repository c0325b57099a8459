#include "growth/arrangement/tile_of_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "geometry/kd_tree.h"
#include "growth/arrangement/connectivity.h"
#include "growth/arrangement/kinds.h"
#include "growth/figure_parts.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

double radius_of(const FiguredDrawing& drawing, const FigureInstance& instance) {
    return drawing.figures[static_cast<std::size_t>(instance.figure)].radius * scale_of(instance.pose);
}

Region outline_of(const FiguredDrawing& drawing, const FigureInstance& instance) {
    return transformed(drawing.figures[static_cast<std::size_t>(instance.figure)].outline, instance.pose);
}

/// An edge of the tile, and the move by a tile that takes it to the opposite edge.
struct TileEdge {
    bool upright = false;  ///< x is constant along it
    double at = 0;
    double outward = 1;
    Point across;
};

std::vector<TileEdge> edges_of(const Box& tile) {
    return {{true, tile.low.x, -1, {width(tile), 0}},
            {true, tile.high.x, 1, {-width(tile), 0}},
            {false, tile.low.y, -1, {0, height(tile)}},
            {false, tile.high.y, 1, {0, -height(tile)}}};
}

/// Where a region meets an edge, along it.
struct EdgeContact {
    double low = 0;
    double high = 0;
    double overhang = 0;  ///< how far it reaches beyond
};

/// Contact within `band` of the edge, if any.
std::optional<EdgeContact> edge_contact(const Region& region, const TileEdge& edge, double band) {
    EdgeContact contact{INFINITY, -INFINITY, -INFINITY};
    const auto beyond = [&](Point p) { return edge.outward * ((edge.upright ? p.x : p.y) - edge.at); };
    const auto along = [&](Point p) { return edge.upright ? p.y : p.x; };
    const auto meet = [&](double place) {
        contact.low = std::min(contact.low, place);
        contact.high = std::max(contact.high, place);
    };
    for (const auto& polygon : region)
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Point p = polygon[k];
            const Point q = polygon[(k + 1) % polygon.size()];
            contact.overhang = std::max(contact.overhang, beyond(p));
            if (std::abs(beyond(p)) <= band) meet(along(p));
            if ((beyond(p) > -band) != (beyond(q) > -band)) {
                const double share = (-band - beyond(p)) / (beyond(q) - beyond(p));
                meet(along(p) + share * (along(q) - along(p)));
            }
        }
    if (contact.low > contact.high || contact.overhang < -band) return {};
    return contact;
}

/// Instance `other`, moved by `move`, is the same element as instance `one`, or a piece of it.
struct TileTwin {
    int one = 0;
    int other = 0;
    Point move;
    bool copy = false;
};

struct TileTwins {
    std::vector<TileTwin> twins;
    std::size_t overhanging = 0;  ///< times that an instance reaches over an edge, or to it with a twin ..
    std::size_t continued = 0;    ///< .. and goes on at the opposite one
};

class TwinSearch {
  public:
    TwinSearch(const FiguredDrawing& drawing, const Box& tile)
        : drawing_(drawing), tile_(tile), tree_(middles(drawing)), edges_(edges_of(tile)) {
        constexpr double hair = 0.01;  // of the tile: pieces end at the edge or a stroke's width beyond
        band_ = hair * std::min(width(tile), height(tile));
        for (const FigureInstance& instance : drawing.instances) outlines_.push_back(outline_of(drawing, instance));
        contacts_.resize(drawing.instances.size());
        for (std::size_t i = 0; i < contacts_.size(); ++i)
            for (const TileEdge& edge : edges_) contacts_[i].push_back(edge_contact(outlines_[i], edge, band_));
        for (std::size_t i = 0; i < contacts_.size(); ++i)
            if (std::ranges::none_of(contacts_[i], [](const auto& contact) { return contact.has_value(); }))
                largest_inside_ = std::max(largest_inside_, diagonal(bounds(outlines_[i])));
    }

    TileTwins twins() const {
        TileTwins result;
        for (int i = 0; i < static_cast<int>(drawing_.instances.size()); ++i)
            for (std::size_t e = 0; e < edges_.size(); ++e) {
                const auto& contact = contacts_[static_cast<std::size_t>(i)][e];
                if (!contact) continue;
                const auto twin = twin_across(i, e);
                if (twin) result.twins.push_back(*twin);
                constexpr double clearly = 0.02;  // of the radius
                const double radius = radius_of(drawing_, drawing_.instances[static_cast<std::size_t>(i)]);
                if (contact->overhang < clearly * radius && !twin) continue;  // it only touches the edge
                ++result.overhanging;
                result.continued += twin ? 1 : 0;
            }
        return result;
    }

  private:
    static std::vector<Point> middles(const FiguredDrawing& drawing) {
        std::vector<Point> points;
        for (const FigureInstance& instance : drawing.instances) points.push_back(instance.pose.translation);
        return points;
    }

    std::optional<TileTwin> twin_across(int i, std::size_t edge) const {
        const Point move = -edges_[edge].across;  // takes the twin, at the opposite edge, to this one
        if (const int copy = copy_at(i, -move); copy >= 0) return TileTwin{i, copy, move, true};
        if (const int piece = piece_across(i, edge); piece >= 0) return TileTwin{i, piece, move, false};
        return {};
    }

    /// The instance that looks like i moved by `by`.
    int copy_at(int i, Point by) const {
        constexpr double near = 0.15;  // of the radius
        constexpr double alike = 1.15;
        const FigureInstance& instance = drawing_.instances[static_cast<std::size_t>(i)];
        const double radius = radius_of(drawing_, instance);
        for (const Neighbor& other : tree_.within(instance.pose.translation + by, near * radius)) {
            const double size = radius_of(drawing_, drawing_.instances[other.index]);
            if (size < alike * radius && radius < alike * size) return static_cast<int>(other.index);
        }
        return -1;
    }

    /// The instance that meets the opposite edge where i meets this one.
    int piece_across(int i, std::size_t edge) const {
        const EdgeContact& here = *contacts_[static_cast<std::size_t>(i)][edge];
        const std::size_t opposite = edge ^ 1U;
        int best = -1;
        constexpr double least_share = 0.4;  // of the longer contact: slanted rods meet the edge a little apart
        double best_share = least_share;
        for (std::size_t j = 0; j < contacts_.size(); ++j) {
            const auto& there = contacts_[j][opposite];
            if (!there || static_cast<int>(j) == i) continue;
            const double common = std::min(here.high, there->high) - std::max(here.low, there->low);
            const double longer = std::max(here.high - here.low, there->high - there->low);
            if (longer > 0 && common / longer > best_share && makes_usual_size(i, static_cast<int>(j), edge)) {
                best_share = common / longer;
                best = static_cast<int>(j);
            }
        }
        return best;
    }

    /// Two pieces make an element like the others; two whole ones that end at the edges make one that is too large.
    bool makes_usual_size(int i, int j, std::size_t edge) const {
        constexpr double slack = 1.15;
        Box other = bounds(outlines_[static_cast<std::size_t>(j)]);
        other = {other.low - edges_[edge].across, other.high - edges_[edge].across};
        return diagonal(including(bounds(outlines_[static_cast<std::size_t>(i)]), other)) <= slack * largest_inside_;
    }

    const FiguredDrawing& drawing_;
    Box tile_;
    KdTree tree_;
    std::vector<TileEdge> edges_;
    double band_ = 0;
    std::vector<Region> outlines_;
    std::vector<std::vector<std::optional<EdgeContact>>> contacts_;
    double largest_inside_ = 0;  ///< diagonal of the largest element that meets no edge
};

double into(double value, double low, double size) { return value - size * std::floor((value - low) / size); }

/// An instance that goes on across the edge, with the moves that bring its twins to it.
struct TorusElement {
    std::vector<std::pair<int, Point>> pieces;  ///< instance, move
};

/// Each element of the torus, by its lowest instance; copies of a piece that is there already are left out.
std::vector<TorusElement> torus_elements(const FiguredDrawing& drawing, const TileTwins& twins) {
    std::vector<std::vector<const TileTwin*>> of_instance(drawing.instances.size());
    for (const TileTwin& twin : twins.twins) of_instance[static_cast<std::size_t>(twin.one)].push_back(&twin);
    std::vector<bool> seen(drawing.instances.size());
    std::vector<TorusElement> elements;
    for (std::size_t first = 0; first < seen.size(); ++first) {
        if (seen[first]) continue;
        seen[first] = true;
        TorusElement element{{{static_cast<int>(first), {}}}};
        std::vector<std::pair<int, Point>> open = element.pieces;
        while (!open.empty()) {
            const auto [from, moved] = open.back();
            open.pop_back();
            for (const TileTwin* twin : of_instance[static_cast<std::size_t>(from)]) {
                if (seen[static_cast<std::size_t>(twin->other)]) continue;
                seen[static_cast<std::size_t>(twin->other)] = true;
                open.emplace_back(twin->other, moved + twin->move);
                if (!twin->copy) element.pieces.emplace_back(twin->other, moved + twin->move);
            }
        }
        elements.push_back(std::move(element));
    }
    return elements;
}

/// A figure of the pieces where the tile's edge brings them together.
FigureInstance joined_pieces(const TorusElement& element, FiguredDrawing& drawing) {
    constexpr double overlap_half = 0.004;  // of a piece: as much as it takes to hide a seam
    Region outline;
    Region shrunk;  // the pieces, each made smaller: together still one where they overlap
    Figure figure;
    std::vector<Placement> parts;
    for (const auto& [i, move] : element.pieces) {
        FigureInstance instance = drawing.instances[static_cast<std::size_t>(i)];
        instance.pose.translation += move;
        const Region piece = outline_of(drawing, instance);
        outline = outline.empty() ? piece : union_of(outline, piece);
        shrunk = union_of(shrunk, offset_region(piece, -overlap_half * diagonal(bounds(piece))));
        const Figure& own = drawing.figures[static_cast<std::size_t>(instance.figure)];
        if (figure.symbol.empty()) figure.symbol = own.symbol + ".joined" + std::to_string(drawing.figures.size());
        for (Placement part : own.parts) {
            part.pose = instance.pose * part.pose;
            parts.push_back(std::move(part));
        }
    }
    constexpr double seam = 0.01;  // of the element: pieces may end a hair before the edge
    const double hair = seam * diagonal(bounds(outline));
    // pieces that barely meet, and outlines with their ends at the edge, would show where they were cut
    const bool seamless = outline.size() == 1 && shrunk.size() == 1;
    outline = offset_region(offset_region(outline, hair), -hair);
    const Similarity frame = translate(center(bounds(outline)));
    figure.outline = transformed(outline, inverse(frame));
    for (const auto& polygon : figure.outline)
        for (const Point corner : polygon) figure.radius = std::max(figure.radius, abs(corner));
    for (Placement& part : parts) part.pose = inverse(frame) * part.pose;
    figure.parts = std::move(parts);
    drawing.figures.push_back(std::move(figure));
    return {static_cast<int>(drawing.figures.size()) - 1, frame, seamless};
}

bool holds_kept_text(const FiguredDrawing& drawing, const FigureInstance& instance) {
    return std::ranges::any_of(drawing.figures[static_cast<std::size_t>(instance.figure)].parts, [&](const Placement& part) {
        return !drawing.grammar.terminals[static_cast<std::size_t>(part.terminal)].verbatim.empty();
    });
}

/// Least distances per pair of kinds, and the widest gap.
struct KindDistances {
    std::map<std::pair<int, int>, double> least;
    double widest = 0;  ///< radius of the largest empty circle among the faces
};

KindDistances distances(const std::vector<Point>& points, const std::vector<int>& kinds, const std::optional<Box>& within) {
    KindDistances result;
    const Connectivity connectivity = connectivity_of(points);
    const auto counts = [&](Point p) {
        return !within || (p.x >= within->low.x && p.x < within->high.x && p.y >= within->low.y && p.y < within->high.y);
    };
    for (const auto& face : connectivity.faces) {
        const FaceCircle circle = face_circle(points, face);
        if (counts(circle.center)) result.widest = std::max(result.widest, circle.radius);
    }
    for (std::size_t p = 0; p < points.size(); ++p)
        for (const int q : connectivity.rings[p]) {
            if (!counts(points[p])) continue;
            const int a = kinds[p % kinds.size()];
            const int b = kinds[static_cast<std::size_t>(q) % kinds.size()];
            double& least = result.least.try_emplace(std::minmax({a, b}), INFINITY).first->second;
            least = std::min(least, abs(points[static_cast<std::size_t>(q)] - points[p]));
        }
    return result;
}

}  // namespace

std::optional<Box> evident_tile(const FiguredDrawing& drawing) {
    const Box& tile = drawing.grammar.canvas;
    if (!(width(tile) > 0 && height(tile) > 0) || drawing.instances.empty()) return {};
    const TileTwins twins = TwinSearch(drawing, tile).twins();
    constexpr std::size_t fewest = 4;  // two elements, each cut at two edges
    constexpr double nearly_all = 0.8;
    if (twins.overhanging < fewest ||
        static_cast<double>(twins.continued) < nearly_all * static_cast<double>(twins.overhanging))
        return {};
    return tile;
}

std::optional<Box> likely_tile(const FiguredDrawing& drawing) {
    if (const auto evident = evident_tile(drawing)) return evident;
    const Box& tile = drawing.grammar.canvas;
    if (!(width(tile) > 0 && height(tile) > 0)) return {};
    std::vector<Point> points;
    for (const FigureInstance& instance : drawing.instances) {
        if (!instance.whole) return {};
        points.push_back(instance.pose.translation);
    }
    const std::vector<int> kinds = element_kinds(drawing).of_instance;
    const KindDistances alone = distances(points, kinds, {});
    for (int column = -1; column <= 1; ++column)
        for (int row = -1; row <= 1; ++row)
            for (std::size_t i = 0; (column != 0 || row != 0) && i < drawing.instances.size(); ++i)
                points.push_back(points[i] + Point{column * width(tile), row * height(tile)});
    const KindDistances repeated = distances(points, kinds, tile);
    constexpr double nearly = 0.7;
    constexpr double hardly = 1.1;
    if (!(alone.widest > 0) || repeated.widest > hardly * alone.widest) return {};
    for (const auto& [pair, least] : repeated.least)
        if (const auto own = alone.least.find(pair); own != alone.least.end() && least < nearly * own->second) return {};
    return tile;
}

std::optional<Box> sensible_tile(const FiguredDrawing& drawing, const ExemplarOptions& options) {
    if (const auto evident = evident_tile(drawing)) return evident;
    const auto likely = likely_tile(drawing);
    if (!likely) return {};
    constexpr std::ptrdiff_t enough = 12;  // usable elements: with fewer, the same ones are seen again and again
    try {
        const Exemplar alone = make_exemplar(drawing, options, "");
        const bool many = std::ranges::count_if(alone.elements, &ExemplarElement::usable) >= enough;
        return many || !alone.irregular ? std::optional<Box>{} : likely;
    } catch (const InputError&) {
        return likely;
    }
}

FiguredDrawing as_tile(const FiguredDrawing& drawing, const Box& tile) {
    const TileTwins twins = TwinSearch(drawing, tile).twins();
    FiguredDrawing result = drawing;
    std::vector<FigureInstance> instances;
    for (const TorusElement& element : torus_elements(drawing, twins)) {
        FigureInstance instance = drawing.instances[static_cast<std::size_t>(element.pieces.front().first)];
        if (element.pieces.size() > 1)
            instance = joined_pieces(element, result);
        else
            instance.whole = true;
        if (holds_kept_text(result, instance)) instance.whole = false;
        Point& at = instance.pose.translation;
        at = {into(at.x, tile.low.x, width(tile)), into(at.y, tile.low.y, height(tile))};
        instances.push_back(instance);
    }
    result.instances = std::move(instances);
    return result;
}

}  // namespace rinceau

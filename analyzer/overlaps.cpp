#include "analyzer/overlaps.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "analyzer/painted_outline.h"
#include "geometry/box_tree.h"

namespace rinceau {
namespace {

/// Share of the margin by which polylines may stray from their curves: two of them stay well inside it.
constexpr double deviation_in_margins = 0.25;
/// No margin is wider than this share of the element's own box, so that small things with small gaps stay apart.
constexpr double margin_in_sizes = 0.05;
/// Pairs of meeting boxes that are looked at for each pair that may be kept.
constexpr std::size_t candidates_per_pair = 4;

/// In margins; keeps the polylines of specks finite.
constexpr double least_margin = 1e-3;

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr Box everywhere{{-unbounded, -unbounded}, {unbounded, unbounded}};

bool paints(const Element& element) {
    return !element.verbatim.empty() || (!element.paths.empty() && (paints_fill(element.style) || paints_stroke(element.style)));
}

/// The colour that is all an element paints.
std::optional<Color> only_color(const Element& element) {
    if (!element.verbatim.empty()) return std::nullopt;
    const bool fills = paints_fill(element.style);
    const bool strokes = paints_stroke(element.style);
    const Color* fill = std::get_if<Color>(&element.style.fill);
    const Color* stroke = std::get_if<Color>(&element.style.stroke.paint);
    if ((fills && fill == nullptr) || (strokes && stroke == nullptr)) return std::nullopt;
    if (fills && strokes && !(*fill == *stroke)) return std::nullopt;
    return fills ? *fill : *stroke;
}

/// What the search knows of each element; outlines are made when they are first asked for.
struct Search {
    const Scene& scene;
    std::vector<double> margins;
    std::vector<Box> boxes;  ///< grown by the margin; empty for what paints nothing
    std::vector<std::optional<Color>> colors;
    std::vector<std::optional<PaintedOutline>> outlines;
};

Search start_search(const Scene& scene, double margin) {
    Search search{scene, {}, {}, {}, {}};
    search.outlines.resize(scene.elements.size());
    for (const Element& element : scene.elements) {
        Box box = paints(element) ? painted_box(element) : Box{};
        const double own_margin = std::clamp(margin_in_sizes * diagonal(box), least_margin * margin, margin);
        box = grown(box, own_margin);
        if (!element.verbatim.empty() && is_empty(box)) box = everywhere;
        search.margins.push_back(own_margin);
        search.boxes.push_back(box);
        search.colors.push_back(is_empty(box) ? std::nullopt : only_color(element));
    }
    return search;
}

bool order_hidden(const Search& search, std::size_t i, std::size_t j) {
    return search.colors[i] && search.colors[j] && *search.colors[i] == *search.colors[j];
}

const PaintedOutline& outline_of(Search& search, std::size_t i) {
    if (!search.outlines[i]) {
        search.outlines[i] = painted_outline(search.scene.elements[i], deviation_in_margins * search.margins[i]);
    }
    return *search.outlines[i];
}

/// Do elements with meeting boxes touch?
bool elements_touch(Search& search, std::size_t i, std::size_t j) {
    const Element& a = search.scene.elements[i];
    const Element& b = search.scene.elements[j];
    if (!a.verbatim.empty() || !b.verbatim.empty()) return true;
    // Never less than what both polylines may stray: no true overlap is missed.
    const double strays = deviation_in_margins * (search.margins[i] + search.margins[j]);
    const double margin = std::max(std::min(search.margins[i], search.margins[j]), strays);
    return paint_touches(outline_of(search, i), outline_of(search, j), margin);
}

OverlapPair pair_of(std::size_t i, std::size_t j) {
    return {static_cast<int>(std::min(i, j)), static_cast<int>(std::max(i, j))};
}

/// Pairs of meeting boxes whose order can be seen; nothing if there are more than `limit`.
std::optional<std::vector<OverlapPair>> meeting_boxes(const Search& search, std::size_t limit) {
    std::vector<Box> bounded = search.boxes;
    std::vector<OverlapPair> pairs;
    for (std::size_t i = 0; i < bounded.size(); ++i) {
        if (!(bounded[i] == everywhere)) continue;
        bounded[i] = Box{};
        for (std::size_t j = 0; j < bounded.size(); ++j) {
            if (j != i && !is_empty(search.boxes[j]) && (j < i || !(search.boxes[j] == everywhere))) pairs.push_back(pair_of(i, j));
        }
        if (pairs.size() > limit) return std::nullopt;
    }
    const BoxTree tree(bounded);
    for (std::size_t i = 0; i < bounded.size(); ++i) {
        if (is_empty(bounded[i])) continue;
        tree.visit(bounded[i], [&](std::size_t j) {
            if (j < i && !order_hidden(search, i, j)) pairs.push_back(pair_of(i, j));
            return pairs.size() <= limit;
        });
        if (pairs.size() > limit) return std::nullopt;
    }
    return pairs;
}

/// The same for pairs at most `window` apart in paint order.
std::vector<OverlapPair> meeting_boxes_within(const Search& search, std::size_t window) {
    std::vector<OverlapPair> pairs;
    for (std::size_t i = 0; i < search.boxes.size(); ++i) {
        for (std::size_t j = i - std::min(i, window); j < i; ++j) {
            if (overlap(search.boxes[i], search.boxes[j]) && !order_hidden(search, i, j)) pairs.push_back(pair_of(i, j));
        }
    }
    return pairs;
}

void keep_nearest_in_order(std::vector<OverlapPair>& pairs, std::size_t count) {
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const OverlapPair& a, const OverlapPair& b) { return a.upper - a.lower < b.upper - b.lower; });
    pairs.resize(count);
}

}  // namespace

Overlaps find_overlaps(const Scene& scene, const OverlapOptions& options) {
    Search search = start_search(scene, options.margin * drawing_diagonal(scene));
    const std::size_t limit = candidates_per_pair * options.max_pairs;
    Overlaps found;
    std::vector<OverlapPair> candidates;
    if (auto all = meeting_boxes(search, limit)) {
        candidates = std::move(*all);
    } else {
        found.complete = false;
        candidates = meeting_boxes_within(search, std::max<std::size_t>(1, limit / scene.elements.size()));
    }
    for (const OverlapPair& pair : candidates) {
        if (elements_touch(search, static_cast<std::size_t>(pair.lower), static_cast<std::size_t>(pair.upper))) {
            found.pairs.push_back(pair);
        }
    }
    const auto by_upper = [](const OverlapPair& a, const OverlapPair& b) {
        return a.upper != b.upper ? a.upper < b.upper : a.lower < b.lower;
    };
    std::sort(found.pairs.begin(), found.pairs.end(), by_upper);
    if (found.pairs.size() > options.max_pairs) {
        found.complete = false;
        keep_nearest_in_order(found.pairs, options.max_pairs);
        std::sort(found.pairs.begin(), found.pairs.end(), by_upper);
    }
    return found;
}

}  // namespace rinceau

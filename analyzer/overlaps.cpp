#include "analyzer/overlaps.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>

#include "analyzer/translation_classes.h"
#include "analyzer/visible_order.h"
#include "geometry/box_tree.h"
#include "geometry/parallel.h"

namespace rinceau {
namespace {

/// No pixel is wider than this share of an element's diagonal.
constexpr double pixel_in_diagonals = 0.25;
/// In pixels of the picture; keeps the polylines of specks finite.
constexpr double least_pixel = 1e-3;
/// Regions that come this near share pixels.
constexpr double touching_in_pixels = 0.5;
/// Copies that differ by less than this share of a pixel are one class, pairs of classes as near in position one case.
constexpr double quantum_in_pixels = 1.0 / 64;
/// Pairs of meeting boxes that are looked at for each pair that may be kept.
constexpr std::size_t candidates_per_pair = 4;

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr Box everywhere{{-unbounded, -unbounded}, {unbounded, unbounded}};

bool paints(const Element& element) {
    return !element.verbatim.empty() ||
           (!element.paths.empty() && (paints_fill(element.style) || paints_stroke(element.style)));
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

enum class OrderMatters : std::uint8_t { no, faintly, visibly };

/// Two classes and the offset between them, in quanta.
using PairCase = std::array<std::int64_t, 4>;

struct PairCaseHash {
    std::size_t operator()(const PairCase& key) const {
        std::uint64_t hash = 0;
        constexpr std::uint64_t odd = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio: spreads neighbouring numbers
        for (const std::int64_t part : key) hash = (std::rotl(hash, 23) ^ static_cast<std::uint64_t>(part)) * odd;
        return static_cast<std::size_t>(hash ^ (hash >> 32));
    }
};

/// What the search knows of each element; outlines of those that are looked at.
struct Search {
    const Scene& scene;
    double quantum = 1;
    bool antialiasing = true;
    std::size_t samples_left = 0;
    std::vector<double> pixels;
    std::vector<Box> boxes;  ///< empty for what paints nothing
    std::vector<std::optional<Color>> colors;
    std::vector<int> classes;
    std::vector<bool> has_copies;
    std::vector<std::optional<PaintedElement>> painted;
};

double picture_pixel(const Scene& scene, double picture_width) {
    double across = width(scene.viewport);
    if (!(across > 0)) across = drawing_diagonal(scene);
    return across / picture_width;
}

std::vector<bool> shared_numbers(const std::vector<int>& classes) {
    std::vector<int> members;
    for (const int number : classes) {
        members.resize(std::max(members.size(), static_cast<std::size_t>(number) + 1));
        ++members[static_cast<std::size_t>(number)];
    }
    std::vector<bool> shared;
    for (const int number : classes) shared.push_back(members[static_cast<std::size_t>(number)] > 1);
    return shared;
}

Search start_search(const Scene& scene, const OverlapOptions& options) {
    const double pixel = picture_pixel(scene, options.picture_width);
    Search search{.scene = scene,
                  .quantum = quantum_in_pixels * pixel,
                  .antialiasing = options.antialiasing,
                  .samples_left = options.max_samples};
    search.classes = translation_classes(scene, search.quantum);
    search.has_copies = shared_numbers(search.classes);
    const std::size_t count = scene.elements.size();
    search.painted.resize(count);
    search.pixels.resize(count);
    search.boxes.resize(count);
    search.colors.resize(count);
    for_each_index(count, options.threads, [&](std::size_t i) {
        const Element& element = scene.elements[i];
        Box box = paints(element) ? painted_box(element) : Box{};
        search.pixels[i] = std::clamp(pixel_in_diagonals * diagonal(box), least_pixel * pixel, pixel);
        if (!element.verbatim.empty() && is_empty(box)) box = everywhere;
        search.boxes[i] = grown(box, touching_in_pixels / 2 * search.pixels[i]);
        search.colors[i] = is_empty(box) ? std::nullopt : only_color(element);
    });
    return search;
}

bool order_hidden(const Search& search, std::size_t i, std::size_t j) {
    return search.colors[i] && search.colors[j] && *search.colors[i] == *search.colors[j];
}

PairCase case_of(const Search& search, std::size_t i, std::size_t j) {
    const Point offset = search.scene.elements[j].paths.front().start - search.scene.elements[i].paths.front().start;
    return {search.classes[i], search.classes[j], std::llround(offset.x / search.quantum),
            std::llround(offset.y / search.quantum)};
}

double pixel_of(const Search& search, std::size_t i, std::size_t j) { return std::min(search.pixels[i], search.pixels[j]); }

struct Look {
    OrderMatters matters = OrderMatters::no;
    std::size_t samples = 0;  ///< points looked at
};

/// Both have their outlines.
Look look_at_pair(const Search& search, const OverlapPair& pair) {
    const auto i = static_cast<std::size_t>(pair.lower), j = static_cast<std::size_t>(pair.upper);
    const double pixel = pixel_of(search, i, j);
    const PaintedElement& a = *search.painted[i];
    const PaintedElement& b = *search.painted[j];
    if (!paint_touches(a.outline, b.outline, touching_in_pixels * pixel)) return {OrderMatters::no};
    if (search.antialiasing) return {OrderMatters::visibly};
    if (too_thin_to_see(a.outline.box, b.outline.box, pixel)) return {OrderMatters::faintly};
    if (search.samples_left == 0) return {OrderMatters::visibly};
    const VisibleOrder order = visible_order(a, b, pixel);
    return {order.visible ? OrderMatters::visibly : OrderMatters::faintly, order.samples};
}

constexpr const char* stage = "overlaps";

/// What is found for pairs of outlined elements, in their order.
std::vector<OrderMatters> look_at_pairs(Search& search, const std::vector<OverlapPair>& pairs, int threads,
                                        const Progress& progress) {
    // Outlines, once for each element.
    std::vector<std::size_t> needed;
    for (const OverlapPair& pair : pairs) {
        for (const int i : {pair.lower, pair.upper}) needed.push_back(static_cast<std::size_t>(i));
    }
    std::ranges::sort(needed);
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    for_each_index(needed.size(), threads, stage, progress, [&](std::size_t k, const Progress&) {
        const std::size_t i = needed[k];
        search.painted[i] = painted_element(search.scene.elements[i], sampling_deviation(search.pixels[i]));
    });
    // Between portions it is seen how many points may still be looked at.
    constexpr std::size_t portion = 256;
    std::vector<Look> looks(pairs.size());
    for (std::size_t begin = 0; begin < pairs.size(); begin += portion) {
        const std::size_t count = std::min(portion, pairs.size() - begin);
        const double done = static_cast<double>(begin) / static_cast<double>(pairs.size());
        for_each_index(count, threads, stage, progress, [&](std::size_t k, const Progress& told) {
            report(told, stage, done);
            looks[begin + k] = look_at_pair(search, pairs[begin + k]);
        });
        for (std::size_t k = begin; k < begin + count; ++k) {
            search.samples_left -= std::min(search.samples_left, looks[k].samples);
        }
    }
    std::vector<OrderMatters> found;
    for (const Look& look : looks) found.push_back(look.matters);
    return found;
}

/// For pairs with meeting boxes, in their order. Pairs of copies at equal offsets are looked at once.
std::vector<OrderMatters> orders_that_matter(Search& search, const std::vector<OverlapPair>& pairs, int threads,
                                             const Progress& progress) {
    constexpr int always = -1;
    const std::vector<Element>& elements = search.scene.elements;
    std::vector<OverlapPair> looked_at;
    std::vector<int> look_of_pair;
    std::unordered_map<PairCase, int, PairCaseHash> known;
    for (const OverlapPair& pair : pairs) {
        const auto i = static_cast<std::size_t>(pair.lower), j = static_cast<std::size_t>(pair.upper);
        int look = static_cast<int>(looked_at.size());
        if (!elements[i].verbatim.empty() || !elements[j].verbatim.empty()) {
            look = always;
        } else if (search.has_copies[i] && search.has_copies[j]) {
            look = known.try_emplace(case_of(search, i, j), look).first->second;
        }
        if (look == static_cast<int>(looked_at.size())) looked_at.push_back(pair);
        look_of_pair.push_back(look);
    }
    const std::vector<OrderMatters> looks = look_at_pairs(search, looked_at, threads, progress);
    std::vector<OrderMatters> found;
    for (const int look : look_of_pair) {
        found.push_back(look == always ? OrderMatters::visibly : looks[static_cast<std::size_t>(look)]);
    }
    return found;
}

OverlapPair pair_of(std::size_t i, std::size_t j) {
    return {static_cast<int>(std::min(i, j)), static_cast<int>(std::max(i, j))};
}

/// Pairs of meeting boxes whose order colour alone does not hide; nothing if there are more than `limit`.
std::optional<std::vector<OverlapPair>> meeting_boxes(const Search& search, std::size_t limit) {
    std::vector<Box> bounded = search.boxes;
    std::vector<OverlapPair> pairs;
    for (std::size_t i = 0; i < bounded.size(); ++i) {
        if (!(bounded[i] == everywhere)) continue;
        bounded[i] = Box{};
        for (std::size_t j = 0; j < bounded.size(); ++j) {
            if (j != i && !is_empty(search.boxes[j]) && (j < i || !(search.boxes[j] == everywhere)))
                pairs.push_back(pair_of(i, j));
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

Overlaps find_overlaps(const Scene& scene, const OverlapOptions& options, const Progress& progress) {
    report(progress, stage, 0);
    Search search = start_search(scene, options);
    const std::size_t limit = candidates_per_pair * options.max_pairs;
    Overlaps found;
    std::vector<OverlapPair> candidates;
    if (auto all = meeting_boxes(search, limit)) {
        candidates = std::move(*all);
    } else {
        found.complete = false;
        candidates = meeting_boxes_within(search, std::max<std::size_t>(1, limit / scene.elements.size()));
    }
    const std::vector<OrderMatters> matters = orders_that_matter(search, candidates, options.threads, progress);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        if (matters[k] == OrderMatters::visibly) found.pairs.push_back(candidates[k]);
        if (matters[k] == OrderMatters::faintly) found.faint.push_back(candidates[k]);
    }
    const auto by_upper = [](const OverlapPair& a, const OverlapPair& b) {
        return a.upper != b.upper ? a.upper < b.upper : a.lower < b.lower;
    };
    std::sort(found.pairs.begin(), found.pairs.end(), by_upper);
    std::sort(found.faint.begin(), found.faint.end(), by_upper);
    if (found.pairs.size() > options.max_pairs) {
        found.complete = false;
        keep_nearest_in_order(found.pairs, options.max_pairs);
        std::sort(found.pairs.begin(), found.pairs.end(), by_upper);
    }
    return found;
}

}  // namespace rinceau

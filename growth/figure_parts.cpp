#include "growth/figure_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/polygon.h"
#include "lsystem/grammar_names.h"
#include "lsystem/to_scene.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

Box moved(const Box& box, const Similarity& pose) {
    Box result;
    if (is_empty(box)) return result;
    for (const Point corner : {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
        result = including(result, apply(pose, corner));
    return result;
}

Box common_box(const Box& a, const Box& b) {
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

Region box_region(const Box& box) { return {{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}}; }

/// The fragment without its only clip; nothing if it has none or several.
std::optional<std::string> unclipped_fragment(const std::string& fragment) {
    const std::string clip = "clip-path=\"";
    const std::size_t first = fragment.find(clip);
    if (first == std::string::npos || fragment.find(clip, first + 1) != std::string::npos) return {};
    const std::size_t end = fragment.find('"', first + clip.size());
    if (end == std::string::npos) return {};
    return fragment.substr(0, first) + fragment.substr(end + 1);
}

/// The shape that a fragment draws if its clip is taken away, in the terminal's frame.
std::optional<Element> unclipped_element(const Terminal& terminal) {
    const auto fragment = unclipped_fragment(terminal.verbatim);
    if (!fragment) return {};
    const std::string front = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\">";
    try {
        const SvgReadResult read = read_svg(front + *fragment + "</svg>", {.split_compound_paths = false});
        if (read.scene.elements.size() != 1 || !read.scene.elements.front().verbatim.empty()) return {};
        return read.scene.elements.front();
    } catch (const std::runtime_error&) {
        return {};  // it stays the fragment that it is
    }
}

/// Does the picture's edge alone make `whole` what was seen of it?
bool cut_by_canvas(const Box& whole, const Box& seen, const Box& canvas) {
    const Box cut = common_box(whole, canvas);
    if (is_empty(cut) || is_empty(seen)) return false;
    constexpr double share = 0.02;  // boxes of fragments are somewhat wider than what they hold
    const double slack = share * diagonal(whole) + 1e-3 * diagonal(canvas);
    return std::max({std::abs(cut.low.x - seen.low.x), std::abs(cut.low.y - seen.low.y), std::abs(cut.high.x - seen.high.x),
                     std::abs(cut.high.y - seen.high.y)}) <= slack;
}

/// Replaces fragments by whole shapes where the picture's edge alone has cut them.
class ClipRemoval {
  public:
    explicit ClipRemoval(Grammar& grammar) : grammar_(grammar) {}

    /// The terminal that draws it whole, or -1.
    int whole_terminal(const Placement& placement) {
        const auto known = known_.find(placement.terminal);
        if (known != known_.end()) return known->second;
        return known_[placement.terminal] = find_whole(placement);
    }

  private:
    int find_whole(const Placement& placement) {
        const Terminal& terminal = grammar_.terminals[static_cast<std::size_t>(placement.terminal)];
        auto element = unclipped_element(terminal);
        if (!element) return -1;
        const Box whole = moved(painted_box(*element), placement.pose);
        if (!cut_by_canvas(whole, moved(terminal.verbatim_box, placement.pose), grammar_.canvas)) return -1;
        int style = 0;
        for (const NumberedStyle& s : grammar_.styles) style = std::max(style, s.number);
        const auto taken = [&](const std::string& name) {
            return std::ranges::count(grammar_.terminals, name, &Terminal::symbol) > 0 ||
                   std::ranges::count(grammar_.productions, name, &Production::symbol) > 0;
        };
        const std::string symbol = free_name(terminal.symbol + "_whole", taken);
        grammar_.styles.push_back({.number = style + 1, .style = element->style});
        grammar_.terminals.push_back({.symbol = symbol, .style = style + 1, .paths = std::move(element->paths)});
        return static_cast<int>(grammar_.terminals.size()) - 1;
    }

    Grammar& grammar_;
    std::map<int, int> known_;
};

/// Gives placements whose stroke has a fixed width a style with that width at their scale.
class StrokeRelease {
  public:
    explicit StrokeRelease(Grammar& grammar) : grammar_(grammar) {}

    void release(Placement& placement) {
        const Terminal& terminal = grammar_.terminals[static_cast<std::size_t>(placement.terminal)];
        const int number = placement.style != 0 ? placement.style : terminal.style;
        const auto style = std::ranges::find(grammar_.styles, number, &NumberedStyle::number);
        if (style == grammar_.styles.end() || !style->style.stroke.fixed) return;
        constexpr double dot = 0.05;  // a line that is so short beside its width is a dot: scale does not show
        const Box box = bounds(terminal.paths);
        if (diagonal(box) * std::max(1.0, scale_of(placement.pose)) < dot * style->style.stroke.width)
            set_scale(placement.pose, center(box));
        placement.style = released(number, style->style, scale_of(placement.pose));
    }

  private:
    /// Scale 1, with `still` in its place.
    static void set_scale(Similarity& pose, Point still) {
        const Point place = apply(pose, still);
        pose.linear = pose.linear / scale_of(pose);
        pose.translation += place - apply(pose, still);
    }

    int released(int number, Style style, double scale) {
        constexpr double steps = 1e6;  // scales that are alike to a millionth share a style
        const auto key = std::pair{number, std::llround(steps * std::log(scale))};
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        style.stroke.fixed = false;
        style.stroke.width /= scale;
        style.stroke.dash_offset /= scale;
        for (double& dash : style.stroke.dashes) dash /= scale;
        int next = 0;
        for (const NumberedStyle& s : grammar_.styles) next = std::max(next, s.number);
        grammar_.styles.push_back({.number = next + 1, .style = std::move(style)});
        return known_[key] = next + 1;
    }

    Grammar& grammar_;
    std::map<std::pair<int, long long>, int> known_;
};

/// Regions in frames of their own, each made once.
class RegionCache {
  public:
    RegionCache(const Grammar& grammar, double deviation) : grammar_(grammar), deviation_(deviation) {}

    Region placed(const Placement& placement) {
        const auto key = std::pair{placement.terminal, placement.style};
        auto found = regions_.find(key);
        if (found == regions_.end()) found = regions_.emplace(key, region_of(placement)).first;
        return transformed(found->second, placement.pose);
    }

  private:
    Region region_of(Placement placement) const {
        placement.pose = {};
        const Scene scene = to_scene(grammar_, {placement});
        const double extent = diagonal(painted_box(scene.elements.front()));
        if (!(extent > 0)) return {};
        return painted_region(scene.elements.front(), deviation_ * extent);
    }

    const Grammar& grammar_;
    double deviation_;
    std::map<std::pair<int, int>, Region> regions_;
};

bool cut_by_edge(const Box& box, const Box& canvas) {
    constexpr double hair = 0.02;  // of the shape
    return !is_empty(canvas) && !contains(grown(canvas, hair * diagonal(box)), box);
}

void add_kept_part(const Placement& placement, const Box& own_box, FigureParts& result, std::size_t& unknown) {
    const Box box = moved(own_box, placement.pose);
    if (is_empty(box) || !std::isfinite(diagonal(box)) || !(width(box) > 0 && height(box) > 0)) {
        ++unknown;
        return;
    }
    const Region region = box_region(box);
    result.parts.push_back({placement, region, region, box, true, true});
}

std::string warning_text(std::size_t count, const std::string& one, const std::string& many) {
    return count == 1 ? "1 " + one : std::to_string(count) + " " + many;
}

}  // namespace

Region without_holes(const Region& region) {
    Region whole;
    for (std::size_t i = 0; i < region.size(); ++i) {
        bool inside = false;  // polygons do not cross: one corner tells
        for (std::size_t j = 0; j < region.size() && !inside; ++j)
            inside = j != i && contains(bounds(Region{region[j]}), Box{region[i].front(), region[i].front()}) &&
                     inside_evenodd(region[j], region[i].front());
        if (!inside) whole.push_back(region[i]);
    }
    return whole;
}

Region transformed(Region region, const Similarity& pose) {
    for (auto& polygon : region)
        for (Point& corner : polygon) corner = apply(pose, corner);
    return region;
}

FigureParts figure_parts(const Grammar& grammar, double deviation, const Progress& progress) {
    const std::vector<Placement> placements = interpret(grammar, {.addresses = true}, progress);
    FigureParts result{.grammar = grammar};
    ClipRemoval removal(result.grammar);
    StrokeRelease strokes(result.grammar);
    RegionCache cache(result.grammar, deviation);
    std::size_t unknown = 0;
    std::size_t invisible = 0;
    constexpr std::size_t report_every = 256;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        if (i % report_every == 0)
            report(progress, "shapes", static_cast<double>(i) / static_cast<double>(placements.size()));
        Placement placement = placements[i];
        const auto terminal = static_cast<std::size_t>(placement.terminal);
        const bool verbatim = !result.grammar.terminals[terminal].verbatim.empty();
        if (verbatim) {
            const int whole = removal.whole_terminal(placement);
            if (whole < 0) {
                add_kept_part(placement, result.grammar.terminals[terminal].verbatim_box, result, unknown);
                continue;
            }
            placement.terminal = whole;
            placement.style = 0;
        }
        strokes.release(placement);
        const Region region = cache.placed(placement);
        if (region.empty() || !(area(region) > 0)) {
            ++invisible;
            continue;
        }
        const Box box = bounds(region);
        result.parts.push_back(
            {placement, region, without_holes(region), box, verbatim || cut_by_edge(box, grammar.canvas), false});
    }
    if (unknown > 0)
        result.warnings.push_back(warning_text(unknown, "piece that is kept as SVG text has no known extent and is left out",
                                               "pieces that are kept as SVG text have no known extent and are left out"));
    if (invisible > 0)
        result.warnings.push_back(
            warning_text(invisible, "shape paints nothing and is left out", "shapes paint nothing and are left out"));
    return result;
}

}  // namespace rinceau

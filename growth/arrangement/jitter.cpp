// After Ijiri et al. 2008, figure 8b: random scale, rotation and colour. The paper says nothing of elements that then meet.
// Here elements change one after the other, each against those that have changed before it and the others as they were; so
// that what stands is free of new overlaps after every one.

#include "growth/arrangement/jitter.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/box_tree.h"
#include "geometry/random.h"
#include "growth/arrangement/place_figures.h"
#include "growth/shared_area.h"
#include "lsystem/drawn_style.h"
#include "lsystem/style_table.h"
#include "scene/oklab.h"

namespace rinceau {
namespace {

/// What is drawn for an element, in this order, whatever is asked for: each in [-1, 1).
struct JitterDraw {
    double turn = 0, growth = 0, hue = 0, lightness = 0;
};

JitterDraw draw(std::uint64_t seed, std::size_t element) {
    constexpr std::uint64_t apart = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio: neighbours get streams far apart
    Random random(seed + apart * (element + 1));
    JitterDraw drawn;
    for (double* value : {&drawn.turn, &drawn.growth, &drawn.hue, &drawn.lightness}) *value = random.uniform(-1, 1);
    return drawn;
}

Color shifted(Color color, const JitterDraw& drawn, double share) {
    OklabColor seen = to_oklab(color);
    seen.chroma = seen.chroma * polar(1, share * drawn.hue * pi);
    seen.lightness = std::clamp(seen.lightness + 0.5 * share * drawn.lightness, 0.0, 1.0);
    return from_oklab(seen);
}

std::vector<Repaint> shifted_paints(const FiguredDrawing& drawing, const StyleTable& styles, const PlacedFigure& placed,
                                    const JitterDraw& drawn, double share) {
    const Figure& figure = drawing.figures[static_cast<std::size_t>(placed.figure)];
    std::vector<Repaint> repaints;
    for (std::size_t i = 0; i < figure.parts.size(); ++i) {
        const Placement& part = figure.parts[i];
        Style style = repainted(styles.style(drawn_style_number(drawing.grammar, part)), part.repaint);
        if (!placed.repaints.empty()) style = repainted(std::move(style), placed.repaints[i]);
        const auto other = [&](const Paint& paint) -> std::optional<Color> {
            const Color* color = std::get_if<Color>(&paint);
            return color ? std::optional<Color>(shifted(*color, drawn, share)) : std::nullopt;
        };
        repaints.push_back({other(style.fill), other(style.stroke.paint)});
    }
    return repaints;
}

/// Turned and grown about the centre by a share of what was drawn.
Similarity jittered_pose(const Similarity& pose, const JitterDraw& drawn, const JitterOptions& options, double share) {
    const double factor = std::exp(share * drawn.growth * std::log1p(options.scale));
    Similarity moved = scale_by(factor) * rotate(share * drawn.turn * options.angle) * pose;
    moved.translation = pose.translation;
    return moved;
}

/// Which figures could meet which, however they are turned and grown.
BoxTree reaches_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed, double scale) {
    std::vector<Box> boxes;
    for (const PlacedFigure& one : placed) {
        const double radius =
            drawing.figures[static_cast<std::size_t>(one.figure)].radius * scale_of(one.pose) * (1 + scale);
        boxes.push_back(grown(Box{one.pose.translation, one.pose.translation}, radius));
    }
    return BoxTree(boxes);
}

}  // namespace

std::vector<PlacedFigure> jittered(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed,
                                   const JitterOptions& options, const Boundary* boundary) {
    const StyleTable styles(drawing.grammar);
    const bool moves = options.angle > 0 || options.scale > 0;
    std::vector<Region> before, now;
    if (moves) {
        for (const PlacedFigure& one : placed) before.push_back(placed_outline(drawing, one));
        now = before;
    }
    const BoxTree reaches = moves ? reaches_of(drawing, placed, options.scale) : BoxTree();

    const auto is_free = [&](std::size_t i, const PlacedFigure& moved, const Region& outline) {
        const Region& shape = drawing.figures[static_cast<std::size_t>(moved.figure)].outline;
        if (boundary != nullptr && boundary->cuts(shape, moved.pose)) return false;
        return reaches.visit(bounds(outline), [&](std::size_t k) {
            return k == i || !share_area(outline, now[k]) || share_area(before[i], before[k]);
        });
    };
    std::vector<PlacedFigure> result = placed;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const JitterDraw drawn = draw(options.seed, i);
        if (options.color > 0) result[i].repaints = shifted_paints(drawing, styles, placed[i], drawn, options.color);
        if (!moves) continue;
        constexpr double least_share = 1.0 / 16;  // less cannot be seen
        for (double share = 1; share >= least_share; share /= 2) {
            PlacedFigure moved = result[i];
            moved.pose = jittered_pose(placed[i].pose, drawn, options, share);
            Region outline = placed_outline(drawing, moved);
            if (!is_free(i, moved, outline)) continue;
            result[i] = std::move(moved);
            now[i] = std::move(outline);
            break;
        }
    }
    return result;
}

}  // namespace rinceau

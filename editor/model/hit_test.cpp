#include "editor/model/hit_test.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polygon.h"
#include "scene/pen.h"

namespace rinceau {
namespace {

using Polylines = std::vector<std::vector<Point>>;

bool finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

bool finite(const Box& box) { return finite(box.low) && finite(box.high); }

/// The box of the image of a box, which is larger than the image where the similarity turns it.
Box image_box(const Box& box, const Similarity& pose) {
    if (is_empty(box)) return {};
    Box image;
    for (const Point corner : {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
        image = including(image, apply(pose, corner));
    return image;
}

double distance_to(const Polylines& lines, Point p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::vector<Point>& line : lines) {
        Point from = line.front();
        for (const Point to : line) {
            nearest = std::min(nearest, distance_to_segment(p, from, to));
            from = to;
        }
    }
    return nearest;
}

bool encloses(const Polylines& outlines, FillRule rule, Point p) {
    int winding = 0;
    bool odd = false;
    for (const std::vector<Point>& outline : outlines) {
        if (rule == FillRule::nonzero) {
            winding += winding_number(outline, p);
        } else {
            odd = odd != inside_evenodd(outline, p);
        }
    }
    return rule == FillRule::nonzero ? winding != 0 : odd;
}

/// Closed ones end where they began.
Polylines polylines(const std::vector<Path>& paths, double deviation) {
    Polylines lines;
    for (const Path& path : paths) {
        std::vector<Point> line = flattened(path, deviation);
        if (path.closed) line.push_back(path.start);
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace

/// A look in its terminal's frame.
struct HitIndex::Look {
    Style style;
    bool verbatim = false;
    bool fills = false;
    bool strokes = false;
    Box box;  ///< of outline and stroke; without the stroke if that is fixed
    Polylines lines;
    Affine to_pen;        ///< into the space where the pen is a circle
    Polylines pen_lines;  ///< there; empty if the pen is a circle as it is

    Look(const Terminal& terminal, const Style& style_of_look)
        : style(style_of_look),
          verbatim(!terminal.verbatim.empty()),
          fills(paints_fill(style)),
          strokes(paints_stroke(style)) {
        if (verbatim) {
            box = terminal.verbatim_box;
            return;
        }
        if (!fills && !strokes) return;
        // Finer than a pixel even where one element fills the screen.
        constexpr double fineness = 1.0 / 4000;
        const Box outline = bounds(terminal.paths);
        if (is_empty(outline) || !finite(outline)) return;
        const double deviation = std::max(fineness * diagonal(outline), std::numeric_limits<double>::min());
        lines = polylines(terminal.paths, deviation);
        const Linear2& pen = style.stroke.pen;
        box = strokes && !style.stroke.fixed ? grown(outline, 0.5 * style.stroke.width * largest_stretch(pen)) : outline;
        const Affine from_pen{pen.a, pen.b, pen.c, pen.d};
        if (pen == Linear2{} || determinant(from_pen) == 0) return;
        to_pen = inverse(from_pen);
        pen_lines = polylines(transformed(terminal.paths, to_pen), deviation);
    }

    Box box_at(const Similarity& pose) const {
        const Box image = image_box(box, pose);
        return strokes && style.stroke.fixed ? grown(image, 0.5 * style.stroke.width) : image;
    }
    bool stroke_hit(Point p, double reach, double half_width) const {
        if (!strokes) return false;
        if (distance_to(lines, p) <= (pen_lines.empty() ? std::max(half_width, reach) : reach)) return true;
        return !pen_lines.empty() && distance_to(pen_lines, apply(to_pen, p)) <= half_width;
    }
};

HitIndex::HitIndex(std::shared_ptr<const DerivedPicture> picture) : picture_(std::move(picture)) {
    if (!picture_) return;
    std::vector<Look> looks;
    looks.reserve(picture_->looks.size());
    const std::vector<Terminal>& terminals = picture_->grammar->terminals;
    for (const PictureLook& look : picture_->looks)
        looks.push_back(Look(terminals[static_cast<std::size_t>(look.terminal)], picture_style(*picture_, look)));
    boxes_.reserve(picture_->items.size());
    for (const PictureItem& item : picture_->items) {
        const Box box = looks[static_cast<std::size_t>(item.look)].box_at(item.pose);
        boxes_.push_back(finite(box) ? box : Box{});
    }
    looks_ = std::make_shared<const std::vector<Look>>(std::move(looks));
    tree_ = BoxTree(boxes_);
}

bool HitIndex::hits(std::size_t item, Point scene, double reach, bool near_fill) const {
    const PictureItem& hit = picture_->items[item];
    const Look& look = (*looks_)[static_cast<std::size_t>(hit.look)];
    if (look.verbatim) return near_fill || overlap(boxes_[item], {scene, scene});
    const double scale = scale_of(hit.pose);
    const Point p = apply(inverse(hit.pose), scene);
    const double near = reach / scale;
    if (near_fill) return look.fills && distance_to(look.lines, p) <= near;
    if (look.fills && encloses(look.lines, look.style.fill_rule, p)) return true;
    return look.stroke_hit(p, near, 0.5 * look.style.stroke.width / (look.style.stroke.fixed ? scale : 1));
}

std::optional<std::int32_t> HitIndex::item_at(Point scene, double reach) const {
    std::vector<std::size_t> candidates;
    tree_.visit(grown({scene, scene}, reach), [&](std::size_t item) {
        candidates.push_back(item);
        return true;
    });
    std::ranges::sort(candidates, std::greater<>());
    for (const bool near_fill : {false, true})
        for (const std::size_t item : candidates)
            if (hits(item, scene, reach, near_fill)) return picture_->items[item].order;
    return std::nullopt;
}

std::vector<std::int32_t> HitIndex::items_in(const Box& scene) const {
    std::vector<std::int32_t> orders;
    tree_.visit(scene, [&](std::size_t item) {
        if (contains(scene, boxes_[item])) orders.push_back(picture_->items[item].order);
        return true;
    });
    std::ranges::sort(orders);
    return orders;
}

}  // namespace rinceau

#include "editor/gl/seen_items.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

constexpr double largest_scale = 1e12;   // of a pose: beyond it, floats fail
constexpr double least_pixels = 0.5;     // of a radius: smaller shapes get no coarser meshes
constexpr double most_pixels = 1 << 20;  // larger shapes get no finer meshes

/// The least level with 2^level >= zoom * scale, from the square of that.
int level_of(double squared) { return (std::ilogb(squared) + 2) >> 1; }

int bounded_level(const Shape& shape, double squared) {
    const double radius = std::max(shape.radius, shape.fixed_margin);
    if (!(radius > 0)) return 0;
    const int least = level_of(std::pow(least_pixels / radius, 2));
    const int most = level_of(std::pow(most_pixels / radius, 2));
    return std::clamp(level_of(squared), least, most);
}

/// Finds the group of an item by its look and level: few groups a look, in a list.
class Groups {
  public:
    Groups(std::size_t looks, std::vector<SeenGroup>& groups) : first_(looks, -1), groups_(groups) {}

    std::int32_t of(std::int32_t look, const MeshLevel& level) {
        std::int32_t& first = first_[static_cast<std::size_t>(look)];
        for (std::int32_t k = first; k >= 0; k = groups_[static_cast<std::size_t>(k)].next_of_look)
            if (groups_[static_cast<std::size_t>(k)].level == level) return k;
        const auto added = static_cast<std::int32_t>(groups_.size());
        groups_.push_back({.look = look, .level = level, .mesh = nullptr, .count = 0, .next_of_look = first});
        first = added;
        return added;
    }

  private:
    std::vector<std::int32_t> first_;
    std::vector<SeenGroup>& groups_;
};

bool is_flagged(const std::vector<char>* flags, std::int32_t order) {
    if (flags == nullptr) return true;
    return order >= 0 && static_cast<std::size_t>(order) < flags->size() && (*flags)[static_cast<std::size_t>(order)] != 0;
}

bool reaches(const Box& region, Point middle, double radius) {
    return middle.x + radius >= region.low.x && middle.x - radius <= region.high.x && middle.y + radius >= region.low.y &&
           middle.y - radius <= region.high.y;
}

/// The level of the mesh of an outline, if it is seen.
bool outline_level(const Shape& shape, const PictureItem& item, const SeenRequest& request, MeshLevel& level) {
    const double squared = norm(item.pose.linear);
    if (!(squared > 0 && squared < largest_scale * largest_scale)) return false;
    const double scale = std::sqrt(squared);
    const Point middle = apply(item.pose, shape.origin);
    if (!reaches(request.region, middle, shape.radius * scale + shape.fixed_margin)) return false;
    level.level = bounded_level(shape, squared * request.zoom * request.zoom);
    const bool fixed = shape.style.stroke.fixed && paints_stroke(shape.style);
    level.stroke_bucket = fixed ? stroke_bucket(scale) : 0;
    return true;
}

}  // namespace

Box fragment_box(const LookTable& table, const PictureItem& item) {
    const PictureLook& look = table.picture->looks[static_cast<std::size_t>(item.look)];
    const Box& own = table.picture->grammar->terminals[static_cast<std::size_t>(look.terminal)].verbatim_box;
    if (is_empty(own)) return own;
    Box box;
    for (const Point corner : {own.low, own.high, Point{own.low.x, own.high.y}, Point{own.high.x, own.low.y}})
        box = including(box, apply(item.pose, corner));
    return box;
}

SeenItems seen_items(const LookTable& table, const SeenRequest& request) {
    const std::vector<PictureItem>& items = table.picture->items;
    SeenItems seen;
    const std::size_t count = std::min(items.size(), request.most);
    seen.left_out = items.size() - count;
    Groups groups(table.looks.size(), seen.groups);
    for (std::size_t i = 0; i < count; ++i) {
        const PictureItem& item = items[i];
        if (!is_flagged(request.only, item.order)) continue;
        const LookEntry& look = table.looks[static_cast<std::size_t>(item.look)];
        if (look.verbatim) {
            const Box box = fragment_box(table, item);
            if (is_empty(box) || overlap(box, request.region)) seen.items.push_back({static_cast<std::uint32_t>(i), -1});
            continue;
        }
        MeshLevel level;
        if (!look.shape || !outline_level(*look.shape, item, request, level)) continue;
        const std::int32_t group = groups.of(item.look, level);
        ++seen.groups[static_cast<std::size_t>(group)].count;
        seen.items.push_back({static_cast<std::uint32_t>(i), group});
    }
    return seen;
}

}  // namespace rinceau

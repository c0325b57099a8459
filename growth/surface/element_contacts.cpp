#include "growth/surface/element_contacts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>

#include "geometry/convex_hull.h"
#include "geometry/index.h"
#include "growth/surface/laid_overlaps.h"

namespace rinceau {
namespace {

constexpr double touch_share = 0.02;       // of the smaller diagonal: a gap that is none
constexpr double near_share = 0.5;         // of the smaller diagonal
constexpr double support_size = 1.3;       // diagonal of what holds an element, by its own
constexpr std::size_t most_pairs = 40000;  // of triangles that are compared for one pair of elements
constexpr double compact_share = 0.6;      // of the drawing's hull that its elements' hulls cover
constexpr int looks = 64;                  // across and along the drawing for that

using Triangle = std::array<Point, 3>;

Box box_of(const Triangle& triangle) {
    return including(including(including(Box{}, triangle[0]), triangle[1]), triangle[2]);
}

/// Counter-clockwise, in the drawing; those that may meet the box.
std::vector<Triangle> triangles_near(const DrawnElement& element, const Box& box) {
    std::vector<Triangle> triangles;
    for (const ArtLayer& layer : element.art->layers)
        for (const auto& [i, j, k] : layer.triangles) {
            Triangle triangle{apply(element.pose, layer.points[at(i)]), apply(element.pose, layer.points[at(j)]),
                              apply(element.pose, layer.points[at(k)])};
            if (element.pose.mirrored) std::swap(triangle[1], triangle[2]);
            if (overlap(box_of(triangle), box)) triangles.push_back(triangle);
        }
    return triangles;
}

Point nearest_on(Point a, Point b, Point p) {
    const double length = norm(b - a);
    return length > 0 ? a + std::clamp(dot(p - a, b - a) / length, 0.0, 1.0) * (b - a) : a;
}

/// Where two triangles touch.
std::optional<Point> touch(const Triangle& a, const Triangle& b, double gap) {
    if (convex_common_area(a.data(), 3, b.data(), 3) > 0) {
        Box common = box_of(a);
        const Box other = box_of(b);
        common = {{std::max(common.low.x, other.low.x), std::max(common.low.y, other.low.y)},
                  {std::min(common.high.x, other.high.x), std::min(common.high.y, other.high.y)}};
        return center(common);
    }
    for (const auto& [from, to] : {std::pair{&a, &b}, std::pair{&b, &a}})
        for (const Point p : *from)
            for (std::size_t k = 0; k < 3; ++k) {
                const Point q = nearest_on((*to)[k], (*to)[(k + 1) % 3], p);
                if (abs(q - p) <= gap) return 0.5 * (p + q);
            }
    return std::nullopt;
}

Point middle_of_common(const Box& a, const Box& b) {
    return center(Box{{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
                      {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}});
}

double smaller_size(const DrawnElement& a, const DrawnElement& b) { return std::min(diagonal(a.box), diagonal(b.box)); }

std::optional<Point> touch(const DrawnElement& a, const DrawnElement& b) {
    const double gap = touch_share * smaller_size(a, b);
    if (!overlap(grown(a.box, gap), b.box)) return std::nullopt;
    const std::vector<Triangle> of_a = triangles_near(a, grown(b.box, gap)), of_b = triangles_near(b, grown(a.box, gap));
    if (of_a.size() * of_b.size() > most_pairs) {
        if (!scaled_hulls_overlap(a.hull, b.hull, 1 + touch_share)) return std::nullopt;
        return middle_of_common(a.box, b.box);
    }
    for (const Triangle& x : of_a) {
        const Box near = grown(box_of(x), gap);
        for (const Triangle& y : of_b) {
            if (!overlap(near, box_of(y))) continue;
            if (const std::optional<Point> place = touch(x, y, gap)) return place;
        }
    }
    return std::nullopt;
}

/// Distance of the hulls and the place in the middle of it.
struct Gap {
    double width = std::numeric_limits<double>::infinity();
    Point at;
};
Gap gap_between(const DrawnElement& a, const DrawnElement& b) {
    if (scaled_hulls_overlap(a.hull, b.hull, 1)) return {0, middle_of_common(a.box, b.box)};
    Gap gap;
    for (const auto& [from, to] : {std::pair{&a.hull, &b.hull}, std::pair{&b.hull, &a.hull}})
        for (const Point p : *from)
            for (std::size_t k = 0; k < to->size(); ++k) {
                const Point q = nearest_on((*to)[k], (*to)[(k + 1) % to->size()], p);
                if (abs(q - p) < gap.width) gap = {abs(q - p), 0.5 * (p + q)};
            }
    return gap;
}

void set_touching(std::vector<ElementContact>& contacts, int other) {
    for (ElementContact& contact : contacts) contact.touching |= contact.other == other;
}

bool inside(const std::vector<Point>& hull, Point p) {
    for (std::size_t k = 0; k < hull.size(); ++k)
        if (cross(hull[(k + 1) % hull.size()] - hull[k], p - hull[k]) < 0) return false;
    return hull.size() >= 3;
}

/// Calls visit(part) for each connected part of what `chosen` says, by rising first element.
template <class Chosen, class Visit>
void visit_parts(const std::vector<std::vector<ElementContact>>& contacts, Chosen&& chosen, Visit&& visit) {
    std::vector<bool> known(contacts.size(), false);
    for (std::size_t first = 0; first < contacts.size(); ++first) {
        if (known[first] || !chosen(static_cast<int>(first))) continue;
        std::vector<int> part{static_cast<int>(first)};
        known[first] = true;
        for (std::size_t next = 0; next < part.size(); ++next)
            for (const ElementContact& contact : contacts[at(part[next])]) {
                if (!contact.touching || known[at(contact.other)] || !chosen(contact.other)) continue;
                known[at(contact.other)] = true;
                part.push_back(contact.other);
            }
        visit(part);
    }
}

}  // namespace

std::vector<std::vector<ElementContact>> element_contacts(std::span<const DrawnElement> elements) {
    std::vector<std::vector<ElementContact>> contacts(elements.size());
    std::vector<int> order;
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (elements[i].art != nullptr && !is_empty(elements[i].box)) order.push_back(static_cast<int>(i));
    const auto reach = [&](int i) { return near_share * diagonal(elements[at(i)].box); };
    std::ranges::stable_sort(order, {}, [&](int i) { return elements[at(i)].box.low.x - reach(i); });
    std::vector<double> nearest_gap(elements.size(), std::numeric_limits<double>::infinity());
    std::vector<int> nearest(elements.size(), -1);
    const auto join = [&](int i, int other, Point place, double gap) {
        contacts[at(i)].push_back({other, place, gap == 0});
        if (gap >= nearest_gap[at(i)]) return;
        nearest_gap[at(i)] = gap;
        nearest[at(i)] = other;
    };
    std::vector<int> open;  // boxes that the sweep over x has begun and not ended
    for (const int i : order) {
        const double x = elements[at(i)].box.low.x - reach(i);
        std::erase_if(open, [&](int other) { return elements[at(other)].box.high.x + reach(other) < x; });
        for (const int other : open) {
            const DrawnElement &a = elements[at(i)], &b = elements[at(other)];
            const double near = near_share * smaller_size(a, b);
            if (!overlap(grown(a.box, near), b.box)) continue;
            Gap gap;
            if (const std::optional<Point> place = touch(a, b)) {
                gap = {0, *place};
            } else {
                gap = gap_between(a, b);
                gap.width = std::max(gap.width, touch_share * near);
            }
            if (gap.width > near) continue;
            join(i, other, gap.at, gap.width);
            join(other, i, gap.at, gap.width);
        }
        open.push_back(i);
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (nearest[i] < 0 || nearest_gap[i] == 0) continue;
        set_touching(contacts[i], nearest[i]);
        set_touching(contacts[at(nearest[i])], static_cast<int>(i));
    }
    for (auto& of_one : contacts) std::ranges::sort(of_one, {}, &ElementContact::other);
    return contacts;
}

std::vector<int> element_supports(std::span<const DrawnElement> elements,
                                  const std::vector<std::vector<ElementContact>>& contacts) {
    std::vector<int> support(elements.size(), -1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (const ElementContact& contact : contacts[i]) {
            const double size = diagonal(elements[at(contact.other)].box);
            if (!contact.touching || size < support_size * diagonal(elements[i].box) || size >= least) continue;
            least = size;
            support[i] = contact.other;
        }
    }
    return support;
}

ElementTies element_ties(std::span<const DrawnElement> elements) {
    ElementTies ties{is_compact(elements), element_contacts(elements), {}};
    ties.support = element_supports(elements, ties.contacts);
    return ties;
}

bool is_compact(std::span<const DrawnElement> elements) {
    std::vector<Point> points;
    Box all;
    for (const DrawnElement& element : elements) {
        if (element.art == nullptr) continue;
        points.insert(points.end(), element.hull.begin(), element.hull.end());
        all = including(all, element.box);
    }
    const std::vector<Point> hull = convex_hull(points);
    if (is_empty(all) || hull.size() < 3) return false;
    const double across = width(all) / looks, along = height(all) / looks;
    std::vector<bool> covered(at(looks * looks), false);
    const auto place = [&](int x, int y) { return all.low + Point{(x + 0.5) * across, (y + 0.5) * along}; };
    for (const DrawnElement& element : elements) {
        if (element.art == nullptr) continue;
        const auto look = [](double from, double step) { return std::clamp(static_cast<int>(from / step), 0, looks - 1); };
        const Box& box = element.box;
        for (int y = look(box.low.y - all.low.y, along); y <= look(box.high.y - all.low.y, along); ++y)
            for (int x = look(box.low.x - all.low.x, across); x <= look(box.high.x - all.low.x, across); ++x)
                if (inside(element.hull, place(x, y))) covered[at(y * looks + x)] = true;
    }
    int there = 0, filled = 0;
    for (int y = 0; y < looks; ++y)
        for (int x = 0; x < looks; ++x) {
            if (!inside(hull, place(x, y))) continue;
            ++there;
            filled += covered[at(y * looks + x)] ? 1 : 0;
        }
    return filled >= compact_share * there;
}

std::vector<bool> elements_held(const ElementTies& ties, std::vector<double> area) {
    const auto& contacts = ties.contacts;
    // each support is larger than what it holds, so that the way to its end has no circles
    for (std::size_t i = 0; i < area.size(); ++i)
        for (int below = ties.support[i]; below >= 0 && area[i] > 0; below = ties.support[at(below)])
            if (!(area[at(below)] > 0)) area[i] = 0;
    std::vector<int> whole_of(contacts.size(), -1);
    int wholes = 0;
    visit_parts(
        contacts, [](int) { return true; },
        [&](const std::vector<int>& part) {
            for (const int i : part) whole_of[at(i)] = wholes;
            ++wholes;
        });
    std::vector<std::vector<int>> best(at(wholes));
    std::vector<double> best_area(at(wholes), 0);
    visit_parts(
        contacts, [&](int i) { return area[at(i)] > 0; },
        [&](const std::vector<int>& part) {
            const double sum =
                std::accumulate(part.begin(), part.end(), 0.0, [&](double total, int i) { return total + area[at(i)]; });
            const int whole = whole_of[at(part.front())];
            if (sum <= best_area[at(whole)]) return;
            best_area[at(whole)] = sum;
            best[at(whole)] = part;
        });
    std::vector<bool> held(contacts.size(), false);
    for (const std::vector<int>& part : best)
        for (const int i : part) held[at(i)] = true;
    return held;
}

}  // namespace rinceau

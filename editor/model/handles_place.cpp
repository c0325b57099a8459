// Handles that move, turn and scale what is selected.

#include <algorithm>
#include <cmath>

#include "editor/model/handle_parts.h"
#include "lsystem/moving_numbers.h"

namespace rinceau {
namespace {

constexpr double least_sine = 0.2;    ///< between two directions that numbers move to, for both to be of use
constexpr double beyond_box = 0.12;   ///< share of a box by which a handle stands outside it
constexpr double least_turn = 0.5;    ///< of what a number turns by, in its own degrees
constexpr double least_growth = 0.5;  ///< of the logarithm of a scale, in its own
constexpr double least_radial = 0.3;  ///< of a number's motion that leads away from a ring's centre
constexpr double still_share = 1e-7;  ///< of the picture's diagonal: less is no motion

double least_motion(const HandleContext& context) { return still_share * diagonal(context.document.resolved->canvas); }

/// Lengths first: they are what a person means; then angles, then scales.
int preference(const GrammarNumber& number) {
    if (number.kind == NumberKind::length) return 0;
    if (number.kind == NumberKind::other) return 1;
    return number.kind == NumberKind::angle ? 2 : 3;
}

std::vector<GrammarNumber> by_preference(std::vector<GrammarNumber> numbers) {
    std::ranges::stable_sort(numbers, {}, preference);
    return numbers;
}

AttachedPoint attached(const HandleContext& context, const CanvasHandle& handle) {
    return {selected_element(context.selection), handle.level, handle.local};
}

/// One or two numbers of the group that move the point in different directions; none if none moves it.
std::vector<GrammarNumber> that_move(const HandleContext& context, const AttachedPoint& point, const NumberGroup& group) {
    std::vector<GrammarNumber> found;
    Point first;
    for (const GrammarNumber& number : by_preference(group.numbers)) {
        const auto change = context.drag.change(point, number);
        if (!change || abs(change->by) <= least_motion(context)) continue;
        if (found.empty()) {
            first = change->by;
            found.push_back(number);
        } else if (std::abs(cross(first, change->by)) >= least_sine * abs(first) * abs(change->by)) {
            found.push_back(number);
            break;
        }
    }
    return found;
}

/// The number that turns the module most about its own place; nothing if none turns it.
std::optional<GrammarNumber> that_turns(const HandleContext& context, const AttachedPoint& origin) {
    std::optional<GrammarNumber> best;
    double least = 0;
    const PathModule& module = context.selection.path[origin.module];
    for (const GrammarNumber& number : angles_before(*context.document.grammar, context.numbers, module)) {
        const auto change = context.drag.change(origin, number);
        if (!change || std::abs(change->turn) < least_turn * radians(1)) continue;
        const double swing = abs(change->by);
        if (best && swing >= least) continue;
        best = number;
        least = swing;
    }
    return best;
}

std::optional<GrammarNumber> that_scales(const HandleContext& context, const AttachedPoint& origin,
                                         const std::vector<NumberGroup>& groups) {
    for (const NumberGroup& group : groups) {
        if (group.level != origin.module || group.step) continue;
        for (const GrammarNumber& number : group.numbers) {
            if (number.kind != NumberKind::scale) continue;
            const auto change = context.drag.change(origin, number);
            if (change && std::abs(change->growth) * number.value >= least_growth) return number;
        }
    }
    return std::nullopt;
}

CanvasHandle handle_at(const HandleContext& context, HandleKind kind, Point at) {
    CanvasHandle handle;
    handle.kind = kind;
    handle.level = context.selection.level;
    handle.at = at;
    handle.local = apply(inverse(selected_module(context.selection).pose), at);
    return handle;
}

void add_move(const HandleContext& context, const std::vector<NumberGroup>& groups, const Box& box,
              std::vector<CanvasHandle>& handles) {
    CanvasHandle handle = handle_at(context, HandleKind::move, center(box));
    for (const NumberGroup& group : groups) {
        handle.numbers = that_move(context, attached(context, handle), group);
        if (!handle.numbers.empty()) break;
    }
    const bool here = !selected_module(context.selection).address.empty();
    if (here || !handle.numbers.empty()) handles.push_back(std::move(handle));
}

/// Half of a box's extent in a direction.
double half_extent(const Box& box, Point direction) {
    return 0.5 * (width(box) * std::abs(direction.x) + height(box) * std::abs(direction.y));
}

/// On the rim of the ring that the selected module is a part of, or that is selected itself.
void add_radius(const HandleContext& context, const std::vector<CanvasHandle>& counts, std::vector<CanvasHandle>& handles) {
    const Selection& selection = context.selection;
    for (const CanvasHandle& count : counts) {
        if (count.kind != HandleKind::count || !count.track.ring) continue;
        const std::size_t level = count.level + 1;
        if (selection.level != count.level && selection.level != level) continue;
        const PathModule& part = selection.path[level];
        const Box box = context.boxes.box(part.first, part.last);
        const Point out = center(box) - count.track.center;
        if (is_empty(box) || !(abs(out) > 0)) continue;
        const Point direction = out / abs(out);
        CanvasHandle handle;
        handle.kind = HandleKind::radius;
        handle.level = level;
        handle.at = center(box) + (1 + beyond_box) * half_extent(box, direction) * direction;
        handle.local = apply(inverse(part.pose), handle.at);
        const auto groups = moving_numbers(*context.document.grammar, context.numbers, selection.path, level);
        for (const NumberGroup& group : groups) {
            if (group.level != level) continue;
            for (const GrammarNumber& number : by_preference(group.numbers)) {
                const auto change = context.drag.change(attached(context, handle), number);
                if (number.kind == NumberKind::angle || !handle.numbers.empty() || !change) continue;
                const bool outward = std::abs(dot(change->by, direction)) >= least_radial * abs(change->by);
                if (outward && abs(change->by) > least_motion(context)) handle.numbers = {number};
            }
        }
        if (!handle.numbers.empty()) handles.push_back(std::move(handle));
    }
}

/// Above the module, as it heads: turns it, scales it, or both.
void add_turn_and_scale(const HandleContext& context, const std::vector<NumberGroup>& groups,
                        std::vector<CanvasHandle>& handles) {
    const PathModule& module = selected_module(context.selection);
    const Similarity to_own = inverse(module.pose);
    Box own;
    for (int order = module.first; order < module.last; ++order) {
        if (is_empty(context.boxes.own_box(order))) continue;
        for (const Point corner : context.boxes.corners(order)) own = including(own, apply(to_own, corner));
    }
    if (is_empty(own)) return;
    const Point tip{center(own).x, own.high.y + beyond_box * std::max(width(own), height(own))};
    CanvasHandle handle = handle_at(context, HandleKind::branch, apply(module.pose, tip));
    const AttachedPoint origin{selected_element(context.selection), handle.level, {}};
    const auto turns = that_turns(context, origin);
    const auto scales = that_scales(context, origin, groups);
    if (!turns && !scales) return;
    if (turns) handle.numbers.push_back(*turns);
    if (scales) handle.numbers.push_back(*scales);
    if (!scales) handle.kind = HandleKind::turn;
    if (!turns) handle.kind = HandleKind::scale;
    const auto change = context.drag.change(attached(context, handle), handle.numbers.front());
    if (change && abs(change->by) > least_motion(context)) handles.push_back(std::move(handle));
}

}  // namespace

void add_place_handles(const HandleContext& context, std::vector<CanvasHandle>& handles) {
    const PathModule& module = selected_module(context.selection);
    const Box box = context.boxes.box(module.first, module.last);
    if (is_empty(box)) return;
    const std::vector<CanvasHandle> counts = handles;
    if (context.selection.level == 0) return;
    const auto groups =
        moving_numbers(*context.document.grammar, context.numbers, context.selection.path, context.selection.level);
    add_move(context, groups, box, handles);
    add_radius(context, counts, handles);
    add_turn_and_scale(context, groups, handles);
}

}  // namespace rinceau

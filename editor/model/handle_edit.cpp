#include "editor/model/handle_edit.h"

#include <cmath>
#include <utility>

#include "lsystem/drag_point.h"
#include "lsystem/edit_exception.h"
#include "lsystem/number_text.h"
#include "lsystem/set_numbers.h"

namespace rinceau {
namespace {

constexpr double tolerated_pixels = 0.5;
constexpr double snapping_pixels = 4;

std::string changed_text(const std::string& name, double before, double after) {
    constexpr double shown_steps = 1000;
    const auto shown = [](double value) { return number_text(std::round(value * shown_steps) / shown_steps); };
    return name + ' ' + shown(before) + " \u2192 " + shown(after);
}

HandleEdit setting(std::vector<NumberEdit> edits, std::string label, std::string told) {
    return {std::move(label), std::move(told),
            [edits = std::move(edits)](const Grammar& grammar) { return set_numbers(grammar, edits); }};
}

std::optional<HandleEdit> count_edit(const HandleDrag& drag) {
    const CanvasHandle& handle = drag.handle;
    const int count = dragged_count(handle.track, handle.at + (drag.to - drag.from), drag.turned);
    if (count == handle.track.count) return std::nullopt;
    const GrammarNumber& number = handle.numbers.front();
    const std::string& name = drag.only_here && !handle.own_number.empty() ? handle.own_number : number.name;
    const double value = number.value + (count - handle.track.count);  // a rule may draw one more than it counts
    return setting({{.name = name, .value = number_expression(value)}}, "set " + name,
                   changed_text(name, number.value, value));
}

std::optional<HandleEdit> numbers_edit(const Document& document, const HandleDrag& drag, double pixel) {
    const CanvasHandle& handle = drag.handle;
    const PointDrag point_drag(*document.grammar, *document.resolved, document.derive);
    const AttachedPoint point{selected_element(drag.before), handle.level, handle.local};
    const auto values = point_drag.solve(point, handle.numbers, handle.at + (drag.to - drag.from), tolerated_pixels * pixel,
                                         snapping_pixels * pixel);
    if (!values) return std::nullopt;
    std::vector<NumberEdit> edits;
    std::string label;
    std::string told;
    for (std::size_t i = 0; i < values->size(); ++i) {
        const GrammarNumber& number = handle.numbers[i];
        if ((*values)[i] == number.value) continue;
        edits.push_back({.name = number.name, .value = number_expression((*values)[i])});
        label += (label.empty() ? "set " : ", ") + number.name;
        told += (told.empty() ? "" : ", ") + changed_text(number.name, number.value, (*values)[i]);
    }
    if (edits.empty()) return std::nullopt;
    return setting(std::move(edits), std::move(label), std::move(told));
}

/// What the drag does to the module: it goes along, or turns and grows about its own place.
Similarity motion_of(const HandleDrag& drag) {
    const CanvasHandle& handle = drag.handle;
    const Point by = drag.to - drag.from;
    if (handle.kind == HandleKind::move || handle.kind == HandleKind::radius) return translate(by);
    const Point origin = drag.before.path[handle.level].pose.translation;
    Complex linear = (handle.at + by - origin) / (handle.at - origin);
    if (handle.kind == HandleKind::turn) linear = linear / abs(linear);
    if (handle.kind == HandleKind::scale) linear = {abs(linear), 0};
    return translate(origin) * Similarity{linear, {}, false} * translate(-origin);
}

std::optional<HandleEdit> own_edit(const HandleDrag& drag, double pixel) {
    if (drag.to == drag.from) return std::nullopt;
    const Similarity motion = motion_of(drag);
    if (!(abs(motion.linear) > 0)) return std::nullopt;
    const std::string& symbol = drag.before.path[drag.handle.level].symbol;
    return HandleEdit{"move one " + symbol, "only this " + symbol,
                      [path = drag.before.path, level = drag.handle.level, motion, pixel](const Grammar& grammar) {
                          return move_instance(grammar, path, level, motion, tolerated_pixels * pixel);
                      }};
}

}  // namespace

std::optional<HandleEdit> handle_edit(const Document& document, const HandleDrag& drag, double pixel) {
    if (drag.handle.kind == HandleKind::count) return count_edit(drag);
    if (drag.only_here || drag.handle.numbers.empty()) return own_edit(drag, pixel);
    return numbers_edit(document, drag, pixel);
}

}  // namespace rinceau

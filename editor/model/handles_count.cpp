// Handles at the ends of sequences.

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/model/handle_parts.h"
#include "lsystem/numbers.h"
#include "lsystem/set_numbers.h"

namespace rinceau {
namespace {

constexpr int most_parts = 400;        ///< to which a handle can be dragged beyond twice the count
constexpr double closed_share = 0.02;  ///< of a step by which a ring may miss its beginning
constexpr int fewest_in_ring = 3;

bool stands_at(const NumberSlot& slot, const PathModule& module) {
    return slot.in == NumberSlot::In::expression && slot.place.in == ExpressionPlace::In::module &&
           slot.place.string == module.string && slot.place.position == module.position;
}

bool is_written_at(const GrammarNumber& number, const PathModule& module) {
    if (number.alias && stands_at({.place = *number.alias}, module)) return true;
    return std::ranges::any_of(number.slots, [&](const NumberSlot& slot) { return stands_at(slot, module); });
}

/// The count of a rule that counts up stands in its condition.
bool is_limit_of(const GrammarNumber& number, const PathModule& module) {
    return std::ranges::any_of(number.slots, [&](const NumberSlot& slot) {
        return slot.in == NumberSlot::In::expression && slot.place.in == ExpressionPlace::In::condition &&
               slot.place.index == module.production;
    });
}

/// The module's frame from one part to the next; of a single part, from a derivation with one more.
std::optional<Similarity> step_of(const PathModule& module, const GrammarNumber& number, const Document& document,
                                  const Selection& selection, std::size_t level) {
    const std::vector<SequencePart>& parts = module.parts;
    if (parts.size() > 1) return inverse(parts[parts.size() - 2].pose) * parts.back().pose;
    const NumberEdit more{.name = number.name, .how = NumberEdit::How::add, .value = number_expression(1)};
    const Document longer =
        with_grammar(document, set_numbers(*document.grammar, {&more, 1}, {.keep_rings_closed = false}).grammar);
    const auto path = derivation_path(*longer.resolved, {-1, selection.path.back().address}, longer.derive);
    if (path.size() <= level || path[level].parts.size() < 2) return std::nullopt;
    return inverse(path[level].parts[0].pose) * path[level].parts[1].pose;
}

/// The point that a similarity leaves in its place; nothing if there is none nearby.
std::optional<Point> fixed_point(const Similarity& map) {
    if (map.mirrored) return std::nullopt;
    const Complex rest = Complex{1, 0} - map.linear;
    constexpr double least = 1e-9;
    if (abs(rest) < least) return std::nullopt;
    return map.translation / rest;
}

CountTrack track_of(const PathModule& module, const Similarity& step, Point middle) {
    const std::vector<SequencePart>& parts = module.parts;
    CountTrack track;
    track.count = static_cast<int>(parts.size());
    const Point in_part = apply(inverse(parts.back().pose), middle);
    std::vector<Similarity> poses;
    for (const SequencePart& part : parts) poses.push_back(part.pose);
    const std::size_t most = 2 * parts.size() + most_parts;
    while (poses.size() < most) poses.push_back(poses.back() * step);
    for (std::size_t k = 1; k < poses.size(); ++k)
        track.places.push_back(0.5 * (apply(poses[k - 1], in_part) + apply(poses[k], in_part)));
    const Similarity around = parts.back().pose * step * inverse(parts.back().pose);
    const Similarity next = parts.back().pose * step;
    const double gap = abs(apply(next, in_part) - apply(parts.front().pose, in_part));
    const double length = abs(apply(next, in_part) - middle);
    const auto center = fixed_point(around);
    if (center && track.count >= fewest_in_ring && gap <= closed_share * length) {
        track.ring = true;
        track.center = *center;
        track.angle = arg(around.linear);
    }
    return track;
}

const GrammarNumber* number_of_count(const std::vector<GrammarNumber>& numbers, const PathModule& module, bool own) {
    const GrammarNumber* best = nullptr;
    for (const GrammarNumber& number : numbers) {
        if (number.kind != NumberKind::count || !number.parts.empty()) continue;
        if (!is_written_at(number, module) && !is_limit_of(number, module)) continue;
        const bool better =
            best == nullptr || (own ? number.slots.size() < best->slots.size() : number.slots.size() > best->slots.size());
        if (better) best = &number;
    }
    return best;
}

/// The constant itself, for a count that is written as one.
const GrammarNumber& by_its_own_name(const HandleContext& context, const GrammarNumber& number) {
    if (number.constant < 0) return number;
    const std::string& name = context.document.grammar->constants[static_cast<std::size_t>(number.constant)].name;
    const auto found = std::ranges::find(context.numbers, name, &GrammarNumber::name);
    return found == context.numbers.end() ? number : *found;
}

}  // namespace

void add_count_handles(const HandleContext& context, std::vector<CanvasHandle>& handles) {
    const std::vector<PathModule>& path = context.selection.path;
    for (std::size_t level = 1; level < path.size(); ++level) {
        const PathModule& module = path[level];
        if (module.parts.empty()) continue;
        const GrammarNumber* number = number_of_count(context.numbers, module, false);
        if (number == nullptr) continue;
        const Box box = context.boxes.box(module.parts.back().first, module.parts.back().last);
        if (is_empty(box)) continue;
        const auto step = step_of(module, *number, context.document, context.selection, level);
        if (!step) continue;
        CanvasHandle handle;
        handle.kind = HandleKind::count;
        handle.level = level;
        handle.numbers = {by_its_own_name(context, *number)};
        const GrammarNumber* own = number_of_count(context.numbers, module, true);
        if (own != nullptr && own->slots.size() < number->slots.size()) handle.own_number = own->name;
        handle.track = track_of(module, *step, center(box));
        handle.at = handle.track.places[module.parts.size() - 1];
        handles.push_back(std::move(handle));
    }
}

int dragged_count(const CountTrack& track, Point to, double turned) {
    if (track.ring) {
        const double steps = std::round(turned / track.angle);
        return std::max(1, track.count + static_cast<int>(steps));
    }
    double nearest = std::numeric_limits<double>::infinity();
    int count = track.count;
    for (std::size_t k = 0; k < track.places.size(); ++k) {
        const double distance = norm(track.places[k] - to);
        if (distance >= nearest) continue;
        nearest = distance;
        count = static_cast<int>(k) + 1;
    }
    return count;
}

}  // namespace rinceau

#include "editor/model/handles.h"

#include <algorithm>
#include <array>

#include "editor/model/handle_parts.h"

namespace rinceau {
namespace {

bool same_slots(const GrammarNumber& a, const GrammarNumber& b) { return !a.slots.empty() && a.slots == b.slots; }

/// Those that no locked number holds, under its own name or another one for the same place.
std::vector<GrammarNumber> free_numbers(const Document& document) {
    std::vector<GrammarNumber> numbers = grammar_numbers(*document.grammar);
    if (document.locked.empty()) return numbers;
    std::vector<GrammarNumber> locked;
    std::ranges::copy_if(numbers, std::back_inserter(locked),
                         [&](const GrammarNumber& number) { return document.locked.contains(number.name); });
    std::erase_if(numbers, [&](const GrammarNumber& number) {
        return std::ranges::any_of(locked, [&](const GrammarNumber& other) {
            return other.name == number.name || same_slots(other, number) ||
                   std::ranges::find(number.parts, other.name) != number.parts.end();
        });
    });
    return numbers;
}

}  // namespace

const char* handle_name(HandleKind kind) {
    constexpr std::array names{"count", "move", "radius", "turn", "scale", "branch"};
    return names[static_cast<std::size_t>(kind)];
}

std::string handle_label(const CanvasHandle& handle, const Selection& selection) {
    if (handle.numbers.empty()) return selection.path[handle.level].symbol + " here";
    std::string label;
    for (const GrammarNumber& number : handle.numbers) label += (label.empty() ? "" : ", ") + number.name;
    return label;
}

std::vector<CanvasHandle> canvas_handles(const Document& document, const DerivedPicture& picture,
                                         const Selection& selection) {
    const PictureBoxes boxes(picture);
    const PointDrag drag(*document.grammar, *document.resolved, document.derive);
    const HandleContext context{document, selection, boxes, drag, free_numbers(document)};
    std::vector<CanvasHandle> handles;
    add_count_handles(context, handles);
    add_place_handles(context, handles);  // drawn over the counts: they are nearer to what is selected
    return handles;
}

}  // namespace rinceau

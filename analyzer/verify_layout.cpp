#include "analyzer/verify_layout.h"

#include <algorithm>
#include <cmath>

#include "lsystem/interpret.h"

namespace rinceau {

Verification verify_layout(const Grammar& grammar, const WrittenGrammar& written, const Instancing& instancing,
                           double diagonal) {
    Verification check;
    check.elements = static_cast<int>(instancing.instances.size());
    const std::vector<Placement> placements = interpret(grammar);
    const auto drawn = static_cast<int>(placements.size());
    check.unmatched = std::max(0, check.elements - drawn);
    check.surplus = std::max(0, drawn - check.elements);
    double squares = 0;
    for (const Placement& placement : placements) {
        const auto leaf = static_cast<std::size_t>(placement.order);
        if (leaf >= written.element_of_leaf.size()) break;
        const int element = written.element_of_leaf[leaf];
        const Instance& instance = instancing.instances[static_cast<std::size_t>(element)];
        const auto look = static_cast<std::size_t>(instance.look);
        // The parts of looks come first, in their order.
        if (grammar.terminals[static_cast<std::size_t>(placement.terminal)].symbol != written.symbol_of_part[look]) {
            check.faulty.push_back(element);
        }
        const Point centre = (placement.pose * inverse(written.terminal_anchor[look])).translation;
        const double moved = abs(centre - instance.pose.translation) / diagonal;
        check.max_deviation = std::max(check.max_deviation, moved);
        squares += moved * moved;
    }
    std::ranges::sort(check.faulty);
    check.unmatched += static_cast<int>(check.faulty.size());
    check.rms_deviation = drawn > 0 ? std::sqrt(squares / drawn) : 0;
    check.passed = check.unmatched == 0 && check.surplus == 0;
    check.summary = check.passed ? "All " + std::to_string(check.elements) + " elements stand in the regular layout."
                                 : std::to_string(check.unmatched) + " elements are missing, " + std::to_string(check.surplus) +
                                       " are too many.";
    return check;
}

}  // namespace rinceau

#include <algorithm>

#include "analyzer/production_writer.h"

namespace rinceau {

/// k counts down from the number of rows: rows that get longer stand after those that k - 1 makes.
WrittenRule write_family(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    const Child &first = part.children[0], &second = part.children[1];
    const int longest = context.part(first.part).count, difference = longest - context.part(second.part).count;
    const bool falling = difference > 0;
    const int rate = std::abs(difference);
    // Count of the row in terms of k: rate * k + rest.
    const int rest = (falling ? longest : context.part(part.children.back().part).count) - rate * part.count;
    std::string count = rate == 1 ? "k" : std::to_string(rate) + "*k";
    if (rest != 0) count += (rest > 0 ? " + " : " - ") + std::to_string(std::abs(rest));

    Production production = counted_production(context, p);
    production.parameters = {"k"};
    production.condition = parse_expression("k > 0");
    const ModuleTemplate again = command(context.symbol(p), std::string("k-1"));
    if (!falling) production.successor.push_back(again);
    const std::vector<ModuleTemplate> row = bracketed({command(context.symbol(first.part), count)});
    production.successor.insert(production.successor.end(), row.begin(), row.end());
    const Similarity step = inverse(first.pose * context.anchor(first.part)) * second.pose * context.anchor(second.part);
    const double reach = std::max(context.extent(first.part), context.extent(part.children.back().part));
    append_move(production.successor, step,
                move_slack(context, context.turtle_scale(p), abs(step.translation), reach, std::max(1, part.count - 1)));
    if (falling) production.successor.push_back(again);
    return {{std::move(production)}, {}};
}

}  // namespace rinceau

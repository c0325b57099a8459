#include <algorithm>
#include <cmath>

#include "analyzer/production_writer.h"

namespace rinceau {

WrittenRule write_sequence(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    const Rule& rule = context.rule_of(p);
    const Similarity head = context.anchors.gauge_of_rule[static_cast<std::size_t>(part.rule)] * context.anchor(rule.repeated);
    const Similarity step = inverse(head) * rule.step * head;
    Production production = counted_production(context, p);
    production.successor = bracketed({module_of(context, rule.repeated)});
    // A growing chain ends larger than it begins.
    const int count = context.longest_count(part.rule);
    const double growth = std::max(1.0, std::pow(scale_of(step), count - 1));
    append_move(production.successor, step,
                move_slack(context, context.largest_scale_of_rule(part.rule) * growth, abs(step.translation),
                           context.extent(rule.repeated), std::max(1, count - 1)));
    production.successor.push_back(command(context.symbol(p), std::string("m-1")));
    return {{std::move(production)}, {}};
}

}  // namespace rinceau

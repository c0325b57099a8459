#include <cmath>

#include "analyzer/production_writer.h"

namespace rinceau {

WrittenRule write_ring(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    const Rule& rule = context.rule_of(p);
    const std::string count_name = context.symbol(p) + "_count";
    Production production = counted_production(context, p);
    const Similarity first = inverse(context.anchor(p)) * part.children.front().pose * context.anchor(rule.repeated);
    append_placed(context, production.successor, first, rule.repeated, context.turtle_scale(p), true);
    const int turns = static_cast<int>(std::lround(arg(rule.step.linear) * part.count / two_pi));
    const std::string angle = std::to_string(360 * std::abs(turns)) + "/" + count_name;
    production.successor.push_back(command(turns > 0 ? "+" : "-", angle));
    production.successor.push_back(command(context.symbol(p), std::string("m-1")));
    return {{std::move(production)}, {{count_name, number_expression(part.count), ""}}};
}

}  // namespace rinceau

#include <algorithm>
#include <cmath>

#include "analyzer/production_writer.h"

namespace rinceau {

namespace {

/// Slack for one of the steps: what grows from it is as large as the part, and errors add up over the levels.
MoveSlack step_slack(const WritingContext& context, int p, const Similarity& step) {
    const int levels = std::max(1, context.longest_count(context.part(p).rule));
    const double growth = std::max(1.0, std::pow(scale_of(step), levels));
    // All leaves hang on these few numbers, however small they are: digits cost nothing here.
    constexpr int finer = 8;
    return move_slack(context, context.largest_scale_of_rule(context.part(p).rule) * growth, abs(step.translation),
                      context.extent(p), finer * levels);
}

}  // namespace

WrittenRule write_branch(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    const Rule& rule = context.rule_of(p);
    const Similarity turtle = inverse(part.node) * context.anchor(p);  // turtle frame -> node frame
    const double scale = context.largest_scale_of_rule(part.rule);
    const auto append = [&](std::vector<ModuleTemplate>& modules, const Child& child, bool brackets) {
        append_placed(context, modules, inverse(turtle) * child.pose * context.anchor(child.part), child.part, scale,
                      brackets);
    };
    Production grow = counted_production(context, p);
    for (const Child& member : rule.members) append(grow.successor, member, true);
    for (const Similarity& step : rule.steps) {
        std::vector<ModuleTemplate> branch;
        const Similarity move = inverse(turtle) * step * turtle;
        append_move(branch, move, step_slack(context, p, move));
        branch.push_back(command(context.symbol(p), std::string("m-1")));
        branch = bracketed(std::move(branch));
        grow.successor.insert(grow.successor.end(), branch.begin(), branch.end());
    }
    WrittenRule written{{std::move(grow)}, {}};
    if (rule.leaves.empty()) return written;
    Production end;
    end.symbol = context.symbol(p);
    end.parameters = {"m"};
    end.condition = parse_expression("m == 0");
    for (const Child& leaf : rule.leaves) append(end.successor, leaf, rule.leaves.size() > 1);
    written.productions.push_back(std::move(end));
    return written;
}

}  // namespace rinceau

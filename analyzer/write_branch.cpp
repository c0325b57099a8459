#include <algorithm>
#include <cmath>
#include <map>

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

/// What stands as the rule's member k at each depth.
std::map<int, int> parts_by_depth(const WritingContext& context, int rule, std::size_t k) {
    std::map<int, int> parts;
    for (const Part& part : context.rules.parts) {
        if (part.rule == rule && k < part.children.size()) parts[part.count] = part.children[k].part;
    }
    return parts;
}

bool same_at_all_depths(const WritingContext& context, int rule, std::size_t k) {
    const std::map<int, int> parts = parts_by_depth(context, rule, k);
    return std::ranges::all_of(parts, [&](const auto& at) { return at.second == parts.begin()->second; });
}

std::vector<ModuleTemplate> joined(std::vector<ModuleTemplate> first, const std::vector<ModuleTemplate>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
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
    std::vector<Production> by_depth;
    for (std::size_t k = 0; k < rule.members.size(); ++k) {
        if (same_at_all_depths(context, part.rule, k)) {
            append(grow.successor, rule.members[k], true);
            continue;
        }
        const std::string name = context.symbol(p) + "_node" + (k > 0 ? std::to_string(k + 1) : "");
        grow.successor = joined(std::move(grow.successor), bracketed({command(name, std::string("m"))}));
        for (const auto& [depth, at] : parts_by_depth(context, part.rule, k)) {
            Production node;
            node.symbol = name;
            node.parameters = {"m"};
            node.condition = parse_expression("m == " + std::to_string(depth));
            append(node.successor, {at, rule.members[k].pose}, false);
            by_depth.push_back(std::move(node));
        }
    }
    for (const Similarity& step : rule.steps) {
        std::vector<ModuleTemplate> branch;
        const Similarity move = inverse(turtle) * step * turtle;
        append_move(branch, move, step_slack(context, p, move));
        branch.push_back(command(context.symbol(p), std::string("m-1")));
        grow.successor = joined(std::move(grow.successor), bracketed(std::move(branch)));
    }
    WrittenRule written{{std::move(grow)}, {}};
    const auto add_nodes = [&] {
        for (Production& node : by_depth) written.productions.push_back(std::move(node));
    };
    if (rule.leaves.empty()) {
        add_nodes();
        return written;
    }
    Production end;
    end.symbol = context.symbol(p);
    end.parameters = {"m"};
    end.condition = parse_expression("m == 0");
    for (const Child& leaf : rule.leaves) append(end.successor, leaf, rule.leaves.size() > 1);
    written.productions.push_back(std::move(end));
    add_nodes();
    return written;
}

}  // namespace rinceau

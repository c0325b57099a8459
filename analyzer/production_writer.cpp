#include "analyzer/production_writer.h"

#include <algorithm>

#include "analyzer/rule_comment.h"
#include "analyzer/upright_circle.h"

namespace rinceau {

namespace {

constexpr double smallest = 1e-12;  // stands for no scale and no reach at all

}  // namespace

double WritingContext::turtle_scale(int p) const {
    return std::max(anchors.largest_scale[static_cast<std::size_t>(p)], smallest);
}

double WritingContext::largest_scale_of_rule(int rule) const {
    double largest = smallest;
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        if (rules.parts[p].rule == rule) largest = std::max(largest, anchors.largest_scale[p]);
    }
    return largest;
}

int WritingContext::longest_count(int rule) const {
    int longest = 0;
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        if (rules.parts[p].rule == rule && !symbols[p].empty()) longest = std::max(longest, rules.parts[p].count);
    }
    return longest;
}

ModuleTemplate module_of(const WritingContext& context, int part) {
    const std::string& symbol = context.symbol(part);
    const Part& at = context.part(part);
    if (at.look >= 0) return command(symbol);
    const RuleKind kind = context.rule_of(part).kind;
    if (kind == RuleKind::group) return command(symbol);
    const bool round = context.rule_of(part).upright && comes_round(context.rule_of(part), at.count);
    if (kind == RuleKind::ring || round) return command(symbol, symbol + "_count");
    return command(symbol, static_cast<double>(at.count));
}

MoveSlack move_slack(const WritingContext& context, double scale, double advance, double reach, int times) {
    const double length = context.slack / scale / times;
    MoveSlack slack;
    slack.length = length;
    slack.turn = length / std::max(times * advance + reach, smallest);
    slack.spin = length / std::max((times - 1) * advance + reach, smallest);
    slack.scale = slack.spin;
    return slack;
}

Similarity least_turning_gauge(const WritingContext& context, const Similarity& pose, int part) {
    Similarity best;
    if (context.anchors.turnable[static_cast<std::size_t>(part)] == 0) return best;
    constexpr double clearly = 1e-3;  // radians
    constexpr double mirrored = two_pi;
    const Similarity &anchor = context.anchor(part), frame = pose * inverse(anchor);
    const auto effort = [&](const Similarity& gauge) {
        const Similarity turned = frame * gauge * anchor;
        return std::abs(arg(turned.linear)) + (turned.mirrored ? mirrored : 0);
    };
    for (const Similarity& gauge : context.part(part).symmetry.elements) {
        if (effort(gauge) < effort(best) - clearly) best = gauge;
    }
    return best;
}

void append_placed(const WritingContext& context, std::vector<ModuleTemplate>& modules, const Similarity& wanted, int part,
                   double scale, bool brackets) {
    std::vector<ModuleTemplate> placed;
    Similarity pose = wanted;
    if (context.part(part).symmetry.continuous) {  // any angle draws the same
        pose.linear = {scale_of(pose), 0};
        pose.mirrored = false;
        if (abs(pose.translation) > 0) {
            pose.linear = pose.linear * (pose.translation / abs(pose.translation)) * Complex{0, -1};
        }
    }
    const Similarity& anchor = context.anchor(part);
    pose = pose * inverse(anchor) * least_turning_gauge(context, pose, part) * anchor;
    append_move(placed, pose,
                move_slack(context, scale, abs(pose.translation), context.extent(part) * scale_of(pose), 1));
    placed.push_back(module_of(context, part));
    if (brackets) placed = bracketed(std::move(placed));
    modules.insert(modules.end(), placed.begin(), placed.end());
}

Production counted_production(const WritingContext& context, int part) {
    Production production;
    production.symbol = context.symbol(part);
    production.comment =
        rule_comment(context.rules, context.part(part), context.symbols, context.uses);
    production.parameters = {"m"};
    production.condition = parse_expression("m > 0");
    return production;
}

WrittenRule write_rule(const WritingContext& context, int part) {
    switch (context.rule_of(part).kind) {
        case RuleKind::group:
            return write_group(context, part);
        case RuleKind::ring:
            return write_ring(context, part);
        case RuleKind::linear:
            return context.rule_of(part).upright ? write_upright(context, part) : write_linear(context, part);
        case RuleKind::branch:
            return write_branch(context, part);
        case RuleKind::family:
            return write_family(context, part);
        case RuleKind::spiral:
            return write_spiral(context, part);
        case RuleKind::sequence:
            break;
    }
    return write_sequence(context, part);
}

}  // namespace rinceau

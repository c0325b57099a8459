#include <cmath>

#include "analyzer/production_writer.h"
#include "analyzer/upright_circle.h"

namespace rinceau {

namespace {

std::string text(double value) { return to_text(number_expression(value)); }

/// A turn by `constant` degrees and `per_repetition` for each that is left; a positive one is written "+".
ModuleTemplate growing_turn(double constant, bool clockwise, const std::string& per_repetition) {
    const std::string growing = per_repetition + "*m";
    if (constant == 0) return command(clockwise ? "-" : "+", growing);
    return command("+", text(constant) + (clockwise ? " - " : " + ") + growing);
}

}  // namespace

/// The turtle stands in the middle, facing the place of each member in turn; at each place it turns back.
WrittenRule write_upright(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    const Rule& rule = context.rule_of(p);
    const bool ring = comes_round(rule, part.count);
    const Similarity& head = context.anchor(rule.repeated);
    const Similarity at = inverse(context.anchor(p)) * part.children.front().pose;
    const double radius = abs(at.translation);
    const MoveSlack slack = move_slack(context, context.turtle_scale(p), radius, context.extent(rule.repeated), part.count);
    const double sense = context.anchor(p).mirrored ? -1 : 1;
    const double turn = ring ? std::copysign(360.0 / part.count, sense * rule.turn_change)
                             : tidy(degrees(sense * rule.turn_change), degrees(slack.turn));
    const bool clockwise = turn < 0;
    const std::string count_name = context.symbol(p) + "_count";
    const std::string step = ring ? "360/" + count_name : text(std::abs(turn));

    // The first member, in the least turned of its poses that look the same, and the turn that brings the turtle upright
    // there.
    const Similarity gauge = least_turning_gauge(context, at * head, rule.repeated);
    const Similarity member = at * gauge * head;
    const double upright = degrees(arg(member.linear)) - (ring ? 0 : part.count * turn);
    const MoveSlack once = move_slack(context, context.turtle_scale(p), 0, context.extent(rule.repeated), 1);
    const double constant = tidy(std::remainder(upright, 360), degrees(once.spin));
    Production production = counted_production(context, p);
    std::vector<ModuleTemplate> placed;
    placed.push_back(command("f", tidy(radius, slack.length)));
    placed.push_back(growing_turn(constant, clockwise, step));
    const Similarity turtle{polar(1, arg(member.linear)), at.translation, false};
    append_placed(context, placed, inverse(turtle) * member, rule.repeated, context.turtle_scale(p), false);
    placed = bracketed(std::move(placed));
    production.successor.insert(production.successor.end(), placed.begin(), placed.end());
    production.successor.push_back(command(clockwise ? "-" : "+", step));
    production.successor.push_back(command(context.symbol(p), std::string("m-1")));
    WrittenRule written{{std::move(production)}, {}};
    if (ring) written.constants = {{count_name, number_expression(part.count), ""}};
    return written;
}

}  // namespace rinceau

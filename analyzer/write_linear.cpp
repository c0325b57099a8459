#include <cmath>

#include "analyzer/production_writer.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

/// An angle in degrees that is `at_first` for m = count and changes by -`change` with every m: t0 + tDelta m.
std::string growing_angle(double at_first, double change, int count, double slack) {
    const double fine = tidy(change, slack / count);
    const double start = tidy(at_first - change * count, slack);
    const std::string product = to_text(number_expression(std::abs(fine))) + "*m";
    return to_text(number_expression(start)) + (fine < 0 ? " - " : " + ") + product;
}

}  // namespace

/// m counts down from the number of repetitions.
WrittenRule write_linear(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    const Rule& rule = context.rule_of(p);
    // Turned and scaled like the member's turtle but about the member's own origin, so that alpha and beta stay linear.
    const Similarity& head = context.anchor(rule.repeated);
    const Similarity upright{head.linear, {}, head.mirrored};
    const TurtleStep first = to_turtle_step(inverse(upright) * rule.step * upright);
    const double sense = upright.mirrored ? -1 : 1;
    const double turn_change = -degrees(sense * rule.turn_change), spin_change = -degrees(sense * rule.spin_change);
    Production production = counted_production(context, p);
    std::vector<ModuleTemplate>& body = production.successor;
    append_placed(context, body, inverse(upright) * head, rule.repeated, context.turtle_scale(p), true);
    const MoveSlack slack =
        move_slack(context, context.turtle_scale(p), first.advance, context.extent(rule.repeated), part.count);
    body.push_back(command("+", growing_angle(degrees(first.turn), turn_change, part.count, degrees(slack.turn))));
    body.push_back(command("f", tidy(first.advance, slack.length)));
    if (std::abs(first.scale - 1) > slack.scale) body.push_back(command("*", tidy(first.scale, slack.scale)));
    body.push_back(command("+", growing_angle(degrees(first.spin), spin_change, part.count, degrees(slack.spin))));
    body.push_back(command(context.symbol(p), std::string("m-1")));
    return {{std::move(production)}, {}};
}

}  // namespace rinceau

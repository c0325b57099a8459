#include <algorithm>
#include <cmath>

#include "analyzer/production_writer.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

std::string text(double value) { return to_text(number_expression(value)); }

/// A value that is `at_first` for m = count and changes by -`change` with every m: t0 + tDelta m.
std::string growing(double at_first, double change, int count, double slack) {
    const double fine = tidy(change, slack / count);
    const double start = tidy(at_first - change * count, slack);
    if (fine == 0) return text(tidy(at_first, slack));
    const std::string product = text(std::abs(fine)) + "*m";
    if (start == 0) return (fine < 0 ? "-" : "") + product;
    return text(start) + (fine < 0 ? " - " : " + ") + product;
}

std::string growing_advance(const Rule& rule, double at_first, double unit, int count, double slack) {
    if (rule.advance_factor == 1) return growing(at_first, -rule.advance_change * unit, count, slack);
    // d q^(count - m)
    const double last = at_first * std::pow(rule.advance_factor, count);
    const double longest = std::max(at_first, last);
    return text(tidy(last, slack * std::min(1.0, last / longest))) + "*" +
           text(tidy(1 / rule.advance_factor, slack / (longest * count))) + "^m";
}

void append_growing_turn(std::vector<ModuleTemplate>& body, double at_first, double change, int count, double slack) {
    if (tidy(change, slack / count) == 0) {
        append_turn(body, radians(at_first), radians(slack));
    } else {
        body.push_back(command("+", growing(at_first, change, count, slack)));
    }
}

}  // namespace

/// m counts down from the number of repetitions.
WrittenRule write_linear(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    const Rule& rule = context.rule_of(p);
    // Turned and scaled like the member's turtle but about the member's seat, so that alpha and beta stay linear.
    const Similarity& head = context.anchor(rule.repeated);
    const Similarity upright{head.linear, {}, head.mirrored};
    const TurtleStep first = to_turtle_step(inverse(upright) * rule.step * upright);
    const double sense = upright.mirrored ? -1 : 1;
    const double turn_change = -degrees(sense * rule.turn_change), spin_change = -degrees(sense * rule.spin_change);
    Production production = counted_production(context, p);
    std::vector<ModuleTemplate>& body = production.successor;
    const double largest = std::max(1.0, 1 + (part.count - 1) * rule.size_change);
    std::vector<ModuleTemplate> member;
    if (rule.size_change != 0) {
        const double fine = context.slack / context.turtle_scale(p) / context.extent(rule.repeated);
        member.push_back(command("*", growing(1, -rule.size_change, part.count, fine)));
    }
    append_placed(context, member, inverse(upright) * translate(-rule.seat) * head, rule.repeated,
                  context.turtle_scale(p) * largest, false);
    member = bracketed(std::move(member));
    body.insert(body.end(), member.begin(), member.end());
    const MoveSlack slack =
        move_slack(context, context.turtle_scale(p), first.advance, context.extent(rule.repeated), part.count);
    append_growing_turn(body, degrees(first.turn), turn_change, part.count, degrees(slack.turn));
    body.push_back(command("f", growing_advance(rule, first.advance, 1 / scale_of(upright), part.count, slack.length)));
    if (std::abs(first.scale - 1) > slack.scale) body.push_back(command("*", tidy(first.scale, slack.scale)));
    append_growing_turn(body, degrees(first.spin), spin_change, part.count, degrees(slack.spin));
    body.push_back(command(context.symbol(p), std::string("m-1")));
    return {{std::move(production)}, {}};
}

}  // namespace rinceau

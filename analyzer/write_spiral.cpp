#include <algorithm>
#include <cmath>

#include "analyzer/production_writer.h"

namespace rinceau {

namespace {

std::string text(double value) { return to_text(number_expression(value)); }

/// The index of member k in terms of the m that counts down to 1: m, (m - 1), (m + 0.5).
std::string index_text(const SpiralLaw& law, int count) {
    constexpr double fine = 1e-9;
    const double offset = tidy(law.direction > 0 ? law.start - 1 : law.start - count, fine);
    if (offset == 0) return "m";
    return offset > 0 ? "(m + " + text(offset) + ")" : "(m - " + text(-offset) + ")";
}

std::string power_text(const std::string& index, double power) { return power == 1 ? index : index + "^" + text(power); }

/// Slack for numbers that are multiplied with the law's powers.
struct SpiralSlack {
    double reach = 0, power = 0, angle = 0, size = 0;
};

SpiralSlack spiral_slack(const WritingContext& context, int p, double last) {
    const SpiralLaw& law = context.rule_of(p).spiral;
    const double length = context.slack / context.turtle_scale(p);
    const double farthest = std::max(std::pow(last, law.power), 1.0);
    SpiralSlack slack;
    slack.reach = length / farthest;
    slack.power = length / (law.reach * farthest * std::max(1.0, std::log(std::max(1.0, last))));
    slack.angle = length / (law.reach * farthest * std::max(1.0, last));
    slack.size = length / context.extent(context.rule_of(p).repeated);
    return slack;
}

std::string size_text(const SpiralLaw& law, const std::string& index, double unit, double last, double slack) {
    const double size = tidy(law.size * unit, slack);
    if (law.size_change == 0) return text(size);
    const double change = tidy(law.size_change * unit, slack / std::max(1.0, std::pow(last, law.size_power)));
    std::string grown = text(std::abs(change)) + "*" + power_text(index, law.size_power);
    if (size == 0) return grown;
    return text(size) + (change < 0 ? " - " : " + ") + grown;
}

}  // namespace

WrittenRule write_spiral(const WritingContext& context, int p) {
    const Part& part = context.part(p);
    SpiralLaw law = context.rule_of(p).spiral;
    const int member = context.rule_of(p).repeated;
    const Similarity& head = context.anchor(member);
    const double last = std::max(law.start, spiral_index(law, part.count - 1));
    const SpiralSlack slack = spiral_slack(context, p, last);
    law.power = tidy(law.power, slack.power);
    const std::string index = index_text(law, part.count);

    std::vector<ModuleTemplate> placed;
    const std::string turn = text(tidy(std::abs(degrees(law.angle)), degrees(slack.angle))) + "*" + index;
    placed.push_back(command(law.angle < 0 ? "-" : "+", turn));
    placed.push_back(command("f", text(tidy(law.reach, slack.reach)) + "*" + power_text(index, law.power)));
    if (law.upright && !context.part(member).symmetry.continuous) placed.push_back(command(law.angle < 0 ? "+" : "-", turn));
    const double unit = scale_of(head);
    const std::string size = size_text(law, index, unit, last, slack.size);
    if (size != "1") placed.push_back(command("*", size));
    const Similarity seat = rotate(law.bearing) * scale_by(1 / unit) * translate(-law.seat) * head;
    append_placed(context, placed, seat, member, context.turtle_scale(p), false);

    Production production = counted_production(context, p);
    production.successor = bracketed(std::move(placed));
    // The index rises with m: outward runs from 1 up, so what is further in comes first.
    const auto place = law.direction > 0 ? production.successor.begin() : production.successor.end();
    production.successor.insert(place, command(context.symbol(p), std::string("m-1")));
    return {{std::move(production)}, {}};
}

}  // namespace rinceau

#include "how_to/knockout_rule.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analyzer/analyze.h"
#include "analyzer/instancing.h"
#include "analyzer/module_writer.h"
#include "geometry/angle.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

namespace rinceau {

namespace {

constexpr int fewest_rounds = 3;
constexpr double places_of_diagonal = 5e-5;  // a tenth of a pixel at 1,000 pixels and less than the proof allows

/// Levels across the way of growth: places as (across, along) in a frame whose y axis is that way.
using Level = std::vector<Point>;

/// One level for each value of y; nothing if they are not 1, 2, 4, .. places at equal distances.
std::vector<Level> levels_of(std::vector<Point> places, double tolerance) {
    std::ranges::sort(places, {}, &Point::y);
    std::vector<Level> levels;
    for (const Point place : places) {
        if (levels.empty() || place.y - levels.back().front().y > 2 * tolerance) levels.emplace_back();
        levels.back().push_back(place);
    }
    for (std::size_t k = 0; k < levels.size(); ++k) {
        if (levels[k].size() != std::size_t{1} << k) return {};
        std::ranges::sort(levels[k], {}, &Point::x);
    }
    return levels;
}

/// The plan whose final stands first along +y; `frame` takes such places to the scene.
std::optional<Knockout> knockout_along(const std::vector<Point>& places, const Similarity& frame, double tolerance) {
    const std::vector<Level> levels = levels_of(places, tolerance);
    const int rounds = static_cast<int>(levels.size()) - 1;
    if (rounds < fewest_rounds) return std::nullopt;
    // Three numbers say it all: they are measured where they are largest, and then hold for every place.
    const Level& last = levels.back();
    const double pairs = static_cast<double>(last.size()) - 1;
    const Point final = levels.front().front();
    const double way = (last.front().y - final.y) / rounds;
    const double half = (last.back().x - last.front().x) / (2 * pairs);
    for (int k = 0; k <= rounds; ++k) {
        const Level& level = levels[static_cast<std::size_t>(k)];
        const double distance = 2 * half * std::exp2(rounds - k);
        for (std::size_t i = 0; i < level.size(); ++i) {
            const double across = (static_cast<double>(i) - (static_cast<double>(level.size()) - 1) / 2) * distance;
            if (abs(level[i] - (final + Point{across, k * way})) > tolerance) return std::nullopt;
        }
    }
    return Knockout{rounds, way, half, frame * translate(final)};
}

/// The elements' common pose but for its place; nothing if they are not copies that are moved only: turned or scaled, an
/// outline of that size would be off by more than the tolerance.
std::optional<Similarity> common_pose(const std::vector<Placement>& placements, double size, double tolerance) {
    const Placement& first = placements.front();
    for (const Placement& other : placements) {
        const bool same = other.terminal == first.terminal && other.style == first.style && other.layer == first.layer;
        const double off = size * abs(other.pose.linear - first.pose.linear);
        const bool moved = other.pose.mirrored == first.pose.mirrored && off <= tolerance;
        if (!same || !moved) return std::nullopt;
    }
    return Similarity{first.pose.linear, {}, first.pose.mirrored};
}

void append(std::vector<ModuleTemplate>& modules, std::vector<ModuleTemplate> more) {
    modules.insert(modules.end(), more.begin(), more.end());
}

/// [f(way) +(90) f(half*2^(m-1)) -(90) Knockout(m-1)]: to the left for a sign of 1, to the right for -1.
std::vector<ModuleTemplate> pair_member(const Knockout& plan, int sign, const MoveSlack& slack) {
    std::vector<ModuleTemplate> modules;
    append_move(modules, translate({0, plan.way}), slack);
    append_turn(modules, sign * radians(90), slack.turn);
    const std::string half = to_text(number_expression(tidy(plan.half, slack.length)));
    modules.push_back(command("f", half + "*2^(m-1)"));
    append_turn(modules, -sign * radians(90), slack.turn);
    modules.push_back(command("Knockout", std::string("m-1")));
    return bracketed(std::move(modules));
}

Production production(const std::string& condition, std::vector<ModuleTemplate> successor) {
    Production made;
    made.symbol = "Knockout";
    made.parameters = {"m"};
    made.condition = parse_expression(condition);
    made.successor = std::move(successor);
    return made;
}

/// The flat list's terminals with the plan's rule in the place of its axiom.
Grammar written(Grammar flat, const Knockout& plan, const Similarity& pose, double slack_length) {
    // The numbers of the rule act in every round, the half even doubled.
    const MoveSlack slack{.length = slack_length / std::exp2(plan.rounds), .turn = 0, .spin = 0, .scale = 0};
    std::vector<ModuleTemplate> element;
    append_move(element, inverse(Similarity{plan.final.linear, {}, false}) * pose, {});
    element.push_back(command(flat.terminals.front().symbol));
    const std::vector<ModuleTemplate> node = bracketed(std::move(element));

    std::vector<ModuleTemplate> grow = node;
    append(grow, pair_member(plan, 1, slack));
    append(grow, pair_member(plan, -1, slack));
    Production rule = production("m > 0", std::move(grow));
    rule.comment = " a knockout of " + std::to_string(plan.rounds) + " rounds";
    flat.productions = {std::move(rule), production("m == 0", node)};
    flat.axiom.clear();
    append_move(flat.axiom, plan.final, {});
    flat.axiom.push_back(command("Knockout", plan.rounds));
    return flat;
}

}  // namespace

std::optional<Knockout> find_knockout(std::span<const Point> places, double tolerance) {
    // The final may stand on any side; a plan that grows up is one of another frame.
    for (const double angle : {0.0, radians(90), radians(180), radians(-90)}) {
        const Similarity frame = rotate(angle);
        std::vector<Point> seen;
        for (const Point place : places) seen.push_back(apply(inverse(frame), place));
        if (const std::optional<Knockout> plan = knockout_along(seen, frame, tolerance)) return plan;
    }
    return std::nullopt;
}

std::optional<Grammar> knockout_grammar(const Scene& scene) {
    const double tolerance = places_of_diagonal * drawing_diagonal(scene);
    Grammar flat = flat_grammar(scene, group_similar_elements(scene));
    const std::vector<Placement> placements = interpret(flat);
    if (placements.empty() || flat.terminals.size() != 1) return std::nullopt;
    const std::optional<Similarity> pose =
        common_pose(placements, diagonal(bounds(flat.terminals.front().paths)), tolerance);
    if (!pose) return std::nullopt;
    std::vector<Point> places;
    for (const Placement& placement : placements) places.push_back(placement.pose.translation);
    const std::optional<Knockout> plan = find_knockout(places, tolerance);
    if (!plan) return std::nullopt;
    const Grammar grammar = parse_grammar(to_text(written(std::move(flat), *plan, *pose, tolerance)));
    if (!verify(grammar, scene).passed) return std::nullopt;
    return grammar;
}

}  // namespace rinceau

#include "analyzer/rule_comment.h"

#include <algorithm>
#include <cmath>

#include "analyzer/module_writer.h"
#include "analyzer/upright_circle.h"
#include "lsystem/number_text.h"

namespace rinceau {

std::string kind_name(RuleKind kind) {
    switch (kind) {
        case RuleKind::sequence:
            return "sequence";
        case RuleKind::ring:
            return "ring";
        case RuleKind::linear:
            return "linear";
        case RuleKind::family:
            return "family";
        case RuleKind::spiral:
            return "spiral";
        case RuleKind::group:
            return "group";
        case RuleKind::branch:
            return "branching";
    }
    return "";
}

namespace {

/// What a person calls a sequence.
enum class Figure { row, column, diagonal, grid, taper, zigzag, arc, spiral, fan, nest, pair, mirror_pair };

const Rule& rule_of(const RuleSet& rules, const Part& part) { return rules.rules[static_cast<std::size_t>(part.rule)]; }
const RuleUse& use_of(const Part& part, const std::vector<RuleUse>& uses) {
    return uses[static_cast<std::size_t>(part.rule)];
}

/// From the first member to the second, in the scene, where the rule is used first.
Point first_step(const RuleSet& rules, const RuleUse& use) {
    const Item& item = rules.items[static_cast<std::size_t>(use.item)];
    const Part& part = rules.parts[static_cast<std::size_t>(item.part)];
    if (part.children.size() < 2) return {};
    return apply(item.pose, part.children[1].pose.translation) - apply(item.pose, part.children[0].pose.translation);
}

Figure direction_of(Point step) {
    constexpr double level = radians(35);  // what rises less is level; 10 degrees are left for what is neither
    const double rise = std::atan2(std::abs(step.y), std::abs(step.x));
    return rise <= level ? Figure::row : rise >= pi / 2 - level ? Figure::column : Figure::diagonal;
}

struct Changes {
    bool moves, turns, grows;
};

/// What a person sees of a step that is made `count` - 1 times.
Changes changes_of(const Similarity& step, int count) {
    constexpr double moved = 1e-4;  // sizes
    constexpr double turned = radians(1), grown = 0.01;  // from the first to the last
    const int steps = std::max(1, count - 1);
    return {abs(step.translation) > moved, steps * std::abs(arg(step.linear)) > turned,
            steps * std::abs(std::log(scale_of(step))) > grown};
}

bool is_straight(const Rule& rule, int count) {
    const Changes changes = changes_of(rule.step, count);
    return rule.kind == RuleKind::sequence && changes.moves && !changes.turns && !changes.grows && !rule.step.mirrored;
}

/// A row of columns or a column of rows, neither being a grid itself.
bool is_grid(const RuleSet& rules, const Rule& rule, const std::vector<RuleUse>& uses, Figure direction) {
    const Part& below = rules.parts[static_cast<std::size_t>(rule.repeated)];
    if (below.rule < 0 || use_of(below, uses).item < 0) return false;
    if (!is_straight(rule_of(rules, below), use_of(below, uses).most)) return false;
    const Part& inner = rules.parts[static_cast<std::size_t>(rule_of(rules, below).repeated)];
    const Figure inward = direction_of(first_step(rules, use_of(below, uses)));
    if (inward == direction) return false;
    return !(inner.rule >= 0 && use_of(inner, uses).item >= 0 && is_straight(rule_of(rules, inner), use_of(inner, uses).most) &&
             direction_of(first_step(rules, use_of(inner, uses))) != inward);
}

/// Do the members turn about a point within themselves?
bool turns_in_place(const RuleSet& rules, const Rule& rule) {
    const Complex about = Complex{1, 0} - rule.step.linear;
    const double to_pivot = abs(rule.step.translation) / std::max(abs(about), 1e-12);
    return to_pivot <= rules.parts[static_cast<std::size_t>(rule.repeated)].radius;
}

Figure figure_of(const RuleSet& rules, const Part& part, const std::vector<RuleUse>& uses) {
    const Rule& rule = rule_of(rules, part);
    const RuleUse& use = use_of(part, uses);
    const Changes changes = changes_of(rule.step, use.most);
    if (rule.step.mirrored) return use.most == 2 ? Figure::mirror_pair : Figure::zigzag;
    if (changes.turns && use.most == 2) return Figure::pair;
    if (changes.turns && changes.grows) return Figure::spiral;
    if (changes.turns) return turns_in_place(rules, rule) ? Figure::fan : Figure::arc;
    if (!changes.moves) return Figure::nest;
    if (changes.grows) return Figure::taper;
    const Figure direction = direction_of(first_step(rules, use));
    return is_grid(rules, rule, uses, direction) ? Figure::grid : direction;
}

struct FigureWords {
    const char* name;
    const char* phrase;
};

FigureWords words_of(Figure figure) {
    switch (figure) {
        case Figure::row:
            return {"Row", "a row of "};
        case Figure::column:
            return {"Column", "a column of "};
        case Figure::diagonal:
            return {"Diagonal", "a slanting row of "};
        case Figure::grid:
            return {"Grid", "a grid of "};
        case Figure::taper:
            return {"Taper", "a tapering row of "};
        case Figure::zigzag:
            return {"Zigzag", "a zigzag of "};
        case Figure::arc:
            return {"Arc", "an arc of "};
        case Figure::spiral:
            return {"Spiral", "a spiral of "};
        case Figure::fan:
            return {"Fan", "a fan of "};
        case Figure::nest:
            return {"Nest", "a nest of "};
        case Figure::pair:
            return {"Pair", "a pair of "};
        case Figure::mirror_pair:
            return {"Pair", "a mirrored pair of "};
    }
    return {"", ""};
}

/// Three digits are enough for a reader.
std::string short_number(double value) {
    constexpr double reading = 2e-3;
    return number_text(tidy(value, reading * std::abs(value)));
}

std::string count_text(const RuleUse& use) {
    const std::string most = std::to_string(use.most);
    return use.fewest < use.most ? std::to_string(use.fewest) + " to " + most : most;
}

/// ", 12 apart" or ", turning by 8.5 degrees, each 0.993 times as large": what is not plain from the figure's word.
std::string sequence_numbers(const RuleSet& rules, const Part& part, const RuleUse& use, Figure figure) {
    const Similarity& step = rule_of(rules, part).step;
    const Changes changes = changes_of(step, use.most);
    std::string text;
    const bool straight = !changes.turns && !changes.grows && !step.mirrored;
    if (straight && changes.moves && use.even) text += ", " + short_number(abs(first_step(rules, use))) + " apart";
    if (figure == Figure::zigzag) text += ", every other one mirrored";
    if (changes.turns && !step.mirrored && figure != Figure::pair) {
        text += ", turning by " + short_number(std::abs(degrees(arg(step.linear)))) + " degrees";
    }
    if (changes.grows) text += ", each " + short_number(scale_of(step)) + " times as large";
    return text;
}

/// "A, 2 B and C together"; of many kinds, "A, 2 B, C, D, E and 130 more together"
std::string group_comment(const Part& part, const std::vector<std::string>& names) {
    std::vector<std::pair<std::string, int>> members;
    for (const Child& child : part.children) {
        const std::string& name = names[static_cast<std::size_t>(child.part)];
        const auto known = std::ranges::find(members, name, &std::pair<std::string, int>::first);
        known == members.end() ? members.emplace_back(name, 1).second : ++known->second;
    }
    constexpr std::size_t most_kinds = 8, shown_of_many = 5;
    const bool many = members.size() > most_kinds;
    const std::size_t shown = many ? shown_of_many : members.size();
    auto unnamed = static_cast<int>(part.children.size());
    std::string text;
    for (std::size_t k = 0; k < shown; ++k) {
        if (k > 0) text += k + 1 == shown && !many ? " and " : ", ";
        if (members[k].second > 1) text += std::to_string(members[k].second) + " ";
        text += members[k].first;
        unnamed -= members[k].second;
    }
    return text + (many ? " and " + std::to_string(unnamed) + " more" : "") + " together";
}

/// Two halves, if the first two children are one part and its mirror image, written from one point.
bool is_mirrored_whole(const Part& part) {
    if (!part.pivot || part.children.size() < 2) return false;
    return part.children[0].part == part.children[1].part && part.children[0].pose.mirrored != part.children[1].pose.mirrored;
}

/// "two mirror halves A" or "two mirror halves A with B and C"
std::string halves_comment(const Part& part, const std::vector<std::string>& names) {
    std::string text = "two mirror halves " + names[static_cast<std::size_t>(part.children.front().part)];
    if (part.children.size() == 2) return text;
    Part rest;
    rest.children.assign(part.children.begin() + 2, part.children.end());
    const std::string between = group_comment(rest, names);
    return text + " with " + between.substr(0, between.rfind(" together"));
}

std::string ring_comment(const RuleSet& rules, const Part& part, const std::string& what, const RuleUse& use) {
    const Item& item = rules.items[static_cast<std::size_t>(use.item)];
    if (part.pivot) return "the whole: " + count_text(use) + " sectors " + what + " about one centre";
    const std::string text = "a ring of " + count_text(use) + " " + what;
    // The production begins at the first member of a group, not at its middle: one radius would not be the other.
    const Child& first = part.children.front();
    const double radius = abs(first.pose.translation);
    const bool plain = rules.parts[static_cast<std::size_t>(first.part)].look >= 0 && radius > 1e-3 * part.radius;
    return use.even && plain ? text + ", radius " + short_number(scale_of(item.pose) * radius) : text;
}

/// "a tree of A, in which 2 grow from each, 10 levels deep"
std::string branch_comment(const RuleSet& rules, const Part& part, const std::vector<std::string>& names,
                           const RuleUse& use) {
    const Rule& rule = rule_of(rules, part);
    const std::string copies = std::to_string(rule.steps.size()), levels = count_text(use) + " levels deep";
    if (rule.members.empty()) return "made of " + copies + " small copies of itself, " + levels;
    std::string text = "a tree of ";
    for (std::size_t k = 0; k < rule.members.size(); ++k) {
        if (k > 0) text += k + 1 == rule.members.size() ? " with " : ", ";
        text += names[static_cast<std::size_t>(part.children[k].part)];
    }
    return text + ": " + copies + " grow from each, " + levels;
}

bool bends(const Rule& rule) { return rule.turn_change != 0 || rule.spin_change != 0; }

/// "a row of 9 A, each step longer than the one before"
std::string linear_comment(const Rule& rule, const std::string& what) {
    std::string text = bends(rule) ? "a curve of " + what + ", turning more and more" : "a row of " + what;
    const bool longer = rule.advance_change > 0 || rule.advance_factor > 1;
    if (rule.advance_change != 0) text += std::string(", each step ") + (longer ? "longer" : "shorter") + " by the same";
    if (rule.advance_factor != 1) text += ", each step " + short_number(rule.advance_factor) + " times as long";
    if (rule.size_change != 0) text += std::string(", each ") + (rule.size_change > 0 ? "larger" : "smaller") + " by the same";
    return text;
}

/// "a ring of 12 A, all facing one way, radius 180"
std::string upright_comment(const RuleSet& rules, const Part& part, const std::string& what, const RuleUse& use) {
    const Rule& rule = rule_of(rules, part);
    const bool ring = comes_round(rule, part.count);
    const Similarity& pose = rules.items[static_cast<std::size_t>(use.item)].pose;
    const double radius = abs(circle_centre(rule)) * scale_of(pose) * scale_of(part.children.front().pose);
    const std::string text =
        std::string(ring ? "a ring of " : "an arc of ") + std::to_string(part.count) + " " + what + ", all facing one way";
    if (!ring) return text + ", " + short_number(std::abs(degrees(rule.turn_change))) + " degrees apart";
    return use.even ? text + ", radius " + short_number(radius) : text;
}

}  // namespace

std::string rule_name(const RuleSet& rules, const Part& part, const std::vector<RuleUse>& uses) {
    switch (rule_of(rules, part).kind) {
        case RuleKind::ring:
            return "Ring";
        case RuleKind::linear:
            if (rule_of(rules, part).upright) return comes_round(rule_of(rules, part), part.count) ? "Ring" : "Arc";
            return bends(rule_of(rules, part)) ? "Curve" : "Row";
        case RuleKind::family:
            return "Triangle";
        case RuleKind::spiral:
            return "Spiral";
        case RuleKind::group:
            return is_mirrored_whole(part) ? "Mirrored" : part.children.size() == 2 ? "Pair" : "Motif";
        case RuleKind::branch:
            return rule_of(rules, part).members.empty() ? "Fractal" : "Tree";
        case RuleKind::sequence:
            break;
    }
    return words_of(figure_of(rules, part, uses)).name;
}

std::string rule_comment(const RuleSet& rules, const Part& part, const std::vector<std::string>& names,
                         const std::vector<RuleUse>& uses) {
    const Rule& rule = rule_of(rules, part);
    const RuleUse& use = use_of(part, uses);
    if (rule.kind == RuleKind::group) return is_mirrored_whole(part) ? halves_comment(part, names) : group_comment(part, names);
    if (rule.kind == RuleKind::branch) return branch_comment(rules, part, names, use);
    const std::string& what = names[static_cast<std::size_t>(rule.repeated)];
    if (rule.kind == RuleKind::ring) return ring_comment(rules, part, what, use);
    if (rule.upright) return upright_comment(rules, part, what, use);
    if (rule.kind == RuleKind::linear) return linear_comment(rule, count_text(use) + " " + what);
    if (rule.kind == RuleKind::family) {
        const int first = rules.parts[static_cast<std::size_t>(part.children[0].part)].count;
        const int second = rules.parts[static_cast<std::size_t>(part.children[1].part)].count;
        return count_text(use) + " rows of " + std::to_string(first) + ", " + std::to_string(second) + " and so on";
    }
    if (rule.kind == RuleKind::spiral) {
        return "a spiral of " + count_text(use) + " " + what + ", each " +
               short_number(std::abs(degrees(rule.spiral.angle))) + " degrees on from the one before";
    }
    const Figure figure = figure_of(rules, part, uses);
    const bool two = figure == Figure::pair || figure == Figure::mirror_pair;
    return words_of(figure).phrase + (two ? "" : count_text(use) + " ") + what + sequence_numbers(rules, part, use, figure);
}

}  // namespace rinceau

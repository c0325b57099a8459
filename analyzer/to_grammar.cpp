#include "analyzer/to_grammar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "analyzer/anchors.h"
#include "analyzer/module_writer.h"
#include "analyzer/natural_pose.h"
#include "analyzer/rule_comment.h"
#include "analyzer/terminals.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

constexpr double natural_slack = 3;  // how many times the slack of a number a natural value may cost

class Writer {
  public:
    Writer(const OrderedRules& ordered, const Instancing& instancing, const Scene& scene, double slack)
        : rules_(ordered.rules),
          roots_(ordered.roots),
          instancing_(instancing),
          scene_(scene),
          slack_(slack),
          anchors_(find_anchors(ordered.rules, instancing, ordered.roots)) {}

    WrittenGrammar run() {
        name_symbols();
        written_.anchor_of_part = anchors_.of_part;
        written_.grammar.canvas = scene_.viewport;
        written_.grammar.sized = scene_.sized;
        write_axiom();
        // Top-down: what is made last stands first.
        std::set<int> written_rules;
        for (std::size_t p = rules_.parts.size(); p-- > 0;) {
            const Part& part = rules_.parts[p];
            if (part.rule < 0 || written_.symbol_of_part[p].empty()) continue;
            const bool own_production = kind_of(part) == RuleKind::linear;
            if (own_production || written_rules.insert(part.rule).second) write_production(static_cast<int>(p));
        }
        std::ranges::reverse(written_.grammar.constants);
        add_terminals(written_.grammar, instancing_, scene_, looks_, terminal_anchors(), 0.3 * slack_);
        for (const int root : roots_) {
            const std::vector<int> below = elements_below(rules_, root);
            written_.element_of_leaf.insert(written_.element_of_leaf.end(), below.begin(), below.end());
        }
        return std::move(written_);
    }

  private:
    RuleKind kind_of(const Part& part) const { return rules_.rules[static_cast<std::size_t>(part.rule)].kind; }
    const Similarity& anchor(int part) const { return anchors_.of_part[static_cast<std::size_t>(part)]; }
    double turtle_scale(int part) const { return std::max(anchors_.largest_scale[static_cast<std::size_t>(part)], 1e-12); }
    double extent(int part) const { return anchors_.extent[static_cast<std::size_t>(part)]; }
    const std::string& symbol(int part) const { return written_.symbol_of_part[static_cast<std::size_t>(part)]; }

    /// Terminals in order of the drawing, productions from the bottom up; what no root needs gets no name.
    void name_symbols() {
        written_.symbol_of_part.assign(rules_.parts.size(), "");
        std::vector<std::pair<int, int>> looks;  // (first element, look)
        std::vector<int> first(instancing_.looks.size(), -1);
        for (std::size_t e = instancing_.instances.size(); e-- > 0;) {
            first[static_cast<std::size_t>(instancing_.instances[e].look)] = static_cast<int>(e);
        }
        std::map<int, std::string> production_names;
        int productions = 0;
        for (std::size_t p = 0; p < rules_.parts.size(); ++p) {
            const Part& part = rules_.parts[p];
            if (!(anchors_.largest_scale[p] > 0)) continue;
            if (part.look >= 0) {
                looks.emplace_back(first[static_cast<std::size_t>(part.look)], part.look);
                continue;
            }
            std::string name;
            if (kind_of(part) != RuleKind::linear) name = production_names[part.rule];
            if (name.empty()) {
                name = "P" + std::to_string(productions++);
                if (kind_of(part) != RuleKind::linear) production_names[part.rule] = name;
            }
            written_.symbol_of_part[p] = name;
        }
        std::ranges::sort(looks);
        for (const auto& [unused, look] : looks) {
            written_.symbol_of_part[static_cast<std::size_t>(look)] = terminal_name(static_cast<int>(looks_.size()));
            looks_.push_back(look);
        }
    }

    std::vector<Similarity> terminal_anchors() {
        for (std::size_t look = 0; look < instancing_.looks.size(); ++look) {
            written_.terminal_anchor.push_back(anchors_.of_part[look]);  // the parts of looks come first, in their order
        }
        return written_.terminal_anchor;
    }

    /// The module that draws a part where the turtle stands: A, P2, P1(4) or P3(P3_count).
    ModuleTemplate module(int part) const {
        const Part& at = rules_.parts[static_cast<std::size_t>(part)];
        if (at.look >= 0 || kind_of(at) == RuleKind::group) return command(symbol(part));
        if (kind_of(at) == RuleKind::ring) return command(symbol(part), symbol(part) + "_count");
        return command(symbol(part), static_cast<double>(at.count));
    }

    /// Slack for one move at turtle scale `scale` that is followed by things reaching out to `reach` turtle units and that
    /// is made `times` times in a row.
    MoveSlack move_slack(double scale, double advance, double reach, int times) const {
        const double length = slack_ / scale / times;
        MoveSlack slack;
        slack.length = length;
        slack.turn = length / std::max(times * advance + reach, 1e-12);
        slack.spin = length / std::max((times - 1) * advance + reach, 1e-12);
        slack.scale = slack.spin;
        return slack;
    }

    /// "[" move, module "]" for a part at a pose in the frame of a turtle at scale `scale`.
    void append_placed(std::vector<ModuleTemplate>& modules, const Similarity& wanted, int part, double scale,
                       bool brackets) {
        std::vector<ModuleTemplate> placed;
        Similarity pose = wanted;
        if (rules_.parts[static_cast<std::size_t>(part)].symmetry.continuous) {  // any angle draws the same
            pose.linear = {scale_of(pose), 0};
            pose.mirrored = false;
            if (abs(pose.translation) > 0)
                pose.linear = pose.linear * (pose.translation / abs(pose.translation)) * Complex{0, -1};
        }
        append_move(placed, pose, move_slack(scale, abs(pose.translation), extent(part) * scale_of(pose), 1));
        placed.push_back(module(part));
        if (brackets) placed = bracketed(std::move(placed));
        modules.insert(modules.end(), placed.begin(), placed.end());
    }

    void write_axiom() {
        for (const int root : roots_) {
            const Item& item = rules_.items[static_cast<std::size_t>(root)];
            const Similarity pose = natural_pose(rules_, root, anchor(item.part), natural_slack * slack_);
            append_placed(written_.grammar.axiom, pose * anchor(item.part), item.part, 1, roots_.size() > 1);
        }
    }

    void write_production(int p) {
        const Part& part = rules_.parts[static_cast<std::size_t>(p)];
        const Rule& rule = rules_.rules[static_cast<std::size_t>(part.rule)];
        Production production;
        production.symbol = symbol(p);
        production.comment = rule_comment(rules_, part, written_.symbol_of_part, longest_count(part.rule));
        if (rule.kind == RuleKind::group) {
            production.successor = group_body(p);
        } else {
            production.parameters = {"m"};
            production.condition = parse_expression("m > 0");
            if (rule.kind == RuleKind::ring) {
                production.successor = ring_body(p);
            } else if (rule.kind == RuleKind::linear) {
                production.successor = linear_body(p);
            } else {
                production.successor = sequence_body(p);
            }
            production.successor.push_back(command(symbol(p), std::string("m-1")));
        }
        written_.grammar.productions.push_back(std::move(production));
    }

    int longest_count(int rule) const {
        int longest = 0;
        for (std::size_t p = 0; p < rules_.parts.size(); ++p) {
            if (rules_.parts[p].rule == rule && !written_.symbol_of_part[p].empty()) {
                longest = std::max(longest, rules_.parts[p].count);
            }
        }
        return longest;
    }

    double largest_scale_of_rule(int rule) const {
        double largest = 0;
        for (std::size_t p = 0; p < rules_.parts.size(); ++p) {
            if (rules_.parts[p].rule == rule) largest = std::max(largest, anchors_.largest_scale[p]);
        }
        return std::max(largest, 1e-12);
    }

    std::vector<ModuleTemplate> group_body(int p) {
        const Part& part = rules_.parts[static_cast<std::size_t>(p)];
        std::vector<ModuleTemplate> body;
        const Similarity to_turtle = inverse(anchor(p));
        for (const Child& child : part.children) {
            append_placed(body, to_turtle * child.pose * anchor(child.part), child.part, turtle_scale(p), true);
        }
        return body;
    }

    std::vector<ModuleTemplate> sequence_body(int p) {
        const Part& part = rules_.parts[static_cast<std::size_t>(p)];
        const Rule& rule = rules_.rules[static_cast<std::size_t>(part.rule)];
        const Similarity& head = anchor(rule.repeated);
        const Similarity step = inverse(head) * rule.step * head;
        std::vector<ModuleTemplate> body = bracketed({module(rule.repeated)});
        // A growing chain ends larger than it begins.
        const int count = longest_count(part.rule);
        const double growth = std::max(1.0, std::pow(scale_of(step), count - 1));
        append_move(body, step,
                    move_slack(largest_scale_of_rule(part.rule) * growth, abs(step.translation), extent(rule.repeated),
                               std::max(1, count - 1)));
        return body;
    }

    std::vector<ModuleTemplate> ring_body(int p) {
        const Part& part = rules_.parts[static_cast<std::size_t>(p)];
        const Rule& rule = rules_.rules[static_cast<std::size_t>(part.rule)];
        const std::string count_name = symbol(p) + "_count";
        written_.grammar.constants.push_back({count_name, number_expression(part.count), ""});
        std::vector<ModuleTemplate> body;
        const Similarity first = inverse(anchor(p)) * part.children.front().pose * anchor(rule.repeated);
        append_placed(body, first, rule.repeated, turtle_scale(p), true);
        const int turns = static_cast<int>(std::lround(arg(rule.step.linear) * part.count / two_pi));
        const std::string angle = std::to_string(360 * std::abs(turns)) + "/" + count_name;
        body.push_back(command(turns > 0 ? "+" : "-", angle));
        return body;
    }

    /// t(m) = t0 + tDelta m with m counting down from the number of repetitions.
    std::vector<ModuleTemplate> linear_body(int p) {
        const Part& part = rules_.parts[static_cast<std::size_t>(p)];
        const Rule& rule = rules_.rules[static_cast<std::size_t>(part.rule)];
        // Turned and scaled like the member's turtle but about the member's own origin, so that alpha and beta stay linear.
        const Similarity upright{anchor(rule.repeated).linear, {}, anchor(rule.repeated).mirrored};
        const TurtleStep first = to_turtle_step(inverse(upright) * rule.step * upright);
        const double sense = upright.mirrored ? -1 : 1;
        const double turn_change = -degrees(sense * rule.turn_change), spin_change = -degrees(sense * rule.spin_change);
        std::vector<ModuleTemplate> body;
        append_placed(body, inverse(upright) * anchor(rule.repeated), rule.repeated, turtle_scale(p), true);
        const MoveSlack slack = move_slack(turtle_scale(p), first.advance, extent(rule.repeated), part.count);
        const auto growing = [&](double at_first, double change, double angle_slack) {
            const double fine = tidy(change, degrees(angle_slack) / part.count);
            const double start = tidy(degrees(at_first) - change * part.count, degrees(angle_slack));
            const std::string product = to_text(number_expression(std::abs(fine))) + "*m";
            return to_text(number_expression(start)) + (fine < 0 ? " - " : " + ") + product;
        };
        body.push_back(command("+", growing(first.turn, turn_change, slack.turn)));
        body.push_back(command("f", tidy(first.advance, slack.length)));
        if (std::abs(first.scale - 1) > slack.scale) body.push_back(command("*", tidy(first.scale, slack.scale)));
        body.push_back(command("+", growing(first.spin, spin_change, slack.spin)));
        return body;
    }

    const RuleSet& rules_;
    const std::vector<int>& roots_;
    const Instancing& instancing_;
    const Scene& scene_;
    double slack_;
    Anchors anchors_;
    std::vector<int> looks_;
    WrittenGrammar written_;
};

}  // namespace

WrittenGrammar to_grammar(const OrderedRules& ordered, const Instancing& instancing, const Scene& scene, double slack) {
    return Writer(ordered, instancing, scene, slack).run();
}

}  // namespace rinceau

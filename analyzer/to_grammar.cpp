#include "analyzer/to_grammar.h"

#include <algorithm>
#include <set>

#include "analyzer/anchors.h"
#include "analyzer/lone_stacks.h"
#include "analyzer/natural_pose.h"
#include "analyzer/production_writer.h"
#include "analyzer/symbol_names.h"
#include "analyzer/terminals.h"

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
          anchors_(find_anchors(ordered.rules, instancing, ordered.roots)),
          uses_(rule_uses(ordered.rules, ordered.roots)),
          top_down_(parts_top_down(ordered.rules, ordered.roots)),
          stacks_(lone_stacks(ordered.rules, ordered.roots, slack)) {}

    WrittenGrammar run() {
        const std::vector<std::string> names = look_names(instancing_, scene_);
        name_symbols(names);
        written_.anchor_of_part = anchors_.of_part;
        written_.grammar.canvas = scene_.viewport;
        written_.grammar.sized = scene_.sized;
        write_axiom();
        std::set<int> written_rules;
        for (const int p : top_down_) {
            const Part& part = rules_.parts[static_cast<std::size_t>(p)];
            if (written_.symbol_of_part[static_cast<std::size_t>(p)].empty()) continue;
            const bool own_production = kind_of(part) == RuleKind::linear;
            if (own_production || written_rules.insert(part.rule).second) write_production(p);
        }
        add_terminals(written_.grammar, instancing_, scene_, looks_, names, terminal_anchors(), 0.3 * slack_);
        for (const int root : roots_) {
            const std::vector<int> below = elements_below(rules_, root);
            written_.element_of_leaf.insert(written_.element_of_leaf.end(), below.begin(), below.end());
        }
        return std::move(written_);
    }

  private:
    RuleKind kind_of(const Part& part) const { return rules_.rules[static_cast<std::size_t>(part.rule)].kind; }
    const Similarity& anchor(int part) const { return anchors_.of_part[static_cast<std::size_t>(part)]; }

    /// What no root needs gets no name, nor what only the axiom would use once. Looks stand in order of the drawing.
    void name_symbols(const std::vector<std::string>& names) {
        std::vector<bool> in_use;
        for (std::size_t p = 0; p < rules_.parts.size(); ++p) in_use.push_back(anchors_.largest_scale[p] > 0 && !stacks_[p]);
        written_.symbol_of_part = symbol_names(rules_, in_use, top_down_, uses_, names);
        for (std::size_t p = 0; p < rules_.parts.size(); ++p) {
            if (rules_.parts[p].look >= 0 && in_use[p]) looks_.push_back(rules_.parts[p].look);
        }
    }

    std::vector<Similarity> terminal_anchors() {
        for (std::size_t look = 0; look < instancing_.looks.size(); ++look) {
            written_.terminal_anchor.push_back(anchors_.of_part[look]);  // the parts of looks come first, in their order
        }
        return written_.terminal_anchor;
    }

    WritingContext context() const { return {rules_, anchors_, written_.symbol_of_part, uses_, slack_}; }

    void write_axiom() {
        int number = 0;  // of a root's symbol
        for (const int root : roots_) {
            const Item& item = rules_.items[static_cast<std::size_t>(root)];
            if (stacks_[static_cast<std::size_t>(item.part)]) {
                write_stack(item);
                number += static_cast<int>(item.members.size());
                continue;
            }
            const Similarity pose = natural_pose(rules_, root, anchor(item.part), natural_slack * slack_);
            append_placed(context(), written_.grammar.axiom, pose * anchor(item.part), item.part, 1, roots_.size() > 1);
            for (Exception& exception : write_exceptions(context(), root, ++number, pose)) {
                written_.grammar.exceptions.push_back(std::move(exception));
            }
        }
    }

    /// All copies at the place of the first: [f(30) [A] [A]]
    void write_stack(const Item& item) {
        const int member = item.members.front();
        const int part = rules_.items[static_cast<std::size_t>(member)].part;
        const Similarity pose = natural_pose(rules_, member, anchor(part), natural_slack * slack_);
        std::vector<ModuleTemplate> placed;
        append_placed(context(), placed, pose * anchor(part), part, 1, false);
        const std::vector<ModuleTemplate> copy = bracketed({placed.back()});
        placed.pop_back();
        for (std::size_t k = 0; k < item.members.size(); ++k) placed.insert(placed.end(), copy.begin(), copy.end());
        if (roots_.size() > 1) placed = bracketed(std::move(placed));
        written_.grammar.axiom.insert(written_.grammar.axiom.end(), placed.begin(), placed.end());
    }

    void write_production(int p) {
        WrittenRule rule = write_rule(context(), p);
        for (Production& production : rule.productions) written_.grammar.productions.push_back(std::move(production));
        for (Constant& constant : rule.constants) written_.grammar.constants.push_back(std::move(constant));
    }

    const RuleSet& rules_;
    const std::vector<int>& roots_;
    const Instancing& instancing_;
    const Scene& scene_;
    double slack_;
    Anchors anchors_;
    std::vector<RuleUse> uses_;
    std::vector<int> top_down_;
    std::vector<bool> stacks_;  ///< by part
    std::vector<int> looks_;
    WrittenGrammar written_;
};

}  // namespace

WrittenGrammar to_grammar(const OrderedRules& ordered, const Instancing& instancing, const Scene& scene, double slack) {
    return Writer(ordered, instancing, scene, slack).run();
}

}  // namespace rinceau

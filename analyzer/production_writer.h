#pragma once
// What the writers of productions share, and one writer for each kind of rule (docs/analysis.md, 7).

#include <string>
#include <vector>

#include "analyzer/anchors.h"
#include "analyzer/module_writer.h"
#include "analyzer/rule_use.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// The rules to be written, with names and frames. Outlives the writing; `slack` is a scene length: how far rounding a number
/// may move what follows it.
struct WritingContext {
    const RuleSet& rules;
    const Anchors& anchors;
    const std::vector<std::string>& symbols;  ///< by part; "" = not in use
    const std::vector<RuleUse>& uses;         ///< by rule
    double slack = 0;

    const Part& part(int p) const { return rules.parts[static_cast<std::size_t>(p)]; }
    const Rule& rule_of(int p) const { return rules.rules[static_cast<std::size_t>(part(p).rule)]; }
    const std::string& symbol(int p) const { return symbols[static_cast<std::size_t>(p)]; }
    /// Turtle frame of the part's module -> part frame.
    const Similarity& anchor(int p) const { return anchors.of_part[static_cast<std::size_t>(p)]; }
    /// Radius of the part in turtle units.
    double extent(int p) const { return anchors.extent[static_cast<std::size_t>(p)]; }
    /// Largest scale of a turtle at the part's modules.
    double turtle_scale(int p) const;
    double largest_scale_of_rule(int rule) const;
    /// Largest count among the parts of a rule that are in use.
    int longest_count(int rule) const;
};

/// What one rule needs in the grammar.
struct WrittenRule {
    std::vector<Production> productions;  ///< of one symbol; the first carries the comment
    std::vector<Constant> constants;
};

/// The module that draws a part where the turtle stands: A, Motif, Row(4) or Ring(Ring_count).
ModuleTemplate module_of(const WritingContext& context, int part);

/// Slack for one move at turtle scale `scale` that is followed by things reaching out to `reach` turtle units and that is
/// made `times` times in a row.
MoveSlack move_slack(const WritingContext& context, double scale, double advance, double reach, int times);

/// Of the symmetries of a terminal the one that, before its anchor, turns it least when it is drawn at `pose`, unmirrored if
/// there is one; the identity for parts that are not turnable.
Similarity least_turning_gauge(const WritingContext& context, const Similarity& pose, int part);

/// [move, module] for a part at a pose in the frame of a turtle at scale `scale`, turned by its gauge; in brackets if
/// asked for.
void append_placed(const WritingContext& context, std::vector<ModuleTemplate>& modules, const Similarity& pose, int part,
                   double scale, bool brackets);

/// P(m) : m > 0 -> with the comment and the modules before the call of itself.
Production counted_production(const WritingContext& context, int part);

/// P -> [T1 A] [T2 B] ..
WrittenRule write_group(const WritingContext& context, int part);
/// P(m) : m > 0 -> [A] T P(m-1)                                    (r1)
WrittenRule write_sequence(const WritingContext& context, int part);
/// P(m) : m > 0 -> [f(r) A] +(360/P_count) P(m-1), about the pivot
WrittenRule write_ring(const WritingContext& context, int part);
/// P(m) : m > 0 -> [A] T(t0 + tDelta m) P(m-1)                     (r1 with eq. 4)
WrittenRule write_linear(const WritingContext& context, int part);
/// P(m) : m > 0 -> [f(r) +(360/P_count*m) A] +(360/P_count) P(m-1), about the middle: members that keep their heading
WrittenRule write_upright(const WritingContext& context, int part);
/// R(m) : m > 0 -> [A] [T1 R(m-1)] .. [Tk R(m-1)], R(m) : m == 0 -> [B]   (r3, r4)
WrittenRule write_branch(const WritingContext& context, int part);

/// What is missing below a root, and what stands in for something: the root is the axiom's symbol `number`, from 1, and its
/// part stands at `pose` in the scene.
std::vector<Exception> write_exceptions(const WritingContext& context, int root, int number, const Similarity& pose);

/// P(m) : m > 0 -> P(m-1) [+(a*m) f(c*m^p) *(s) A], about the pivot; P(m-1) stands last if the first member is the outermost
WrittenRule write_spiral(const WritingContext& context, int part);

/// Q(k) : k > 0 -> [P(k)] T Q(k-1); Q(k-1) stands first if the rows get longer
WrittenRule write_family(const WritingContext& context, int part);

/// The productions of a part's rule, by its kind.
WrittenRule write_rule(const WritingContext& context, int part);

}  // namespace rinceau

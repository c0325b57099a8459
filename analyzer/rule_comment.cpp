#include "analyzer/rule_comment.h"

#include <cmath>

#include "lsystem/turtle_step.h"

namespace rinceau {

std::string kind_name(RuleKind kind) {
    switch (kind) {
        case RuleKind::sequence:
            return "sequence";
        case RuleKind::ring:
            return "ring";
        case RuleKind::linear:
            return "linear";
        case RuleKind::group:
            return "group";
    }
    return "";
}

namespace {

std::string sequence_word(const Similarity& step) {
    constexpr double visible = 1e-4;  // radians, relative scale, sizes
    const bool moves = abs(step.translation) > visible;
    const bool turns = std::abs(arg(step.linear)) > visible;
    const bool grows = std::abs(scale_of(step) - 1) > visible;
    if (step.mirrored) return moves ? "alternating row" : "mirrored pair";
    if (!moves) return grows ? "nest" : turns ? "fan" : "stack";
    if (turns) return grows ? "spiral" : "arc";
    return grows ? "tapering row" : "row";
}

}  // namespace

std::string rule_comment(const RuleSet& rules, const Part& part, const std::vector<std::string>& names, int longest) {
    const Rule& rule = rules.rules[static_cast<std::size_t>(part.rule)];
    if (rule.kind == RuleKind::group) {
        std::string text;
        for (std::size_t k = 0; k < part.children.size(); ++k) {
            if (k > 0) text += k + 1 == part.children.size() ? " and " : ", ";
            text += names[static_cast<std::size_t>(part.children[k].part)];
        }
        return text + " together";
    }
    const std::string& what = names[static_cast<std::size_t>(rule.repeated)];
    const std::string count = std::to_string(longest);
    if (rule.kind == RuleKind::ring) return "ring of " + count + " " + what;
    if (rule.kind == RuleKind::linear) return "curve of " + count + " " + what + ", turning more and more";
    return sequence_word(rule.step) + " of " + count + " " + what;
}

}  // namespace rinceau
